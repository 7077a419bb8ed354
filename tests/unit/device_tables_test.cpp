// SPDX-License-Identifier: Apache-2.0
//
// The block for kernels holds what the host's draws look up, and parts of it serve some draws.

#include "wellstrat/device_tables.h"

#include <gtest/gtest.h>

#include <cstring>
#include <memory>
#include <vector>

namespace wellstrat {
namespace {

constexpr DeviceDraws kAllDraws[] = {DeviceDraws::computed, DeviceDraws::draws2D, DeviceDraws::all};

std::unique_ptr<DeviceTables> wholeBlock() {
    auto block = std::make_unique<DeviceTables>();
    copyDeviceTables(block.get(), DeviceDraws::all);
    return block;
}

TEST(DeviceTables, GiveTheSamplesOfTheHost) {
    const auto t = wholeBlock();
    for (uint32_t pattern = 0; pattern < 1000; ++pattern) {
        const uint32_t sampleid = (pattern * pattern) << pattern % 13;
        const unsigned slot = pattern % kJointSlots, split = 1 + pattern % 5;
        EXPECT_EQ(sample3D(t->words, pattern, sampleid), sample3D(pattern, sampleid));
        EXPECT_EQ(jointSample3D(t->words, t->jointOrders, pattern, sampleid, slot, split),
                  jointSample3D(tables(), pattern, sampleid, slot, split));
        EXPECT_EQ(jointSequenceSample3D(t->slotOrders, pattern, sampleid, slot, split),
                  jointSequenceSample3D(pattern, sampleid, slot, split));
        EXPECT_EQ(blueSample3D(t->blueTables, pattern, sampleid), blueSample3D(pattern, sampleid));
        EXPECT_EQ(blueSlotSample3D(t->blueTables, t->slotOrders, pattern, sampleid, slot, split),
                  blueSlotSample3D(pattern, sampleid, slot, split));
    }
}

// So no draw looks up anything of the host's behind its back.
TEST(DeviceTables, OtherOrdersGiveOtherSamples) {
    const auto t = wholeBlock();
    std::memset(static_cast<void*>(&t->jointOrders), 0, sizeof t->jointOrders);
    std::memset(static_cast<void*>(&t->slotOrders), 0, sizeof t->slotOrders);
    std::memset(static_cast<void*>(&t->blueTables), 0, sizeof t->blueTables);
    for (const unsigned split : {1u, 3u}) {
        EXPECT_NE(jointSample3D(t->words, t->jointOrders, 1, 9, 2, split),
                  jointSample3D(tables(), 1, 9, 2, split));
        EXPECT_NE(jointSequenceSample3D(t->slotOrders, 1, 9, 2, split),
                  jointSequenceSample3D(1, 9, 2, split));
        EXPECT_NE(blueSlotSample3D(detail::kBlueTables, t->slotOrders, 1, 9, 2, split),
                  blueSlotSample3D(1, 9, 2, split));
    }
    EXPECT_NE(blueSample3D(t->blueTables, 1, 9), blueSample3D(1, 9));
    EXPECT_NE(blueSlotSample3D(t->blueTables, detail::kSlotOrders, 1, 9, 2, 1),
              blueSlotSample3D(1, 9, 2, 1));
}

TEST(DeviceTables, PartsAreTheBeginningOfAllAndWriteNothingBehindIt) {
    const auto whole = wholeBlock();
    for (const DeviceDraws draws : kAllDraws) {
        const std::size_t size = deviceTableBytes(draws);
        constexpr unsigned char kUntouched = 0xa5;
        std::vector<unsigned char> block(size + 65, kUntouched);
        copyDeviceTables(block.data() + 1, draws); // of any alignment
        EXPECT_EQ(std::memcmp(block.data() + 1, whole.get(), size), 0);
        EXPECT_EQ(block[0], kUntouched);
        for (std::size_t i = size + 1; i < block.size(); ++i) ASSERT_EQ(block[i], kUntouched);
    }
}

TEST(DeviceTables, AreAsLargeAsTheHeaderSays) {
    EXPECT_EQ(deviceTableBytes(DeviceDraws::computed) >> 10, 69u);
    EXPECT_EQ(deviceTableBytes(DeviceDraws::draws2D),
              deviceTableBytes(DeviceDraws::computed) + 4u * kTablePoints);
    EXPECT_EQ(deviceTableBytes(DeviceDraws::all), sizeof(DeviceTables));
}

} // namespace
} // namespace wellstrat
