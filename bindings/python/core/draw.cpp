// SPDX-License-Identifier: Apache-2.0

#include "draw.h"

#include "wellstrat/batch.h"
#include "wellstrat/random.h"

#include <algorithm>
#include <type_traits>

namespace python {
namespace {

using namespace wellstrat;

/// How many samples are drawn at a time where something is done with them afterwards.
constexpr std::size_t kBlock = 512;

template <typename Draw1D, typename Draw2D, typename Draw3D, typename Value>
void drawBy(Draw1D draw1D, Draw2D draw2D, Draw3D draw3D, std::size_t n, const SampleCtx* contexts,
            const Drawing& drawing, Value* values) {
    switch (drawing.dims) {
    case 1: return draw1D(n, contexts, drawing.order, values);
    case 2: return draw2D(n, contexts, drawing.order, values);
    default: return draw3D(n, contexts, drawing.order, values);
    }
}

/// The library's function for points of several coordinates, over their single ones.
template <typename Point, typename Value>
auto flat(void (*draw)(std::size_t, ArrayArgument<const SampleCtx>, Order, ArrayArgument<Point>)) {
    return [draw](std::size_t n, const SampleCtx* contexts, Order order, Value* values) {
        draw(n, contexts, order, reinterpret_cast<Point*>(values));
    };
}

void drawRandomBits(std::size_t n, const SampleCtx* contexts, unsigned dims, uint32_t* bits) {
    const unsigned first = dims == 1 ? 2 : 0; // z alone, or from x on
    for (std::size_t i = 0; i < n; ++i) {
        for (unsigned k = 0; k < dims; ++k) {
            bits[i * dims + k] = randomBits(contexts[i].patternid, contexts[i].sampleid,
                                            static_cast<Coordinate>(first + k));
        }
    }
}

/// All 32 bits of each coordinate. Not of pmj, which has 24.
void drawBits(std::size_t n, const SampleCtx* contexts, const Drawing& drawing, uint32_t* bits) {
    switch (drawing.generator) {
    case Generator::longSequence:
        return drawBy(drawSequenceBits1D, flat<Bits2, uint32_t>(drawSequenceBits2D),
                      flat<Bits3, uint32_t>(drawSequenceBits3D), n, contexts, drawing, bits);
    case Generator::blue:
        return drawBy(drawBlueBits1D, flat<Bits2, uint32_t>(drawBlueBits2D),
                      flat<Bits3, uint32_t>(drawBlueBits3D), n, contexts, drawing, bits);
    default: return drawRandomBits(n, contexts, drawing.dims, bits);
    }
}

/// Draws in blocks of Word, by draw(n, contexts, words), and converts each word.
template <typename Word, typename Real, typename Draw, typename Convert>
void drawConverted(std::size_t n, const SampleCtx* contexts, unsigned dims, Real* xis, Draw draw,
                   Convert convert) {
    Word words[3 * kBlock];
    for (std::size_t begin = 0; begin < n; begin += kBlock) {
        const std::size_t block = std::min(kBlock, n - begin);
        draw(block, contexts + begin, words);
        std::transform(words, words + block * dims, xis + begin * dims, convert);
    }
}

/// bits * 2^-32 - 0.5 + middle, which is exact. Processors convert vectors of signed integers only.
double fraction(uint32_t bits, double middle) {
    return static_cast<int32_t>(bits ^ 0x80000000u) * 0x1p-32 + middle;
}

void drawRunOfTables(std::size_t n, uint32_t patternid, uint32_t first, unsigned dims, float* xis) {
    switch (dims) {
    case 1: return drawRun1D(n, patternid, first, xis);
    case 2: return drawRun2D(n, patternid, first, reinterpret_cast<Float2*>(xis));
    default: return drawRun3D(n, patternid, first, reinterpret_cast<Float3*>(xis));
    }
}

/// Calls some(pattern, first, n) for the part of each run that is within [begin, end).
template <typename Some>
void forRuns(const Runs& runs, std::size_t begin, std::size_t end, Some some) {
    if (begin == end) return;
    const uint32_t* pattern = runs.patterns + begin / runs.count;
    for (std::size_t sample = begin % runs.count; begin < end; sample = 0) {
        const std::size_t n = std::min(runs.count - sample, end - begin);
        some(*pattern++, runs.first + static_cast<uint32_t>(sample), n);
        begin += n;
    }
}

} // namespace

void draw(std::size_t n, const SampleCtx* contexts, const Drawing& drawing, float* xis) {
    switch (drawing.generator) {
    case Generator::pmj:
        return drawBy(drawJointSamples1D, flat<Float2, float>(drawJointSamples2D),
                      flat<Float3, float>(drawJointSamples3D), n, contexts, drawing, xis);
    case Generator::longSequence:
        return drawBy(drawSequenceSamples1D, flat<Float2, float>(drawSequenceSamples2D),
                      flat<Float3, float>(drawSequenceSamples3D), n, contexts, drawing, xis);
    case Generator::blue:
        return drawBy(drawBlueSamples1D, flat<Float2, float>(drawBlueSamples2D),
                      flat<Float3, float>(drawBlueSamples3D), n, contexts, drawing, xis);
    case Generator::random: break;
    }
    drawConverted<uint32_t>(
        n, contexts, drawing.dims, xis,
        [&](std::size_t block, const SampleCtx* some, uint32_t* bits) {
            drawRandomBits(block, some, drawing.dims, bits);
        },
        [](uint32_t bits) { return toUnitFloat(bits); });
}

void draw(std::size_t n, const SampleCtx* contexts, const Drawing& drawing, double* xis) {
    if (drawing.generator == Generator::pmj) {
        drawConverted<float>(
            n, contexts, drawing.dims, xis,
            [&](std::size_t block, const SampleCtx* some, float* floats) {
                draw(block, some, drawing, floats);
            },
            [offset = drawing.offset](float xi) { return static_cast<double>(xi) + offset; });
        return;
    }
    drawConverted<uint32_t>(
        n, contexts, drawing.dims, xis,
        [&](std::size_t block, const SampleCtx* some, uint32_t* bits) {
            drawBits(block, some, drawing, bits);
        },
        [middle = 0.5 + drawing.offset](uint32_t bits) { return fraction(bits, middle); });
}

template <typename Real>
void drawRuns(const Runs& runs, std::size_t begin, std::size_t end, const Drawing& drawing,
              Real* xis) {
    if constexpr (std::is_same_v<Real, float>) {
        if (drawing.generator == Generator::pmj && drawing.order.slot == kJointSlots) {
            return forRuns(runs, begin, end, [&](uint32_t pattern, uint32_t first, std::size_t n) {
                drawRunOfTables(n, pattern, first, drawing.dims, xis);
                xis += n * drawing.dims;
            });
        }
    }
    alignas(64) SampleCtx contexts[kBlock];
    for (std::size_t n = 0; begin < end; begin += n, xis += n * drawing.dims) {
        n = std::min(kBlock, end - begin);
        SampleCtx* next = contexts;
        forRuns(runs, begin, begin + n, [&](uint32_t pattern, uint32_t sample, std::size_t some) {
            for (SampleCtx* const stop = next + some; next != stop; ++next, ++sample) {
                *next = {pattern, sample};
            }
        });
        draw(n, contexts, drawing, xis);
    }
}

template void drawRuns(const Runs&, std::size_t, std::size_t, const Drawing&, float*);
template void drawRuns(const Runs&, std::size_t, std::size_t, const Drawing&, double*);

} // namespace python
