// SPDX-License-Identifier: Apache-2.0

#include "wellstrat/joint.h"

#include "batch/kernels.h"
#include "wellstrat/batch.h"
#include "wellstrat/tables.h"

namespace wellstrat {
inline namespace stream1 {

/// One of each kind: a domain's generator holds nothing else.
class JointProgressive::Children {
public:
    Children() {
        for (unsigned slot = 0; slot <= kJointSlots; ++slot) {
            for (unsigned split = 1; split <= kMaxJointSplit; ++split) {
                JointProgressive& child = of_[slot][split - 1];
                child.slot_ = slot;
                child.split_ = split;
            }
        }
    }

    const JointProgressive* of(unsigned slot, unsigned split) const {
        return &of_[slot][split - 1];
    }

private:
    JointProgressive of_[kJointSlots + 1][kMaxJointSplit];
};

JointProgressive::~JointProgressive() = default;

float JointProgressive::Sample1D(const SampleCtx& sc, unsigned /*i*/) const {
    return slot_ == kJointSlots ? sample1D(sc.patternid, sc.sampleid)
                                : jointSample1D(tables(), sc.patternid, sc.sampleid, slot_, split_);
}

Float2 JointProgressive::Sample2D(const SampleCtx& sc, unsigned /*i*/) const {
    return slot_ == kJointSlots ? sample2D(sc.patternid, sc.sampleid)
                                : jointSample2D(tables(), sc.patternid, sc.sampleid, slot_, split_);
}

Float3 JointProgressive::Sample3D(const SampleCtx& sc, unsigned /*i*/) const {
    return slot_ == kJointSlots ? sample3D(sc.patternid, sc.sampleid)
                                : jointSample3D(tables(), sc.patternid, sc.sampleid, slot_, split_);
}

void JointProgressive::MultiSample1D(unsigned n, const SampleCtx& sc, float* xis) const {
    slot_ == kJointSlots ? drawSamples1D(n, &sc, xis)
                         : drawJointSamples1D(n, &sc, slot_, split_, xis);
}

void JointProgressive::MultiSample2D(unsigned n, const SampleCtx& sc, Float2* xis) const {
    slot_ == kJointSlots ? drawSamples2D(n, &sc, xis)
                         : drawJointSamples2D(n, &sc, slot_, split_, xis);
}

void JointProgressive::MultiSample3D(unsigned n, const SampleCtx& sc, Float3* xis) const {
    slot_ == kJointSlots ? drawSamples3D(n, &sc, xis)
                         : drawJointSamples3D(n, &sc, slot_, split_, xis);
}

const Generator* JointProgressive::ForChild(Scramble scramble, unsigned split) const {
    if (split == 0 || split > kMaxJointSplit / split_) return nullptr;
    // Never freed: a thread may still draw while the program ends.
    static const Children* const children = new Children;
    const unsigned slot = static_cast<unsigned>(scramble) - detail::kJointScramble;
    return children->of(slot < kJointSlots ? slot : kJointSlots, split * split_);
}

void drawJointSamples1D(std::size_t n, const SampleCtx* contexts, unsigned slot, unsigned split,
                        float* xis) {
    if (n > 0) batch::chosenKernels().drawJoint1D(n, tables(), contexts, slot, split, xis);
}

void drawJointSamples2D(std::size_t n, const SampleCtx* contexts, unsigned slot, unsigned split,
                        Float2* xis) {
    if (n > 0) batch::chosenKernels().drawJoint2D(n, tables(), contexts, slot, split, xis);
}

void drawJointSamples3D(std::size_t n, const SampleCtx* contexts, unsigned slot, unsigned split,
                        Float3* xis) {
    if (n > 0) batch::chosenKernels().drawJoint3D(n, tables(), contexts, slot, split, xis);
}

} // namespace stream1
} // namespace wellstrat
