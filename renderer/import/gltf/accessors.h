// SPDX-License-Identifier: Apache-2.0
//
// The numbers of a glTF file.

#pragma once

#include "document.h"

#include "wellstrat/vector.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace wellstrat::render {

/// All numbers of an accessor, element by element: of normalized integers the fractions that they
/// stand for, of others the integers. Sparse values are in their places.
struct Numbers {
    std::vector<float> values; ///< count * components
    std::size_t components = 0;

    std::size_t count() const { return values.size() / components; }

    /// Element i; components that it lacks are `otherwise`, those beyond `N` are left out.
    template <std::size_t N>
    std::array<float, N> element(std::size_t i, float otherwise = 0) const {
        std::array<float, N> result{};
        for (std::size_t c = 0; c < N; ++c)
            result[c] = c < components ? values[i * components + c] : otherwise;
        return result;
    }
    Float2 float2(std::size_t i) const {
        const auto v = element<2>(i);
        return {v[0], v[1]};
    }
    Float3 float3(std::size_t i) const {
        const auto v = element<3>(i);
        return {v[0], v[1], v[2]};
    }
};

/// Throws std::runtime_error with one line if there is no such accessor, or it does not fit into
/// what it refers to.
Numbers readNumbers(const GltfDocument& document, int accessor);

/// The same of unsigned integers. Throws for others, too.
std::vector<uint32_t> readIndices(const GltfDocument& document, int accessor);

} // namespace wellstrat::render
