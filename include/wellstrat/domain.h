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

/// The inverse of an odd number modulo 2^32, by Newton's iteration: an odd number is its own in 3
/// bits, and each step doubles them.
WELLSTRAT_HOST_DEVICE constexpr uint32_t oddInverse(uint32_t odd) {
    uint32_t inverse = odd;
    for (int bits = 3; bits < 32; bits *= 2) inverse *= 2u - odd * inverse;
    return inverse;
}

} // namespace detail

/// The constant that tells a new domain from its siblings. Any 32-bit value, but a different one
/// for each domain that is derived from the same parent. A type of its own, so that the compiler
/// catches a sample count or an index in its place.
enum class Scramble : unsigned int {};

/// The words that `derivePattern` needs of a scramble, two hashes of it, which compilers know when
/// they know the scramble. The multiplier is odd.
struct DerivationKey {
    uint32_t mask, multiplier;
};

WELLSTRAT_HOST_DEVICE constexpr DerivationKey derivationKey(Scramble scramble) {
    const uint32_t mask = mixBits(static_cast<uint32_t>(scramble) + detail::kGolden);
    return {mask, (mixBits(mask + detail::kGolden) & ~7u) | 5u};
}

WELLSTRAT_HOST_DEVICE constexpr uint32_t derivePattern(uint32_t patternid, DerivationKey key) {
    return (patternid ^ key.mask) * key.multiplier;
}

/// The pattern of the domain `scramble` under `patternid`. For a fixed scramble a bijection of the
/// pattern, so that patterns that differ stay different along any path of domains, and two domains
/// share no more patterns than random sets do. It mixes little; the hash of the draw does that
/// (patternSeed in lookup.h, and random.h). Multiplying after an exclusive-or makes it matter in
/// which order scrambles come (docs/decisions/0013-cheaper-draws.md).
WELLSTRAT_HOST_DEVICE constexpr unsigned derivePattern(unsigned patternid, Scramble scramble) {
    return derivePattern(patternid, derivationKey(scramble));
}

/// The pattern of which derivePattern(., scramble) is `patternid`. For tests and tools.
WELLSTRAT_HOST_DEVICE constexpr unsigned parentPattern(unsigned patternid, Scramble scramble) {
    const DerivationKey key = derivationKey(scramble);
    const uint32_t inverse = detail::oddInverse(key.multiplier);
    return (patternid * inverse) ^ key.mask;
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
