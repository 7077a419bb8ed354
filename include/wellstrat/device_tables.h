// SPDX-License-Identifier: Apache-2.0
//
// What draws in GPU kernels look up, as one block of memory to copy to the device.
//
//     using namespace wellstrat;
//     std::vector<char> block(deviceTableBytes(DeviceDraws::all));
//     copyDeviceTables(block.data(), DeviceDraws::all);
//     // allocate as many bytes on the device and copy them there; a kernel gets the pointer as a
//     // `const DeviceTables* tables` and calls, for example,
//     const Float2 xi = sample2D(tables->words, sc.patternid, sc.sampleid);
//
// Shaders (wellstrat/shaders) read the same block as words of 32 bits.
//
// docs/gpu.md has all the calls, and examples/gpu a program. Nothing here needs a GPU: the block is
// as good on the host, and its parts are those that the host's draws read.

#pragma once

#include "wellstrat/blue_lookup.h"
#include "wellstrat/joint_lookup.h"
#include "wellstrat/sequence_slots.h"

#include <cstddef>
#include <type_traits>

namespace wellstrat {
inline namespace stream1 {

/// The block, aligned to 8 bytes. It is plain data, the same for all devices of the host's byte
/// order. Kernels read it only, so any number of them may at once.
struct DeviceTables {
    detail::SlotOrders slotOrders;    ///< for slots of long.h and blue.h
    detail::BlueTables blueTables;    ///< for blue.h
    detail::JointOrders jointOrders;  ///< for slots of joint.h
    uint32_t words[2 * kTablePoints]; ///< as tables(): the xy words, then the z words
};

static_assert(std::is_trivially_copyable<DeviceTables>::value &&
                  std::is_standard_layout<DeviceTables>::value,
              "copied as bytes");

/// Which draws a block is for: it may end early. LongProgressive's samples without slots, random
/// ones and contexts need no block.
enum class DeviceDraws : unsigned {
    computed, ///< slots of long.h, and blue.h: 70 KiB
    draws2D,  ///< those, and 2D draws from tables, with slots or without: 6.1 MiB
    all,      ///< those, and 1D and 3D draws from tables: 12.1 MiB
};

/// The size of the block for these draws.
constexpr std::size_t deviceTableBytes(DeviceDraws draws) {
    switch (draws) {
    case DeviceDraws::computed: return offsetof(DeviceTables, words);
    case DeviceDraws::draws2D: return offsetof(DeviceTables, words) + 4 * kTablePoints;
    default: return sizeof(DeviceTables);
    }
}

/// Writes the first deviceTableBytes(draws) bytes of the block to `block`, memory of the host of at
/// least that size and of any alignment. Builds the tables if they are needed and are not there;
/// throws std::bad_alloc without memory for that. Safe in any thread.
WELLSTRAT_API void copyDeviceTables(void* block, DeviceDraws draws);

} // namespace stream1
} // namespace wellstrat
