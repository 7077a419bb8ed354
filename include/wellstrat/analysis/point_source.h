// SPDX-License-Identifier: Apache-2.0
//
// Where the points of a study come from: one small interface for our generators and all others.
//
//     name          pattern p is                                       domains after the first
//     sobol         Sobol' points, the same for every p                order shuffled
//     sobol-shift   with a random digital shift                        and order shuffled
//     sobol-owen    with exact Owen scrambling (owen.h)                and order shuffled
//     long-words    samples of long.h with all of their 32 bits        as NewDomain derives them
//     halton        Halton points, shifted at random modulo 1          further prime bases
//     jitter        one random point in each of N equal cells          order shuffled at random
//
// "Order shuffled" is the exact nested shuffle: Owen's scrambling of the index, all levels.

#pragma once

#include "wellstrat/analysis/integrands.h"
#include "wellstrat/generator.h"
#include "wellstrat/platform.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace wellstrat {
inline namespace stream1 {

/// A family of randomized point sequences, or of point sets. Immutable; all functions may be called
/// in several threads at once.
class WELLSTRAT_API PointSource {
public:
    virtual ~PointSource();

    /// Writes points [0, count) of pattern `pattern` to points[0, count * totalDims(domains)),
    /// point after point, all coordinates in [0, 1). A pure function of its arguments. Domains are
    /// independent uses of the generator for the same sample.
    virtual void draw(uint32_t pattern, const DomainDims& domains, std::size_t count,
                      double* points) const = 0;

    /// Whether the first n of `count` points are the points of a draw of n. If not, a study draws
    /// anew for each number of points.
    virtual bool isProgressive() const { return true; }

    /// Throws std::invalid_argument, which says what is accepted, if draws of these domains, of
    /// this many points, or of patterns [0, patterns) are impossible. Accepts all here.
    virtual void check(const DomainDims& domains, std::size_t count, uint64_t patterns) const;
};

using PointSourcePtr = std::unique_ptr<const PointSource>;

/// The samples that a RixRNG with `generator` draws, null for the tables: domain d of pattern p is
/// {p, 0}.NewDomain(d). The generator must outlive the source.
WELLSTRAT_API PointSourcePtr generatorSource(const Generator* generator);

/// The samples of slots (joint.h), of the tables or of another generator that has slots: domain d
/// of pattern p is {p, 0}.NewDomain(jointScramble(slots[d])), drawn from this slot; domains beyond
/// `slots` are those of generatorSource(generator). Without any slots, all of them: 0, 1, 2, ...
/// Throws std::invalid_argument for a slot that there is not or that comes twice. The generator, if
/// there is one, must outlive the source.
WELLSTRAT_API PointSourcePtr jointSource(const std::vector<unsigned>& slots = {},
                                         const Generator* generator = nullptr);

/// The same of LongProgressive by sequenceBits, as (bits + 0.5) * 2^-32: for errors below 1e-7, in
/// which samples of generatorSource show that floats are cut.
WELLSTRAT_API PointSourcePtr sequenceSource();

/// What is done to the points of Sobol' for each pattern. All but `none` have numbers of 32 bits v
/// as (v + 0.5) * 2^-32, so that no mean is biased.
enum class SobolRandomization { none, digitalShift, owen };
WELLSTRAT_API PointSourcePtr sobolSource(SobolRandomization randomization);

/// Halton 1960, "On the efficiency of certain quasi-random sequences", in the first 15 prime bases,
/// with the shift of Cranley and Patterson 1976.
WELLSTRAT_API PointSourcePtr haltonSource();

/// For any number of points: an axis is cut into slabs for about count^(1/s) points each way, a
/// slab as wide as its share of the points, and each slab again along the next axis.
WELLSTRAT_API PointSourcePtr jitteredSource();

} // namespace stream1
} // namespace wellstrat
