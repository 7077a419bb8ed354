// SPDX-License-Identifier: Apache-2.0
//
// The source of shaders, as Metal compiled by a C++ compiler, has the parts of DeviceTables where
// they are, and gives the library's bits. (tests/gpu runs it as other languages on devices.)

#include "RixRNGInline.h"
#include "wellstrat/blue_domain.h"
#include "wellstrat/camera.h"
#include "wellstrat/device_tables.h"

#pragma GCC diagnostic ignored "-Wunused-function"
#include "wellstrat/shaders/wellstrat.metal"
#undef device // of the Metal that is none

#include <gtest/gtest.h>

#include <sys/mman.h>
#include <unistd.h>

#include <cstdlib>
#include <new>
#include <vector>

namespace wellstrat {
namespace {

const uint32_t* words() {
    static const std::vector<uint32_t> block = [] {
        std::vector<uint32_t> all(sizeof(DeviceTables) / 4);
        copyDeviceTables(all.data(), DeviceDraws::all);
        return all;
    }();
    return block.data();
}

Float2 pair(metal::float2 v) { return {v.x, v.y}; }
Float3 triple(metal::float3 v) { return {v.x, v.y, v.z}; }

/// Contexts with sampleids of all magnitudes, and orders of all slots.
struct Asked {
    uint32_t pattern, sampleid;
    unsigned slot, split;
    uvec2 context() const { return {pattern, sampleid}; }
    uvec2 order() const { return {slot, split}; }
};

Asked asked(uint32_t i) {
    const uint32_t pattern = mixBits(i);
    return {pattern, mixBits(pattern) >> (i % 32), i % kJointSlots,
            i % 3 == 0 ? 1 : 1 + mixBits(i + 1) % kMaxJointSplit};
}

constexpr uint32_t kAsked = 3000;

TEST(Shaders, FindThePartsOfDeviceTables) {
    EXPECT_EQ(4 * WELLSTRAT_SLOT_ORDERS, offsetof(DeviceTables, slotOrders));
    EXPECT_EQ(4 * WELLSTRAT_RANKS, offsetof(DeviceTables, blueTables.padded));
    EXPECT_EQ(4 * WELLSTRAT_SLOT_RANKS, offsetof(DeviceTables, blueTables.slots));
    EXPECT_EQ(4 * WELLSTRAT_RANK_XY, offsetof(DeviceTables, blueTables.xy));
    EXPECT_EQ(4 * WELLSTRAT_RANK_Z, offsetof(DeviceTables, blueTables.z));
    EXPECT_EQ(4 * WELLSTRAT_JOINT_LOW, offsetof(DeviceTables, jointOrders.low));
    EXPECT_EQ(4 * WELLSTRAT_JOINT_HIGH, offsetof(DeviceTables, jointOrders.high));
    EXPECT_EQ(4 * WELLSTRAT_XY, offsetof(DeviceTables, words));
    EXPECT_EQ(4 * WELLSTRAT_Z, offsetof(DeviceTables, words) + 4 * kTablePoints);
    EXPECT_EQ(WELLSTRAT_SLOTS, kJointSlots);
    EXPECT_EQ(WELLSTRAT_MAX_SPLIT, kMaxJointSplit);
}

TEST(Shaders, DrawWhatTheLibraryDrawsInPaddedDomains) {
    for (uint32_t i = 0; i < kAsked; ++i) {
        const auto [p, s, slot, split] = asked(i);
        const uvec2 at(p, s), order = WELLSTRAT_ROOT;
        ASSERT_EQ(triple(wellstratSample3D(words(), at)), sample3D(p, s));
        ASSERT_EQ(triple(wellstratJointSample3D(words(), at, order)), sample3D(p, s));
        ASSERT_EQ(triple(wellstratSequenceSample3D(at)), sequenceSample3D(p, s));
        ASSERT_EQ(triple(wellstratLongSample3D(words(), at, order)), sequenceSample3D(p, s));
        ASSERT_EQ(triple(wellstratBlueSample3D(words(), at, order)), blueSample3D(p, s));
        ASSERT_EQ(triple(wellstratRandomSample3D(at)), randomSample3D(p, s));
        ASSERT_EQ(wellstratHashToRandom(p, s), HashToRandom(p, s));
    }
}

TEST(Shaders, DrawWhatTheLibraryDrawsInSlots) {
    for (uint32_t i = 0; i < kAsked; ++i) {
        const Asked a = asked(i);
        const auto [p, s, slot, split] = a;
        ASSERT_EQ(triple(wellstratJointSample3D(words(), a.context(), a.order())),
                  jointSample3D(tables(), p, s, slot, split));
        ASSERT_EQ(triple(wellstratLongSample3D(words(), a.context(), a.order())),
                  jointSequenceSample3D(p, s, slot, split));
        ASSERT_EQ(triple(wellstratBlueSample3D(words(), a.context(), a.order())),
                  blueSlotSample3D(p, s, slot, split));
    }
}

TEST(Shaders, DrawPartsOfOnePoint) {
    for (uint32_t i = 0; i < kAsked; ++i) {
        const Asked a = asked(i);
        const uvec2 at = a.context(), order = a.order();
        const auto expectParts = [](float z, metal::float2 xy, metal::float3 xyz) {
            ASSERT_EQ(pair(xy), Float2(xyz.x, xyz.y));
            ASSERT_EQ(z, xyz.z);
        };
        expectParts(wellstratSample1D(words(), at), wellstratSample2D(words(), at),
                    wellstratSample3D(words(), at));
        expectParts(wellstratSequenceSample1D(at), wellstratSequenceSample2D(at),
                    wellstratSequenceSample3D(at));
        expectParts(wellstratRandomSample1D(at), wellstratRandomSample2D(at),
                    wellstratRandomSample3D(at));
        expectParts(wellstratJointSample1D(words(), at, order),
                    wellstratJointSample2D(words(), at, order),
                    wellstratJointSample3D(words(), at, order));
        expectParts(wellstratLongSample1D(words(), at, order),
                    wellstratLongSample2D(words(), at, order),
                    wellstratLongSample3D(words(), at, order));
        expectParts(wellstratBlueSample1D(words(), at, order),
                    wellstratBlueSample2D(words(), at, order),
                    wellstratBlueSample3D(words(), at, order));
    }
}

/// What draws of some kind look up, before memory that cannot be read.
class GuardedBlock {
public:
    explicit GuardedBlock(DeviceDraws draws) {
        const auto page = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
        const std::size_t bytes = deviceTableBytes(draws), room = (bytes + page - 1) / page * page;
        memory_ =
            static_cast<char*>(mmap(nullptr, room + sizeof(DeviceTables), PROT_READ | PROT_WRITE,
                                    MAP_PRIVATE | MAP_ANONYMOUS, -1, 0));
        if (memory_ == MAP_FAILED) throw std::bad_alloc();
        size_ = room + sizeof(DeviceTables);
        begin_ = memory_ + (room - bytes);
        copyDeviceTables(begin_, draws);
        mprotect(memory_ + room, sizeof(DeviceTables), PROT_NONE);
    }
    ~GuardedBlock() { munmap(memory_, size_); }
    GuardedBlock(const GuardedBlock&) = delete;
    GuardedBlock& operator=(const GuardedBlock&) = delete;

    const uint32_t* words() const { return reinterpret_cast<const uint32_t*>(begin_); }

private:
    char *memory_, *begin_;
    std::size_t size_;
};

/// Whether draws from the blocks that are made for them are those from all tables.
bool guardedDrawsAgree() {
    const GuardedBlock computed(DeviceDraws::computed), draws2D(DeviceDraws::draws2D);
    bool agree = true;
    for (uint32_t i = 0; i < kAsked; ++i) {
        const Asked a = asked(i);
        const uvec2 at = a.context(), order = a.order();
        agree &= triple(wellstratLongSample3D(computed.words(), at, order)) ==
                 triple(wellstratLongSample3D(words(), at, order));
        agree &= triple(wellstratBlueSample3D(computed.words(), at, order)) ==
                 triple(wellstratBlueSample3D(words(), at, order));
        agree &=
            pair(wellstratSample2D(draws2D.words(), at)) == pair(wellstratSample2D(words(), at));
        agree &= pair(wellstratJointSample2D(draws2D.words(), at, order)) ==
                 pair(wellstratJointSample2D(words(), at, order));
    }
    return agree;
}

TEST(Shaders, ReadNothingBehindTheBlockOfTheirDraws) {
    // In a process of its own, which ends at a wrong read.
    EXPECT_EXIT(std::_Exit(guardedDrawsAgree() ? 0 : 1), testing::ExitedWithCode(0), "");
}

void expectContext(uvec2 got, SampleCtx expected) {
    ASSERT_EQ(got.x, expected.patternid);
    ASSERT_EQ(got.y, expected.sampleid);
}

TEST(Shaders, DeriveTheContextsOfTheLibrary) {
    for (uint32_t i = 0; i < kAsked; ++i) {
        const Asked a = asked(i);
        const SampleCtx sc{a.pattern, a.sampleid};
        const uint32_t key = mixBits(~i);
        const Scramble scramble{key};
        const int x = static_cast<int>(a.pattern), y = static_cast<int>(key);
        expectContext(wellstratNewDomain(a.context(), key), sc.NewDomain(scramble));
        expectContext(wellstratNewDomainSplit(a.context(), key, a.split),
                      sc.NewDomainSplit(scramble, a.split));
        expectContext(wellstratNewDomainDistrib(a.context(), key, i),
                      sc.NewDomainDistrib(scramble, i));
        expectContext(wellstratNewBlueDomain(a.context(), key),
                      newBlueDomainSplit(sc, scramble, 1));
        expectContext(wellstratNewBlueDomainSplit(a.context(), key, a.split),
                      newBlueDomainSplit(sc, scramble, a.split));
        expectContext(wellstratNewBlueDomainDistrib(a.context(), key, i),
                      newBlueDomainDistrib(sc, scramble, i));
        expectContext(wellstratCameraContext(x, y, a.slot, i, a.split - 1),
                      cameraContext(x, y, a.slot, i, a.split - 1));
        expectContext(wellstratBlueContext(x, y, a.slot, i), blueContext(x, y, a.slot, i));
    }
}

TEST(Shaders, DeriveTheOrdersOfTheLibrary) {
    for (const unsigned outer : {0u, 1u, 2u, 16u, 17u, 255u, 256u}) {
        for (const unsigned inner : {0u, 1u, 2u, 15u, 16u, 256u, 257u, 0x80000000u, ~0u}) {
            for (unsigned slot = 0; slot < kJointSlots + 2; ++slot) {
                const Order parent = deriveOrder(Order{}, Scramble{7}, outer);
                const Order expected = deriveOrder(parent, jointScramble(slot), inner);
                const uvec2 got =
                    wellstratDeriveOrder(wellstratDeriveOrder(WELLSTRAT_ROOT, 7, outer),
                                         wellstratJointScramble(slot), inner);
                EXPECT_EQ(got.x, expected.slot) << outer << ' ' << inner;
                EXPECT_EQ(got.y, expected.splits) << outer << ' ' << inner;
            }
        }
    }
}

TEST(Shaders, TakeOrdersOutOfRangeAsNoSlot) {
    for (const uvec2 order : {uvec2(16, 1), uvec2(~0u, 1), uvec2(3, 0), uvec2(3, 257),
                              uvec2(3, ~0u), uvec2(1u << 30, 1u << 30)}) {
        for (const uint32_t s : {0u, 9u, 5000u, 200000u, ~0u}) {
            const uvec2 at(77, s);
            EXPECT_EQ(triple(wellstratJointSample3D(words(), at, order)), sample3D(77, s));
            EXPECT_EQ(triple(wellstratLongSample3D(words(), at, order)), sequenceSample3D(77, s));
            EXPECT_EQ(triple(wellstratBlueSample3D(words(), at, order)), blueSample3D(77, s));
            EXPECT_EQ(wellstratDeriveOrder(order, wellstratJointScramble(2), 1).x,
                      order.y == 1 ? 2u : kJointSlots);
        }
    }
}

} // namespace
} // namespace wellstrat
