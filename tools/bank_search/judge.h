// SPDX-License-Identifier: Apache-2.0
//
// The error of pairs of slots for products of two integrands, as a ratio to that of padding. No
// sample is drawn; as exact as integrand_levels.h knows the integrands.

#pragma once

#include "bank_search/integrand_levels.h"
#include "bank_search/slot_order.h"

#include <array>
#include <vector>

namespace wellstrat::bank {

class Judge {
public:
    /// Judges up to 2^digits points; `digits` is at most kDigits.
    explicit Judge(std::vector<JudgedIntegrand> integrands, unsigned digits = kDigits);

    const std::vector<JudgedIntegrand>& integrands() const { return integrands_; }

    /// The ratios of root mean squared errors for all products f(one slot) g(other slot), f and g
    /// being integrands: at f * integrands().size() + g. Any thread.
    std::vector<ByDigits> ratios(const Columns& one, const Columns& other) const;

    /// What the root mean square of the ratios for f(slot) f(other slot) over all pairs of so many
    /// slots is at least, for any matrices: the bank can only share out what a slot loses against
    /// itself. docs/joint.md has the proof. At least 2 slots.
    ByDigits floor(std::size_t f, std::size_t slots) const;

private:
    std::vector<JudgedIntegrand> integrands_;
    unsigned digits_;
    std::vector<ByDigits> alone_;  ///< sums of f's covariances over n < 2^m
    std::vector<ByDigits> padded_; ///< variances of products
};

} // namespace wellstrat::bank
