// SPDX-License-Identifier: Apache-2.0
//
// Batches of BlueProgressive in vector code; see vector.cpp.
//
// Each function here has the name of the scalar function whose bits it computes.

#include "batch/vector_targets.h"

#include "wellstrat/blue_lookup.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "batch/blue_vector.cpp"
#include "hwy/foreach_target.h"

#include "batch/blue_ranks.h"
#include "batch/blue_vector.h"
#include "batch/sequence_orders.h"

#include <type_traits>

#if HWY_TARGET != HWY_SCALAR && HWY_TARGET != HWY_EMU128
HWY_BEFORE_NAMESPACE();
namespace wellstrat {
inline namespace stream1 {
namespace batch {
namespace HWY_NAMESPACE {
namespace {

HWY_INLINE V permuteState(V patternid, DerivationKey key) {
    const V stateBits = constant(detail::kStateBits);
    V state = hn::Mul(hn::And(hn::Xor(patternid, constant(key.mask)), stateBits),
                      constant(detail::kGolden));
    state = hn::Xor(state, hn::And(hn::ShiftRight<10>(state), stateBits));
    state = hn::Mul(state, constant(key.multiplier));
    return hn::Xor(state, hn::And(hn::ShiftRight<10>(state), stateBits));
}

HWY_INLINE V deriveBluePattern(V patternid, DerivationKey key) {
    return hn::Or(permuteState(patternid, key), hn::And(patternid, constant(detail::kPlaceBits)));
}

HWY_INLINE V distribState(V sampleid) {
    const V upper = hn::Mul(hn::ShiftRight<20>(sampleid), constant(detail::kGolden));
    return hn::ShiftLeft<12>(hn::Xor(sampleid, upper));
}

/// All bits of a word as its bit kBit.
template <int kBit>
HWY_INLINE V spreadBit(V x) {
    const hn::RebindToSigned<Words> integers;
    return hn::BitCast(kWords,
                       hn::BroadcastSignBit(hn::BitCast(integers, hn::ShiftLeft<31 - kBit>(x))));
}

HWY_INLINE V placeKey(V seed) { return hn::Mul(seed, constant(detail::placeKey(1))); }

/// paddedPlace for a vector of hashes.
class Mover {
public:
    HWY_INLINE explicit Mover(V hash)
        : shift_(hn::ShiftRight<20>(hash)),
          flip_(hn::Or(hn::Or(hn::And(spreadBit<19>(hash), x()), hn::And(spreadBit<18>(hash), y())),
                       hn::And(spreadBit<17>(hash), constant(kRanks)))) {}

    HWY_INLINE V paddedPlace(V place) const {
        const V across = hn::And(hn::Add(place, shift_), x());
        const V down = hn::And(hn::Add(hn::And(place, y()), shift_), y());
        return hn::Xor(hn::Or(across, down), flip_);
    }

private:
    static HWY_INLINE V x() { return constant(63); }
    static HWY_INLINE V y() { return constant(63u << 6); }

    V shift_, flip_;
};

struct Located {
    V seed, place;
};

// The two kinds of domains. Both keep what depends on the state, since all pixels of a tile have
// one: locate(patternid) is the seed, and where in its tile() the rank stands.

/// bluePoint.
class PaddedDomain {
public:
    HWY_INLINE PaddedDomain()
        : state_(hn::Zero(kWords)), seed_(sequenceSeed(state_)), mover_(placeKey(seed_)) {}

    HWY_INLINE Located locate(V patternid) {
        const V state = hn::ShiftRight<kRankDigits>(patternid);
        if (!same(state, state_)) {
            state_ = state;
            seed_ = sequenceSeed(state);
            mover_ = Mover(placeKey(seed_));
        }
        return {seed_, mover_.paddedPlace(hn::And(patternid, constant(detail::kPlaceBits)))};
    }

    static const uint16_t* tile() { return detail::kBlueTables.padded; }
    static constexpr unsigned slot() { return 0; }
    HWY_INLINE PointVectors point(V seed, V sampleid) { return order_.point(seed, sampleid); }

private:
    V state_, seed_;
    Mover mover_;
    ShuffledSequence order_;
};

/// blueSlotPoint.
template <typename Order>
class SlotDomain {
public:
    HWY_INLINE SlotDomain(unsigned slot, Order order)
        : slot_(slot), state_(hn::Zero(kWords)), seed_(sequenceSeed(state_)), order_(order) {}

    HWY_INLINE Located locate(V patternid) {
        const V state = hn::ShiftRight<kRankDigits>(patternid);
        if (!same(state, state_)) {
            state_ = state;
            seed_ = sequenceSeed(state);
        }
        return {seed_, hn::And(patternid, constant(detail::kPlaceBits))};
    }

    static const uint16_t* tile() { return detail::kBlueTables.slots; }
    unsigned slot() const { return slot_; }
    HWY_INLINE PointVectors point(V seed, V sampleid) {
        return order_.point(hn::And(seed, constant(~detail::kSlotSwapBit)), sampleid);
    }

private:
    unsigned slot_;
    V state_, seed_;
    Order order_;
};

/// The points of a domain and the keys of their scrambling, kept from vector to vector: in a
/// coherent batch all pixels of a tile have one point before their ranks move it.
template <typename Domain>
class KeptPoint {
public:
    HWY_INLINE explicit KeptPoint(Domain& domain)
        : domain_(domain), seed_(hn::Zero(kWords)), sampleid_(seed_), keys_(seed_),
          point_(domain.point(seed_, seed_)) {}

    HWY_INLINE void moveTo(V seed, V sampleid) {
        if (same(seed, seed_) && same(sampleid, sampleid_)) return;
        seed_ = seed;
        sampleid_ = sampleid;
        keys_ = ScramblingKeys(seed);
        // One by one: compilers would copy the whole through memory.
        const PointVectors point = domain_.point(seed, sampleid);
        point_.x = point.x;
        point_.y = point.y;
        point_.z = point.z;
    }

    /// movedDigits, scrambled.
    template <typename Sample>
    HWY_INLINE void storeMoved(const PointVectors& rank, Sample* xis) const {
        const V x = hn::Xor(point_.x, rank.x), y = hn::Xor(point_.y, rank.y);
        const V exchanged = hn::And(hn::Xor(x, y), spreadBit<31>(seed_));
        storeScrambled({hn::Xor(x, exchanged), hn::Xor(y, exchanged), hn::Xor(point_.z, rank.z)},
                       keys_, xis);
    }

private:
    Domain& domain_;
    V seed_, sampleid_;
    ScramblingKeys keys_;
    PointVectors point_;
};

/// How many vectors are a block. In WebAssembly many, of which compilers unroll no loop
/// (docs/decisions/0030-webassembly.md).
constexpr std::size_t kBlueBlockVectors = HWY_TARGET == HWY_WASM ? 32 : kBlockVectors;

// rankDigits of a block of samples, by the places of their pixels. Those that a Sample does not
// need are left out by compilers.

/// By permuting registers of eight words or more, by as many bits of a rank at a time.
template <typename Sample>
class PermutedDigits {
public:
    HWY_INLINE PermutedDigits(std::size_t n, const uint16_t* tile, unsigned slot, uint32_t* places)
        : maps_(rankMaps<kBits>(slot)), ranks_(places) {
        findRanks(n, tile, places);
    }

    HWY_INLINE PointVectors at(std::size_t i) const {
        V rank = hn::Load(kWords, ranks_ + i);
        PointVectors digits{hn::Zero(kWords), hn::Zero(kWords), hn::Zero(kWords)};
        for (unsigned k = 0; k < kRankDigits / kBits; ++k) {
            const auto bits = hn::IndicesFromVec(kWords, hn::And(rank, constant(kLanes - 1)));
            digits.x = hn::Xor(digits.x, hn::TableLookupLanes(part(0, k), bits));
            digits.y = hn::Xor(digits.y, hn::TableLookupLanes(part(1, k), bits));
            digits.z = hn::Xor(digits.z, hn::TableLookupLanes(part(2, k), bits));
            rank = hn::ShiftRight<kBits>(rank);
        }
        return digits;
    }

private:
    static constexpr unsigned kBits = kLanes == 16 ? 4 : 3;

    HWY_INLINE V part(unsigned dimension, unsigned k) const {
        return hn::Load(kWords, maps_[dimension].parts[k]);
    }

    const RankMap<kBits>* maps_;
    const uint32_t* ranks_;
};

/// Where registers are smaller, by loads.
template <typename Sample>
class LoadedDigits {
public:
    HWY_INLINE LoadedDigits(std::size_t n, const uint16_t* tile, unsigned slot,
                            const uint32_t* places) {
        if constexpr (kHasXY) findDigitsXY(n, tile, slot, places, xy_);
        if constexpr (kHasZ) findDigitsZ(n, tile, slot, places, z_);
    }

    HWY_INLINE PointVectors at(std::size_t i) const {
        PointVectors digits{hn::Zero(kWords), hn::Zero(kWords), hn::Zero(kWords)};
        if constexpr (kHasXY) {
            hn::LoadInterleaved2(kWords, reinterpret_cast<const uint32_t*>(xy_ + i), digits.x,
                                 digits.y);
        }
        if constexpr (kHasZ) digits.z = hn::Load(kWords, z_ + i);
        return digits;
    }

private:
    static constexpr bool kHasXY = !std::is_same_v<Sample, float>;
    static constexpr bool kHasZ = !std::is_same_v<Sample, Float2>;

    HWY_ALIGN uint64_t xy_[kHasXY ? kBlueBlockVectors * kLanes : 1];
    HWY_ALIGN uint32_t z_[kHasZ ? kBlueBlockVectors * kLanes : 1];
};

/// Draws `vectors` vectors of samples, kBlueBlockVectors at most. First all places are found and
/// then all ranks, so that no load waits for the arithmetic of its own sample.
template <typename Domain, typename Sample>
HWY_INLINE void drawBlock(std::size_t vectors, const SampleCtx* contexts, Domain& domain,
                          KeptPoint<Domain>& point, Sample* xis) {
    using Digits = std::conditional_t<(kLanes < 8), LoadedDigits<Sample>, PermutedDigits<Sample>>;
    HWY_ALIGN uint32_t seeds[kBlueBlockVectors * kLanes];
    HWY_ALIGN uint32_t places[kBlueBlockVectors * kLanes];
    const std::size_t n = vectors * kLanes;
    V patternid, sampleid;
    for (std::size_t i = 0; i < n; i += kLanes) {
        load(contexts + i, patternid, sampleid);
        const Located located = domain.locate(patternid);
        hn::Store(located.seed, kWords, seeds + i);
        hn::Store(located.place, kWords, places + i);
    }
    const Digits digits(n, domain.tile(), domain.slot(), places);
    for (std::size_t i = 0; i < n; i += kLanes) {
        load(contexts + i, patternid, sampleid);
        point.moveTo(hn::Load(kWords, seeds + i), sampleid);
        point.storeMoved(digits.at(i), xis + i);
    }
}

template <typename Domain, typename Sample>
HWY_INLINE void drawDomain(std::size_t n, const SampleCtx* contexts, Domain domain, Sample* xis) {
    KeptPoint<Domain> point(domain);
    forBlocks<kBlueBlockVectors>(
        n, contexts, xis,
        [&](std::size_t vectors, const SampleCtx* some, Sample* results)
            __attribute__((always_inline)) { drawBlock(vectors, some, domain, point, results); });
}

} // namespace

template <typename Sample>
void drawBlue(std::size_t n, const SampleCtx* contexts, unsigned slot, unsigned split,
              Sample* xis) {
    if (slot == kJointSlots) return drawDomain(n, contexts, PaddedDomain(), xis);
    if (split == 1) {
        return drawDomain(n, contexts, SlotDomain<SlotSequence>(slot, SlotSequence(slot)), xis);
    }
    drawDomain(n, contexts, SlotDomain<SplitSlotSequence>(slot, SplitSlotSequence(slot, split)),
               xis);
}

template void drawBlue(std::size_t, const SampleCtx*, unsigned, unsigned, float*);
template void drawBlue(std::size_t, const SampleCtx*, unsigned, unsigned, Float2*);
template void drawBlue(std::size_t, const SampleCtx*, unsigned, unsigned, Float3*);

void newBlueDomainsSplit(std::size_t n, const SampleCtx* parents, Scramble scramble,
                         unsigned newnumsamples, SampleCtx* children) {
    const DerivationKey key = derivationKey(scramble);
    forVectors(n, parents, children, [&](const SampleCtx* parent, SampleCtx* child) {
        V patternid, sampleid;
        load(parent, patternid, sampleid);
        store(deriveBluePattern(patternid, key), hn::Mul(sampleid, constant(newnumsamples)), child);
    });
}

void newBlueDomainsDistrib(std::size_t n, const SampleCtx* parents, Scramble scramble,
                           unsigned newsampleid, SampleCtx* children) {
    constexpr DerivationKey kVisits = derivationKey(static_cast<Scramble>(detail::kBlueDistribKey));
    const DerivationKey key = derivationKey(scramble);
    forVectors(n, parents, children, [&](const SampleCtx* parent, SampleCtx* child) {
        V patternid, sampleid;
        load(parent, patternid, sampleid);
        const V domain = hn::Xor(deriveBluePattern(patternid, key), distribState(sampleid));
        store(deriveBluePattern(domain, kVisits), constant(newsampleid), child);
    });
}

} // namespace HWY_NAMESPACE
} // namespace batch
} // namespace stream1
} // namespace wellstrat
HWY_AFTER_NAMESPACE();
#endif
