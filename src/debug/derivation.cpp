// SPDX-License-Identifier: Apache-2.0

#include "debug/derivation.h"

#include "wellstrat/order.h"

#include <algorithm>
#include <cstdio>

namespace wellstrat {
inline namespace stream1 {
namespace detail {

namespace {

std::string hexadecimal(unsigned value) {
    char text[16];
    std::snprintf(text, sizeof text, "0x%08x", value);
    return text;
}

} // namespace

PathId pathOf(const Derivation& domain, SampleCtx context, const Generator& generator) {
    unsigned pattern = context.patternid;
    for (const Derivation* d = &domain; d != domain.base; d = d->parent) {
        pattern = generator.ParentPattern(pattern, d->scramble);
    }
    return {domain.base, {pattern, static_cast<unsigned>(context.sampleid / domain.splits)}};
}

std::string nameOf(const Derivation& domain) {
    if (!domain.parent) return "camera";
    std::string name =
        nameOf(*domain.parent) + " > " + hexadecimal(static_cast<unsigned>(domain.scramble));
    const unsigned slot = slotOf(domain);
    if (slot < kJointSlots) name += " (slot " + std::to_string(slot) + ")";
    if (domain.isSlotView) name += " (view)";
    if (domain.split == 0) return name + " distribution";
    return domain.split == 1 ? name : name + " split " + std::to_string(domain.split);
}

unsigned slotOf(const Derivation& domain) {
    const bool joint = domain.parent && !domain.base->parent && !domain.isSlotView &&
                       domain.splits <= kMaxJointSplit;
    if (!joint) return kJointSlots;
    return std::min(static_cast<unsigned>(domain.scramble) - kJointScramble, kJointSlots);
}

bool isUnder(const Derivation& domain, const Derivation& ancestor) {
    const Derivation* d = &domain;
    while (d && d != &ancestor) d = d->parent;
    return d != nullptr;
}

Derivations::Derivations() {
    all_.push_back({nullptr, Scramble{}, 1, nullptr, 1, 0});
    all_.front().base = &all_.front();
}

const Derivation& Derivations::child(const Derivation& parent, Scramble scramble, unsigned split) {
    const auto [found, isNew] = numbers_.try_emplace({parent.number, scramble, split}, all_.size());
    if (!isNew) return all_[found->second];
    constexpr uint64_t kMost = uint64_t{1} << 32;
    all_.push_back({&parent, scramble, split, parent.base, std::min(parent.splits * split, kMost),
                    all_.size()});
    Derivation& made = all_.back();
    if (split == 0) {
        made.base = &made;
        made.splits = 1;
    }
    return made;
}

const Derivation& Derivations::view(const Derivation& domain) {
    if (slotOf(domain) == kJointSlots) return domain;
    const auto [found, isNew] = views_.try_emplace(domain.number, all_.size());
    if (!isNew) return all_[found->second];
    all_.push_back(domain);
    all_.back().number = found->second;
    all_.back().isSlotView = true;
    return all_.back();
}

} // namespace detail
} // namespace stream1
} // namespace wellstrat
