// SPDX-License-Identifier: Apache-2.0
//
// The best slot beside given ones: a beam search, column after column. For one column all 2^k
// candidates are judged at once, since what a candidate c adds to a pair's error is a convolution,
//
//     sum over n in [2^k, 2^(k+1)) of F(U n) G(V n)
//         = sum over t < 2^k of F(2^k + (t XOR c)) G(V (2^k + U^-1 t)).

#pragma once

#include "bank_search/merit.h"

#include <random>
#include <vector>

namespace wellstrat::bank {

using Bank = std::vector<Columns>;

struct BeamOptions {
    unsigned width = 2; ///< at the last column
    /// Candidates' prices are multiplied by up to 1 + this, at random, so that a slot that was
    /// taken out need not come back.
    float disorder = 0;
};

/// What all prices of the pairs and triples that contain the slot `number` of `bank` add up to.
double slotPrice(const Bank& bank, std::size_t number);

/// The slot `number`, in [0, 16), with the lowest price beside `others` that the search finds. The
/// same bits on every machine for the same state of `random`.
///
/// The first binary digits of x and y are prescribed, as the search by itself gets stuck there: no
/// two slots have, in their first 64 points, the same first digit in x or in y or the same sum of
/// both. Let a and b be the lower and the upper two bits of the number as elements of GF(4), and w
/// a root of w^2 = w + 1. As a function of the index bits 0 to 5, the sum is (0, 1, a + 3, b + 3)
/// and the digit of x (1, 0, w a + b, w b). So all sums differ, and all digits of x; all digits of
/// y too, as (w + 1) a + b and (w + 1) b differ. The slots 0 to 3 do so in the first 16 points, in
/// which no two slots at all have the same digits in x and y.
Columns bestSlot(const Bank& others, unsigned number, const BeamOptions& options,
                 std::mt19937& random);

} // namespace wellstrat::bank
