// SPDX-License-Identifier: Apache-2.0
//
// Sample contexts, and how the pattern of a new domain follows from its parent's.
//
// A context names one sample: `patternid` the randomised sequence, `sampleid` the position in it.
// A domain is one use of samples (lens, light choice, a bxdf lobe, ...); every domain of every
// pixel needs a pattern of its own, or two uses are correlated and the image does not converge.

#pragma once

#include "wellstrat/hash.h"

#include <type_traits>

namespace wellstrat {
inline namespace stream1 {

namespace detail {

/// Keeps the keys of sampleids, in distribution, apart from scrambles: "dist" in ASCII.
constexpr uint32_t kDistribKey = 0x64697374u;

} // namespace detail

/// The constant that tells a new domain from its siblings. Any 32-bit value, but a different one
/// for each domain that is derived from the same parent. A type of its own, so that the compiler
/// catches a sample count or an index in its place.
enum class Scramble : unsigned int {};

/// The pattern of the domain `scramble` under `patternid`. For a fixed scramble a bijection of the
/// pattern, so that patterns that differ stay different along any path of domains; full avalanche
/// in both arguments.
WELLSTRAT_HOST_DEVICE constexpr unsigned derivePattern(unsigned patternid, Scramble scramble) {
    return permuteBits(patternid, permutationKey(static_cast<unsigned>(scramble)));
}

/// Names one sample. 8 bytes; copy it freely. The functions return new contexts and leave this one
/// as it is; all are pure and safe in any thread.
struct SampleCtx {
    unsigned patternid;
    unsigned sampleid;

    /// The context of a new domain that visits its samples as this one does: another pattern, the
    /// same sampleid. Equal scrambles give equal domains.
    WELLSTRAT_HOST_DEVICE constexpr SampleCtx NewDomain(Scramble scramble) const {
        return {derivePattern(patternid, scramble), sampleid};
    }

    /// Distribution: a new domain for this very sample, independent of the domains of all other
    /// samples, starting at `newsampleid` (usually 0). For when the number of samples to come
    /// differs from visit to visit. They are stratified among themselves only.
    WELLSTRAT_HOST_DEVICE constexpr SampleCtx NewDomainDistrib(Scramble scramble,
                                                               unsigned newsampleid) const {
        const unsigned domain = derivePattern(patternid, scramble);
        return {permuteBits(domain, permutationKey(sampleid ^ detail::kDistribKey)), newsampleid};
    }

    /// Splitting: a new domain in which each visit takes exactly `newnumsamples` consecutive
    /// samples, so that all visits together use up one sequence. Starts at
    /// sampleid * newnumsamples, modulo 2^32. With 1 it is NewDomain(scramble); with 0 every visit
    /// starts at sample 0.
    WELLSTRAT_HOST_DEVICE constexpr SampleCtx NewDomainSplit(Scramble scramble,
                                                             unsigned newnumsamples) const {
        return {derivePattern(patternid, scramble), sampleid * newnumsamples};
    }
};

static_assert(sizeof(SampleCtx) == 8 && std::is_trivially_copyable<SampleCtx>::value &&
                  std::is_trivially_default_constructible<SampleCtx>::value,
              "renderers keep one per shading point and copy it as bytes");

} // namespace stream1
} // namespace wellstrat
