// SPDX-License-Identifier: Apache-2.0
//
// How a domain was derived, and the way back from its contexts to the path that they belong to.
//
// For a known scramble, a derived pattern has one parent pattern. So whoever knows the scrambles
// from the camera down to a domain finds the camera's pattern from the domain's, and whoever knows
// the splits finds the camera's sampleid.

#pragma once

#include "wellstrat/domain.h"
#include "wellstrat/generator.h"

#include <cstddef>
#include <deque>
#include <map>
#include <string>
#include <tuple>

namespace wellstrat {
inline namespace stream1 {
namespace detail {

/// One way to derive a domain: a chain of scrambles and splits that begins at the camera.
/// Distribution mixes the sampleid into the pattern, which cannot be undone; from there on the
/// chain begins anew.
struct Derivation {
    const Derivation* parent; ///< null for the camera
    Scramble scramble;
    unsigned split;          ///< as in Generator::ChildOrder
    const Derivation* base;  ///< where paths begin: the last distribution, or the camera
    uint64_t splits;         ///< the product of all splits since `base`, at most 2^32
    std::size_t number;      ///< its place among all derivations
    bool isSlotView = false; ///< a RixRNG(parent, contexts, n) of a slot, or of such a view
};

/// What the contexts of one path have in common.
struct PathId {
    const Derivation* base;
    SampleCtx start; ///< its context there
};

/// The path of a context of `domain`, which `generator` derived. Of a context that was not derived
/// that way, such as one made by SampleCtx::NewDomain, it is a path of its own, with a pattern that
/// nobody else has.
PathId pathOf(const Derivation& domain, SampleCtx context, const Generator& generator);

/// "camera > 0x03707344 > 0xa4093822 split 4".
std::string nameOf(const Derivation& domain);

/// The slot of JointProgressive that the domain draws from, or kJointSlots.
unsigned slotOf(const Derivation& domain);

/// Whether `domain` is `ancestor` or derived from it.
bool isUnder(const Derivation& domain, const Derivation& ancestor);

/// All derivations that were seen, each once, at addresses that stay. Not synchronized.
class Derivations {
public:
    Derivations();
    Derivations(const Derivations&) = delete;
    Derivations& operator=(const Derivations&) = delete;

    const Derivation& camera() const { return all_.front(); }
    const Derivation& child(const Derivation& parent, Scramble scramble, unsigned split);
    /// What a RixRNG(parent, contexts, n) of the domain is: but for slots, which it has not, the
    /// same.
    const Derivation& view(const Derivation& domain);
    const Derivation& operator[](std::size_t number) const { return all_[number]; }
    std::size_t size() const { return all_.size(); }

private:
    std::deque<Derivation> all_;
    std::map<std::tuple<std::size_t, Scramble, unsigned>, std::size_t> numbers_;
    std::map<std::size_t, std::size_t> views_; ///< by the numbers of the slots' domains
};

} // namespace detail
} // namespace stream1
} // namespace wellstrat
