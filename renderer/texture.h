// SPDX-License-Identifier: Apache-2.0
//
// Images that scenes refer to.

#pragma once

#include "wellstrat/vector.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace wellstrat::render {

/// A picture in linear colors. Immutable, so safe in any thread.
class Texture {
public:
    /// Pixels row by row, the top row first: width * height of them, finite and not negative.
    /// Throws std::invalid_argument for another number of them, or none.
    Texture(unsigned width, unsigned height, std::vector<Float3> pixels);

    unsigned width() const { return width_; }
    unsigned height() const { return height_; }

    const std::vector<Float3>& pixels() const { return pixels_; }

    /// The color of a pixel; not checked.
    Float3 pixel(unsigned x, unsigned y) const { return pixels_[std::size_t{y} * width_ + x]; }

    /// Bilinear. (0, 0) is the left end of the top row, as in glTF; repeats outside [0, 1). `uv`
    /// must be finite.
    Float3 lookup(Float2 uv) const;

private:
    unsigned width_, height_;
    std::vector<Float3> pixels_;
};

enum class Encoding { linear, sRgb };

/// Reads a picture in any format that OpenImageIO knows, of at most 2^27 pixels. Alpha is left out,
/// values that are NaN, infinite or negative become 0 and those above 1e9 become 1e9; the number of
/// such pixels is added to `*replaced` unless that is null. `encoding` is that of integers: formats
/// of floats are linear. Throws std::runtime_error with one line that says why the picture cannot
/// be read.
Texture readTexture(const std::string& path, Encoding encoding, uint64_t* replaced = nullptr);

/// The same from the bytes of a file in memory, such as one within a .glb. `formatHint` is the
/// file name extension that it would have.
Texture readTexture(const std::vector<unsigned char>& bytes, const std::string& formatHint,
                    Encoding encoding);

/// From now on this process reads pictures without helping threads. For a copy of a process, which
/// lacks the threads that libraries believe to have.
void readTexturesInOneThread();

} // namespace wellstrat::render
