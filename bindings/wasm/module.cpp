// SPDX-License-Identifier: Apache-2.0
//
// What the WebAssembly module exports: the library over arrays of the module's own, into which
// index.js copies contexts and out of which it copies results. All arguments have been checked
// there; counts are at most kBatch.

#include "RixRNGInline.h"
#include "wellstrat/batch.h"
#include "wellstrat/batch_target.h"
#include "wellstrat/blue_domain.h"
#include "wellstrat/camera.h"
#include "wellstrat/device_tables.h"
#include "wellstrat/order.h"
#include "wellstrat/random.h"
#include "wellstrat/tables.h"
#include "wellstrat/version.h"

#include <cstdint>

namespace {

using namespace wellstrat;

/// So many that calls cost little beside them, and that their results stay in a processor's cache.
constexpr uint32_t kBatch = 4096;

SampleCtx contexts[kBatch];
union {
    float xis[3 * kBatch];
    uint32_t words[3 * kBatch];
} results;

/// Draws n contexts in a domain.
using Draw = void (*)(uint32_t n, Order order);

template <auto kDraw, typename Result>
void batchOf(uint32_t n, Order order) {
    kDraw(n, contexts, order, reinterpret_cast<Result*>(&results));
}

/// Random numbers, as kOf(bits) of each coordinate.
template <unsigned kDims, auto kOf, typename Result>
void randomOf(uint32_t n, Order /*order*/) {
    constexpr unsigned kFirst = kDims == 1 ? 2 : 0; // z alone, or from x on
    Result* const values = reinterpret_cast<Result*>(&results);
    for (uint32_t i = 0; i < n; ++i) {
        for (unsigned k = 0; k < kDims; ++k) {
            const auto coordinate = static_cast<Coordinate>(kFirst + k);
            values[i * kDims + k] =
                kOf(randomBits(contexts[i].patternid, contexts[i].sampleid, coordinate));
        }
    }
}

constexpr uint32_t allBits(uint32_t bits) { return bits; }

/// By generator and coordinates.
constexpr Draw kDraws[][3] = {
    {batchOf<drawJointSamples1D, float>, batchOf<drawJointSamples2D, Float2>,
     batchOf<drawJointSamples3D, Float3>},
    {batchOf<drawSequenceSamples1D, float>, batchOf<drawSequenceSamples2D, Float2>,
     batchOf<drawSequenceSamples3D, Float3>},
    {batchOf<drawBlueSamples1D, float>, batchOf<drawBlueSamples2D, Float2>,
     batchOf<drawBlueSamples3D, Float3>},
    {randomOf<1, toUnitFloat, float>, randomOf<2, toUnitFloat, float>,
     randomOf<3, toUnitFloat, float>}};
/// The same of all bits, which pmj does not have.
constexpr Draw kWordDraws[][3] = {{},
                                  {batchOf<drawSequenceBits1D, uint32_t>,
                                   batchOf<drawSequenceBits2D, Bits2>,
                                   batchOf<drawSequenceBits3D, Bits3>},
                                  {batchOf<drawBlueBits1D, uint32_t>,
                                   batchOf<drawBlueBits2D, Bits2>, batchOf<drawBlueBits3D, Bits3>},
                                  {randomOf<1, allBits, uint32_t>, randomOf<2, allBits, uint32_t>,
                                   randomOf<3, allBits, uint32_t>}};

/// What draws on GPUs look up before the words of the tables.
alignas(DeviceTables) unsigned char deviceHead[deviceTableBytes(DeviceDraws::computed)];

} // namespace

#define WELLSTRAT_EXPORT(name) extern "C" __attribute__((export_name(name)))

WELLSTRAT_EXPORT("contexts") void* contextArray() { return contexts; }
WELLSTRAT_EXPORT("results") void* resultArray() { return &results; }
WELLSTRAT_EXPORT("batch") uint32_t batchSize() { return kBatch; }

WELLSTRAT_EXPORT("version") const char* version() { return WELLSTRAT_VERSION_STRING; }
WELLSTRAT_EXPORT("streamVersion") uint32_t streamVersion() { return kStreamVersion; }
WELLSTRAT_EXPORT("slots") uint32_t slots() { return kJointSlots; }
WELLSTRAT_EXPORT("maxSplits") uint32_t maxSplits() { return kMaxJointSplit; }
/// Whether batches are drawn by vector instructions.
WELLSTRAT_EXPORT("simd") uint32_t simd() { return batchTarget(1) != nullptr; }

/// How much memory the tables may take with what is lost around them.
WELLSTRAT_EXPORT("tableRoom") uint32_t tableRoom() {
    return static_cast<uint32_t>(tableBytes()) + (64u << 10);
}
/// Builds them. The memory must have room for them, or the module traps.
WELLSTRAT_EXPORT("buildTables") void makeTables() { buildTables(); }

/// The size of the block of device_tables.h for these draws, and where its parts are: the head, and
/// the words of the tables, which must have been built.
WELLSTRAT_EXPORT("deviceTableBytes") uint32_t deviceBytes(uint32_t draws) {
    return static_cast<uint32_t>(deviceTableBytes(static_cast<DeviceDraws>(draws)));
}
WELLSTRAT_EXPORT("deviceHead") const void* copyDeviceHead() {
    copyDeviceTables(deviceHead, DeviceDraws::computed);
    return deviceHead;
}
WELLSTRAT_EXPORT("tableWords") const void* tableWords() { return tables(); }

/// Contexts of samples `first` to first + n - 1 of a pattern.
WELLSTRAT_EXPORT("setRun") void setRun(uint32_t n, uint32_t patternid, uint32_t first) {
    for (uint32_t i = 0; i < n; ++i) contexts[i] = {patternid, first + i};
}

/// Those of pixels (x, y) to (x + n - 1, y).
WELLSTRAT_EXPORT("setCamera")
void setCamera(uint32_t n, int32_t x, int32_t y, uint32_t frame, uint32_t sampleid, uint32_t seed) {
    for (uint32_t i = 0; i < n; ++i) {
        contexts[i] = cameraContext(x + static_cast<int32_t>(i), y, frame, sampleid, seed);
    }
}
WELLSTRAT_EXPORT("setBlue")
void setBlue(uint32_t n, int32_t x, int32_t y, uint32_t seed, uint32_t sampleid) {
    for (uint32_t i = 0; i < n; ++i) {
        contexts[i] = blueContext(x + static_cast<int32_t>(i), y, seed, sampleid);
    }
}

/// Samples `first` to first + n - 1 of a pattern from the tables, into the results.
WELLSTRAT_EXPORT("drawRun")
void drawRun(uint32_t n, uint32_t dims, uint32_t patternid, uint32_t first) {
    switch (dims) {
    case 1: return drawRun1D(n, patternid, first, results.xis);
    case 2: return drawRun2D(n, patternid, first, reinterpret_cast<Float2*>(results.xis));
    default: return drawRun3D(n, patternid, first, reinterpret_cast<Float3*>(results.xis));
    }
}

/// Samples of the contexts, or all bits of them, into the results. `slot` is 16 for none.
WELLSTRAT_EXPORT("draw")
void draw(uint32_t n, uint32_t generator, uint32_t dims, uint32_t slot, uint32_t splits) {
    kDraws[generator][dims - 1](n, jointOrder(slot, splits));
}
WELLSTRAT_EXPORT("drawWords")
void drawWords(uint32_t n, uint32_t generator, uint32_t dims, uint32_t slot, uint32_t splits) {
    kWordDraws[generator][dims - 1](n, jointOrder(slot, splits));
}

/// Puts the contexts of new domains in the place of their parents'.
WELLSTRAT_EXPORT("newDomainSplit")
void newDomainSplit(uint32_t n, uint32_t isBlue, uint32_t scramble, uint32_t newnumsamples) {
    const auto derive = isBlue != 0 ? newBlueDomainsSplit : newDomainsSplit;
    derive(n, contexts, static_cast<Scramble>(scramble), newnumsamples, contexts);
}
WELLSTRAT_EXPORT("newDomainDistrib")
void newDomainDistrib(uint32_t n, uint32_t isBlue, uint32_t scramble, uint32_t newsampleid) {
    const auto derive = isBlue != 0 ? newBlueDomainsDistrib : newDomainsDistrib;
    derive(n, contexts, static_cast<Scramble>(scramble), newsampleid, contexts);
}

WELLSTRAT_EXPORT("jointScramble") uint32_t scrambleOf(uint32_t slot) {
    return static_cast<uint32_t>(jointScramble(slot));
}
WELLSTRAT_EXPORT("hashToUnsigned") uint32_t hashOf(uint32_t a, uint32_t b) {
    return HashToUnsigned(a, b);
}
