// SPDX-License-Identifier: Apache-2.0
//
// The Walsh-Hadamard transform, which turns sums over i of f(i) g(i XOR c), for all c at once, into
// products.

#pragma once

#include <cstddef>
#include <vector>

namespace wellstrat::bank {

/// In place; the size is a power of two. Twice gives the size times the original.
template <typename Real>
void walshTransform(std::vector<Real>& values) {
    const std::size_t size = values.size();
    std::size_t half = 1;
    if (size >= 4) { // two steps at once
        for (std::size_t i = 0; i < size; i += 4) {
            Real* const v = values.data() + i;
            const Real a = v[0] + v[1], b = v[0] - v[1], c = v[2] + v[3], d = v[2] - v[3];
            v[0] = a + c;
            v[1] = b + d;
            v[2] = a - c;
            v[3] = b - d;
        }
        half = 4;
    }
    for (; half < size; half *= 2) {
        for (std::size_t block = 0; block < size; block += 2 * half) {
            Real* low = values.data() + block;
            Real* high = low + half;
            for (std::size_t i = 0; i < half; ++i) {
                const Real sum = low[i] + high[i];
                high[i] = low[i] - high[i];
                low[i] = sum;
            }
        }
    }
}

} // namespace wellstrat::bank
