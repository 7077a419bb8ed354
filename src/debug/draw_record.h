// SPDX-License-Identifier: Apache-2.0
//
// Which samples were drawn, and how often.

#pragma once

#include "debug/derivation.h"

#include <cstdint>
#include <unordered_map>
#include <vector>

namespace wellstrat {
inline namespace stream1 {
namespace detail {

/// How often (x, y) and z of a sample were drawn. A 3D draw takes both.
struct DrawCounts {
    uint32_t xy = 0, z = 0;
};

class DrawRecord {
public:
    /// Adds one draw of the sample of `context`, by `domain`.
    void add(const Derivation& domain, SampleCtx context, DrawCounts counts) {
        if (domains_.size() <= domain.number) domains_.resize(domain.number + 1);
        DrawCounts& drawn = domains_[domain.number][key(context)];
        drawn.xy += counts.xy;
        drawn.z += counts.z;
        ++draws_;
    }

    uint64_t draws() const { return draws_; }
    std::size_t domains() const {
        std::size_t drawn = 0;
        for (const Samples& samples : domains_) drawn += !samples.empty();
        return drawn;
    }

    /// Calls visit(domain, context, counts) for each sample that was drawn, in no order.
    template <class Visit>
    void forEach(const Derivations& derivations, const Visit& visit) const {
        for (std::size_t i = 0; i < domains_.size(); ++i) {
            for (const auto& [key, counts] : domains_[i]) {
                visit(derivations[i],
                      SampleCtx{static_cast<unsigned>(key >> 32), static_cast<unsigned>(key)},
                      counts);
            }
        }
    }

private:
    using Samples = std::unordered_map<uint64_t, DrawCounts>;

    static uint64_t key(SampleCtx context) {
        return uint64_t{context.patternid} << 32 | context.sampleid;
    }

    std::vector<Samples> domains_; ///< by the numbers of their derivations
    uint64_t draws_ = 0;
};

} // namespace detail
} // namespace stream1
} // namespace wellstrat
