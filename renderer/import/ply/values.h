// SPDX-License-Identifier: Apache-2.0
//
// The values that follow the header of a PLY file, one after another.

#pragma once

#include "header.h"

#include <cstddef>
#include <string_view>

namespace wellstrat::render {

class PlyValues {
public:
    /// `bytes`, which must outlive this, are those behind the header.
    PlyValues(std::string_view bytes, PlyFormat format) : bytes_(bytes), format_(format) {}

    /// The next value; NaN for a word that is no number. Throws std::runtime_error at the end.
    double next(PlyType type);

    /// The next value as the length of a list. Throws std::runtime_error if it is none, or more
    /// than there can be.
    std::size_t nextLength(PlyType type);

    /// Not less than how many values there still are.
    std::size_t most() const { return bytes_.size() - position_; }

private:
    double nextWord();
    template <typename T>
    double nextBinary();

    std::string_view bytes_;
    PlyFormat format_;
    std::size_t position_ = 0;
};

} // namespace wellstrat::render
