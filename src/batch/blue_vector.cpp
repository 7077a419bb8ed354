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

#include <algorithm>
#include <type_traits>

#if HWY_TARGET != HWY_SCALAR && HWY_TARGET != HWY_EMU128
HWY_BEFORE_NAMESPACE();
namespace wellstrat {
inline namespace stream1 {
namespace batch {
namespace HWY_NAMESPACE {
namespace {

/// How many vectors of samples are drawn at a time.
constexpr std::size_t kBlockVectors = 8;

HWY_INLINE bool same(V a, V b) { return hn::AllTrue(kWords, hn::Eq(a, b)); }

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

HWY_INLINE V stateSeed(V patternid) { return sequenceSeed(hn::ShiftRight<kRankDigits>(patternid)); }

/// rankSeries of the halves of rank words, byte by byte: of the lower ones for kLow = 0, kHigh = 1.
template <uint8_t kLow, uint8_t kHigh>
HWY_INLINE V rankSeries(V ranks) {
    return hn::Xor(bytesOf<kLow, kHigh, kNone, kNone>(ranks),
                   bytesOf<kNone, kLow, kHigh, kLow>(ranks));
}

/// All bits of a word as its bit kBit.
template <int kBit>
HWY_INLINE V spreadBit(V x) {
    const hn::RebindToSigned<Words> integers;
    return hn::BitCast(kWords,
                       hn::BroadcastSignBit(hn::BitCast(integers, hn::ShiftLeft<31 - kBit>(x))));
}

/// movedPlace for a vector of hashes.
class Mover {
public:
    HWY_INLINE explicit Mover(V hash)
        : shift_(hn::ShiftRight<20>(hash)),
          flip_(hn::Or(hn::And(spreadBit<19>(hash), x()), hn::And(spreadBit<18>(hash), y()))),
          exchange_(hn::And(spreadBit<17>(hash), x())) {}

    HWY_INLINE V movedPlace(V place) const {
        const V across = hn::And(hn::Add(place, shift_), x());
        const V down = hn::And(hn::Add(hn::And(place, y()), shift_), y());
        const V moved = hn::Xor(hn::Or(across, down), flip_);
        const V exchanged = hn::And(xorShifted<6>(moved), exchange_);
        return hn::Xor(moved, hn::Or(exchanged, hn::ShiftLeft<6>(exchanged)));
    }

private:
    static HWY_INLINE V x() { return constant(63); }
    static HWY_INLINE V y() { return constant(63u << 6); }

    V shift_, flip_, exchange_;
};

/// What an order gives, kept from vector to vector: in a coherent batch all pixels of a tile have
/// one point.
template <typename Order>
class KeptPoint {
public:
    HWY_INLINE explicit KeptPoint(Order order)
        : order_(order), seed_(hn::Zero(kWords)), sampleid_(seed_),
          point_(order_.point(seed_, sampleid_)) {}

    /// Valid until the next call. (To copy it, compilers take it apart.)
    HWY_INLINE const PointVectors& point(V seed, V sampleid) {
        if (!same(seed, seed_) || !same(sampleid, sampleid_)) {
            seed_ = seed;
            sampleid_ = sampleid;
            const PointVectors point = order_.point(seed, sampleid);
            point_.x = point.x;
            point_.y = point.y;
            point_.z = point.z;
        }
        return point_;
    }

private:
    Order order_;
    V seed_, sampleid_;
    PointVectors point_;
};

// The two kinds of domains. places(patternid, seed) is where the ranks of pixels stand, rank(n,
// places) puts their words there, point(seed, sampleid) is what they move.

/// bluePoint.
class PaddedDomain {
public:
    HWY_INLINE PaddedDomain()
        : points_(ShuffledSequence()), seed_(hn::Zero(kWords)), mover_(seed_) {}

    HWY_INLINE V places(V patternid, V seed) {
        if (!same(seed, seed_)) {
            seed_ = seed;
            mover_ = Mover(hn::Mul(seed, constant(detail::placeKey(1))));
        }
        return mover_.movedPlace(hn::And(patternid, constant(detail::kPlaceBits)));
    }

    static void rank(std::size_t n, uint32_t* places) { paddedRanks(n, places); }

    HWY_INLINE const PointVectors& point(V seed, V sampleid) {
        return points_.point(seed, sampleid);
    }

private:
    KeptPoint<ShuffledSequence> points_;
    V seed_;
    Mover mover_;
};

/// blueSlotPoint.
template <typename Order>
class SlotDomain {
public:
    HWY_INLINE SlotDomain(unsigned slot, Order order) : slot_(slot), points_(order) {}

    HWY_INLINE V places(V patternid, V /*seed*/) const {
        return hn::And(patternid, constant(detail::kPlaceBits));
    }

    void rank(std::size_t n, uint32_t* places) const { slotRanks(n, slot_, places); }

    HWY_INLINE const PointVectors& point(V seed, V sampleid) {
        return points_.point(hn::And(seed, constant(~detail::kSlotSwapBit)), sampleid);
    }

private:
    unsigned slot_;
    KeptPoint<Order> points_;
};

/// movedDigits, for `ranksZ` that are looked up already.
HWY_INLINE PointVectors movedDigits(const PointVectors& point, V ranks, V ranksZ, V seed) {
    const V x = hn::Xor(point.x, rankSeries<0, 1>(ranks));
    const V y = hn::Xor(point.y, rankSeries<2, 3>(ranks));
    const V exchanged = hn::And(hn::Xor(x, y), spreadBit<31>(seed));
    return {hn::Xor(x, exchanged), hn::Xor(y, exchanged), hn::Xor(point.z, ranksZ)};
}

/// Draws `vectors` vectors of samples, kBlockVectors at most. First all places are found and then
/// all ranks, so that no load waits for the arithmetic of its own sample.
template <typename Domain, typename Sample>
HWY_INLINE void drawBlock(std::size_t vectors, const SampleCtx* contexts, Domain& domain,
                          Sample* xis) {
    constexpr bool hasZ = !std::is_same_v<Sample, Float2>;
    HWY_ALIGN uint32_t seeds[kBlockVectors * kLanes];
    HWY_ALIGN uint32_t ranks[kBlockVectors * kLanes];
    HWY_ALIGN uint32_t ranksZ[hasZ ? kBlockVectors * kLanes : kLanes];
    const std::size_t n = vectors * kLanes;
    V patternid, sampleid;
    for (std::size_t i = 0; i < n; i += kLanes) {
        load(contexts + i, patternid, sampleid);
        const V seed = stateSeed(patternid);
        hn::Store(seed, kWords, seeds + i);
        hn::Store(domain.places(patternid, seed), kWords, ranks + i);
    }
    domain.rank(n, ranks);
    if constexpr (hasZ) rankDigitsZ(n, ranks, ranksZ);
    V keysSeed = hn::Load(kWords, seeds);
    ScramblingKeys keys(keysSeed);
    for (std::size_t i = 0; i < n; i += kLanes) {
        load(contexts + i, patternid, sampleid);
        const V seed = hn::Load(kWords, seeds + i);
        const PointVectors& point = domain.point(seed, sampleid);
        const V z = hasZ ? hn::Load(kWords, ranksZ + i) : hn::Zero(kWords);
        if (!same(seed, keysSeed)) {
            keysSeed = seed;
            keys = ScramblingKeys(seed);
        }
        storeScrambled(movedDigits(point, hn::Load(kWords, ranks + i), z, seed), keys, xis + i);
    }
}

template <typename Domain, typename Sample>
HWY_INLINE void drawDomain(std::size_t n, const SampleCtx* contexts, Domain domain, Sample* xis) {
    SampleCtx copies[kLanes];
    Sample drawn[kLanes];
    for (std::size_t i = 0; i < n;) {
        const std::size_t whole = std::min((n - i) / kLanes, kBlockVectors);
        // The rest, which fills no vector, is copied. One call, since all of this is inlined.
        const bool isRest = whole == 0;
        if (isRest)
            std::fill(std::copy(contexts + i, contexts + n, copies), copies + kLanes, SampleCtx{});
        drawBlock(isRest ? 1 : whole, isRest ? copies : contexts + i, domain,
                  isRest ? drawn : xis + i);
        if (isRest) std::copy_n(drawn, n - i, xis + i);
        i += isRest ? n - i : whole * kLanes;
    }
}

template <typename Sample>
HWY_INLINE void draw(std::size_t n, const SampleCtx* contexts, unsigned slot, unsigned split,
                     Sample* xis) {
    if (slot == kJointSlots) return drawDomain(n, contexts, PaddedDomain(), xis);
    if (split == 1) {
        return drawDomain(n, contexts, SlotDomain<SlotSequence>(slot, SlotSequence(slot)), xis);
    }
    drawDomain(n, contexts, SlotDomain<SplitSlotSequence>(slot, SplitSlotSequence(slot, split)),
               xis);
}

} // namespace

void drawBlue1D(std::size_t n, const SampleCtx* contexts, unsigned slot, unsigned split,
                float* xis) {
    draw(n, contexts, slot, split, xis);
}

void drawBlue2D(std::size_t n, const SampleCtx* contexts, unsigned slot, unsigned split,
                Float2* xis) {
    draw(n, contexts, slot, split, xis);
}

void drawBlue3D(std::size_t n, const SampleCtx* contexts, unsigned slot, unsigned split,
                Float3* xis) {
    draw(n, contexts, slot, split, xis);
}

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
