// SPDX-License-Identifier: Apache-2.0

#include "wellstrat/batch.h"

#include "batch/kernels.h"
#include "core/order_check.h"
#include "wellstrat/batch_target.h"
#include "wellstrat/blue_lookup.h"
#include "wellstrat/random.h"
#include "wellstrat/sequence.h"
#include "wellstrat/tables.h"

#include <algorithm>
#include <atomic>
#include <cstring>

namespace wellstrat {
inline namespace stream1 {
namespace {

using batch::chosenKernels;
using batch::DrawComputed;
using batch::DrawJoint;
using batch::DrawRun;
using batch::DrawTables;
using batch::Kernels;

/// Null until the first batch or until a target is forced.
std::atomic<const Kernels*> chosen{nullptr};

const Kernels* kernelsAt(unsigned index) {
    const Kernels* const* vector = batch::vectorKernels();
    for (; *vector != nullptr && index > 0; --index) ++vector;
    if (*vector != nullptr) return *vector;
    return index == 0 ? &batch::kScalarKernels : nullptr;
}

/// The kernels of a draw do not write to the contexts when the step is 0.
SampleCtx* readOnly(const SampleCtx* contexts) { return const_cast<SampleCtx*>(contexts); }

/// Samples from the tables by one of the kernels, after which `step` is added to each sampleid.
/// `function` is named where an array is too small.
template <typename Sample>
void drawFromTables(const char* function, DrawTables<Sample> Kernels::*kernel, std::size_t n,
                    ArrayArgument<SampleCtx> contexts, unsigned step, ArrayArgument<Sample> xis) {
    if (n == 0) return;
    (chosenKernels().*kernel)(n, tables(), contexts.first(n, function), step,
                              xis.first(n, function));
}

/// Samples of one pattern by one of the kernels, and by `random` those that no table has.
template <typename Sample>
void drawRun(DrawRun<Sample> Kernels::*kernel, Sample (*random)(uint32_t, uint32_t), std::size_t n,
             uint32_t patternid, uint32_t first, Sample* xis) {
    for (std::size_t i = 0; i < n;) {
        const auto begin = static_cast<uint32_t>(first + i);
        if (begin < kStratifiedSamples) {
            const std::size_t count = std::min<std::size_t>(n - i, kStratifiedSamples - begin);
            (chosenKernels().*kernel)(count, tables(), patternid, begin, xis + i);
            i += count;
        } else {
            xis[i++] = random(patternid, begin);
        }
    }
}

/// Samples in a domain of this order, by the kernel for padded ones or that for slots.
template <typename Sample>
void drawJoint(const char* function, DrawTables<Sample> Kernels::*padded,
               DrawJoint<Sample> Kernels::*slot, std::size_t n,
               ArrayArgument<const SampleCtx> contexts, Order order, ArrayArgument<Sample> xis) {
    if (!detail::hasSlot(order)) {
        return drawFromTables<Sample>(function, padded, n, readOnly(contexts.first(n, function)), 0,
                                      xis);
    }
    if (n == 0) return;
    (chosenKernels().*slot)(n, tables(), contexts.first(n, function), order.slot, order.splits,
                            xis.first(n, function));
}

/// Samples of a computed sequence, or their bits, by one of the kernels. `function` is named where
/// an array is too small.
template <typename Result>
void drawComputed(const char* function, DrawComputed<Result> Kernels::*kernel, std::size_t n,
                  ArrayArgument<const SampleCtx> contexts, Order order,
                  ArrayArgument<Result> results) {
    detail::checkOrder(order);
    if (n == 0) return;
    (chosenKernels().*kernel)(n, contexts.first(n, function), order.slot, order.splits,
                              results.first(n, function));
}

/// All bits of the samples, by kBits of a point and its seed.
template <auto kBits, typename Bits>
void drawBlueBits(std::size_t n, const SampleCtx* contexts, Order order, Bits* bits) {
    const bool inSlot = detail::hasSlot(order);
    for (std::size_t i = 0; i < n; ++i) {
        const SampleCtx sc = contexts[i];
        const detail::BluePoint point =
            inSlot ? detail::blueSlotPoint(detail::kBlueTables, detail::kSlotOrders, sc.patternid,
                                           sc.sampleid, order.slot, order.splits)
                   : detail::bluePoint(detail::kBlueTables, sc.patternid, sc.sampleid);
        bits[i] = kBits(point.digits, point.seed);
    }
}

} // namespace

const Kernels& batch::chosenKernels() {
    const Kernels* current = chosen.load(std::memory_order_relaxed);
    if (current == nullptr) {
        current = kernelsAt(0);
        chosen.store(current, std::memory_order_relaxed);
    }
    return *current;
}

const char* batchTarget(unsigned index) {
    const Kernels* k = kernelsAt(index);
    return k != nullptr ? k->target : nullptr;
}

const char* chosenBatchTarget() { return chosenKernels().target; }

bool forceBatchTarget(const char* name) {
    for (unsigned i = 0; const Kernels* k = kernelsAt(i); ++i) {
        if (std::strcmp(k->target, name) == 0) {
            chosen.store(k, std::memory_order_relaxed);
            return true;
        }
    }
    return false;
}

void drawSamples1D(std::size_t n, ArrayArgument<const SampleCtx> contexts,
                   ArrayArgument<float> xis) {
    drawFromTables(__func__, &Kernels::draw1D, n, readOnly(contexts.first(n, __func__)), 0, xis);
}

void drawSamples2D(std::size_t n, ArrayArgument<const SampleCtx> contexts,
                   ArrayArgument<Float2> xis) {
    drawFromTables(__func__, &Kernels::draw2D, n, readOnly(contexts.first(n, __func__)), 0, xis);
}

void drawSamples3D(std::size_t n, ArrayArgument<const SampleCtx> contexts,
                   ArrayArgument<Float3> xis) {
    drawFromTables(__func__, &Kernels::draw3D, n, readOnly(contexts.first(n, __func__)), 0, xis);
}

void generateSamples1D(std::size_t n, ArrayArgument<SampleCtx> contexts, ArrayArgument<float> xis) {
    drawFromTables(__func__, &Kernels::draw1D, n, contexts, 1, xis);
}

void generateSamples2D(std::size_t n, ArrayArgument<SampleCtx> contexts,
                       ArrayArgument<Float2> xis) {
    drawFromTables(__func__, &Kernels::draw2D, n, contexts, 1, xis);
}

void generateSamples3D(std::size_t n, ArrayArgument<SampleCtx> contexts,
                       ArrayArgument<Float3> xis) {
    drawFromTables(__func__, &Kernels::draw3D, n, contexts, 1, xis);
}

void drawRun1D(std::size_t n, uint32_t patternid, uint32_t first, ArrayArgument<float> xis) {
    drawRun(&Kernels::drawRun1D, randomSample1D, n, patternid, first, xis.first(n, __func__));
}

void drawRun2D(std::size_t n, uint32_t patternid, uint32_t first, ArrayArgument<Float2> xis) {
    drawRun(&Kernels::drawRun2D, randomSample2D, n, patternid, first, xis.first(n, __func__));
}

void drawRun3D(std::size_t n, uint32_t patternid, uint32_t first, ArrayArgument<Float3> xis) {
    drawRun(&Kernels::drawRun3D, randomSample3D, n, patternid, first, xis.first(n, __func__));
}

void drawJointSamples1D(std::size_t n, ArrayArgument<const SampleCtx> contexts, Order order,
                        ArrayArgument<float> xis) {
    drawJoint(__func__, &Kernels::draw1D, &Kernels::drawJoint1D, n, contexts, order, xis);
}

void drawJointSamples2D(std::size_t n, ArrayArgument<const SampleCtx> contexts, Order order,
                        ArrayArgument<Float2> xis) {
    drawJoint(__func__, &Kernels::draw2D, &Kernels::drawJoint2D, n, contexts, order, xis);
}

void drawJointSamples3D(std::size_t n, ArrayArgument<const SampleCtx> contexts, Order order,
                        ArrayArgument<Float3> xis) {
    drawJoint(__func__, &Kernels::draw3D, &Kernels::drawJoint3D, n, contexts, order, xis);
}

void drawSequenceSamples1D(std::size_t n, ArrayArgument<const SampleCtx> contexts, Order order,
                           ArrayArgument<float> xis) {
    drawComputed(__func__, &Kernels::drawSequence1D, n, contexts, order, xis);
}

void drawSequenceSamples2D(std::size_t n, ArrayArgument<const SampleCtx> contexts, Order order,
                           ArrayArgument<Float2> xis) {
    drawComputed(__func__, &Kernels::drawSequence2D, n, contexts, order, xis);
}

void drawSequenceSamples3D(std::size_t n, ArrayArgument<const SampleCtx> contexts, Order order,
                           ArrayArgument<Float3> xis) {
    drawComputed(__func__, &Kernels::drawSequence3D, n, contexts, order, xis);
}

void drawBlueSamples1D(std::size_t n, ArrayArgument<const SampleCtx> contexts, Order order,
                       ArrayArgument<float> xis) {
    drawComputed(__func__, &Kernels::drawBlue1D, n, contexts, order, xis);
}

void drawBlueSamples2D(std::size_t n, ArrayArgument<const SampleCtx> contexts, Order order,
                       ArrayArgument<Float2> xis) {
    drawComputed(__func__, &Kernels::drawBlue2D, n, contexts, order, xis);
}

void drawBlueSamples3D(std::size_t n, ArrayArgument<const SampleCtx> contexts, Order order,
                       ArrayArgument<Float3> xis) {
    drawComputed(__func__, &Kernels::drawBlue3D, n, contexts, order, xis);
}

void drawSequenceBits1D(std::size_t n, ArrayArgument<const SampleCtx> contexts, Order order,
                        ArrayArgument<uint32_t> bits) {
    drawComputed(__func__, &Kernels::drawSequenceBits1D, n, contexts, order, bits);
}

void drawSequenceBits2D(std::size_t n, ArrayArgument<const SampleCtx> contexts, Order order,
                        ArrayArgument<Bits2> bits) {
    drawComputed(__func__, &Kernels::drawSequenceBits2D, n, contexts, order, bits);
}

void drawSequenceBits3D(std::size_t n, ArrayArgument<const SampleCtx> contexts, Order order,
                        ArrayArgument<Bits3> bits) {
    drawComputed(__func__, &Kernels::drawSequenceBits3D, n, contexts, order, bits);
}

void drawBlueBits1D(std::size_t n, ArrayArgument<const SampleCtx> contexts, Order order,
                    ArrayArgument<uint32_t> bits) {
    drawBlueBits<scrambledBitsZ>(n, contexts.first(n, __func__), order, bits.first(n, __func__));
}

void drawBlueBits2D(std::size_t n, ArrayArgument<const SampleCtx> contexts, Order order,
                    ArrayArgument<Bits2> bits) {
    drawBlueBits<scrambledBitsXY>(n, contexts.first(n, __func__), order, bits.first(n, __func__));
}

void drawBlueBits3D(std::size_t n, ArrayArgument<const SampleCtx> contexts, Order order,
                    ArrayArgument<Bits3> bits) {
    drawBlueBits<scrambledBitsXYZ>(n, contexts.first(n, __func__), order, bits.first(n, __func__));
}

void newDomains(std::size_t n, ArrayArgument<const SampleCtx> parents, Scramble scramble,
                ArrayArgument<SampleCtx> children) {
    newDomainsSplit(n, parents.first(n, __func__), scramble, 1, children.first(n, __func__));
}

void newDomainsDistrib(std::size_t n, ArrayArgument<const SampleCtx> parents, Scramble scramble,
                       unsigned newsampleid, ArrayArgument<SampleCtx> children) {
    if (n == 0) return;
    chosenKernels().newDomainsDistrib(n, parents.first(n, __func__), scramble, newsampleid,
                                      children.first(n, __func__));
}

void newDomainsSplit(std::size_t n, ArrayArgument<const SampleCtx> parents, Scramble scramble,
                     unsigned newnumsamples, ArrayArgument<SampleCtx> children) {
    if (n == 0) return;
    chosenKernels().newDomainsSplit(n, parents.first(n, __func__), scramble, newnumsamples,
                                    children.first(n, __func__));
}

void newBlueDomainsSplit(std::size_t n, ArrayArgument<const SampleCtx> parents, Scramble scramble,
                         unsigned newnumsamples, ArrayArgument<SampleCtx> children) {
    if (n == 0) return;
    chosenKernels().newBlueDomainsSplit(n, parents.first(n, __func__), scramble, newnumsamples,
                                        children.first(n, __func__));
}

void newBlueDomainsDistrib(std::size_t n, ArrayArgument<const SampleCtx> parents, Scramble scramble,
                           unsigned newsampleid, ArrayArgument<SampleCtx> children) {
    if (n == 0) return;
    chosenKernels().newBlueDomainsDistrib(n, parents.first(n, __func__), scramble, newsampleid,
                                          children.first(n, __func__));
}

void hashToRandom(std::size_t n, ArrayArgument<const SampleCtx> contexts,
                  ArrayArgument<float> xis) {
    if (n == 0) return;
    chosenKernels().hashToRandom(n, contexts.first(n, __func__), xis.first(n, __func__));
}

} // namespace stream1
} // namespace wellstrat
