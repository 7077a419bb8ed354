// SPDX-License-Identifier: Apache-2.0

#include "wellstrat/batch.h"

#include "batch/kernels.h"
#include "core/order_check.h"
#include "wellstrat/batch_target.h"
#include "wellstrat/blue_lookup.h"
#include "wellstrat/sequence.h"
#include "wellstrat/tables.h"

#include <atomic>
#include <cstring>

namespace wellstrat {
inline namespace stream1 {
namespace {

using batch::chosenKernels;
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
    if (n == 0) return;
    chosenKernels().draw1D(n, tables(), readOnly(contexts.first(n, __func__)), 0,
                           xis.first(n, __func__));
}

void drawSamples2D(std::size_t n, ArrayArgument<const SampleCtx> contexts,
                   ArrayArgument<Float2> xis) {
    if (n == 0) return;
    chosenKernels().draw2D(n, tables(), readOnly(contexts.first(n, __func__)), 0,
                           xis.first(n, __func__));
}

void drawSamples3D(std::size_t n, ArrayArgument<const SampleCtx> contexts,
                   ArrayArgument<Float3> xis) {
    if (n == 0) return;
    chosenKernels().draw3D(n, tables(), readOnly(contexts.first(n, __func__)), 0,
                           xis.first(n, __func__));
}

void generateSamples1D(std::size_t n, ArrayArgument<SampleCtx> contexts, ArrayArgument<float> xis) {
    if (n == 0) return;
    chosenKernels().draw1D(n, tables(), contexts.first(n, __func__), 1, xis.first(n, __func__));
}

void generateSamples2D(std::size_t n, ArrayArgument<SampleCtx> contexts,
                       ArrayArgument<Float2> xis) {
    if (n == 0) return;
    chosenKernels().draw2D(n, tables(), contexts.first(n, __func__), 1, xis.first(n, __func__));
}

void generateSamples3D(std::size_t n, ArrayArgument<SampleCtx> contexts,
                       ArrayArgument<Float3> xis) {
    if (n == 0) return;
    chosenKernels().draw3D(n, tables(), contexts.first(n, __func__), 1, xis.first(n, __func__));
}

void drawJointSamples1D(std::size_t n, ArrayArgument<const SampleCtx> contexts, Order order,
                        ArrayArgument<float> xis) {
    if (!detail::hasSlot(order)) {
        return drawSamples1D(n, contexts.first(n, __func__), xis.first(n, __func__));
    }
    if (n == 0) return;
    chosenKernels().drawJoint1D(n, tables(), contexts.first(n, __func__), order.slot, order.splits,
                                xis.first(n, __func__));
}

void drawJointSamples2D(std::size_t n, ArrayArgument<const SampleCtx> contexts, Order order,
                        ArrayArgument<Float2> xis) {
    if (!detail::hasSlot(order)) {
        return drawSamples2D(n, contexts.first(n, __func__), xis.first(n, __func__));
    }
    if (n == 0) return;
    chosenKernels().drawJoint2D(n, tables(), contexts.first(n, __func__), order.slot, order.splits,
                                xis.first(n, __func__));
}

void drawJointSamples3D(std::size_t n, ArrayArgument<const SampleCtx> contexts, Order order,
                        ArrayArgument<Float3> xis) {
    if (!detail::hasSlot(order)) {
        return drawSamples3D(n, contexts.first(n, __func__), xis.first(n, __func__));
    }
    if (n == 0) return;
    chosenKernels().drawJoint3D(n, tables(), contexts.first(n, __func__), order.slot, order.splits,
                                xis.first(n, __func__));
}

void drawSequenceSamples1D(std::size_t n, ArrayArgument<const SampleCtx> contexts, Order order,
                           ArrayArgument<float> xis) {
    detail::checkOrder(order);
    if (n == 0) return;
    chosenKernels().drawSequence1D(n, contexts.first(n, __func__), order.slot, order.splits,
                                   xis.first(n, __func__));
}

void drawSequenceSamples2D(std::size_t n, ArrayArgument<const SampleCtx> contexts, Order order,
                           ArrayArgument<Float2> xis) {
    detail::checkOrder(order);
    if (n == 0) return;
    chosenKernels().drawSequence2D(n, contexts.first(n, __func__), order.slot, order.splits,
                                   xis.first(n, __func__));
}

void drawSequenceSamples3D(std::size_t n, ArrayArgument<const SampleCtx> contexts, Order order,
                           ArrayArgument<Float3> xis) {
    detail::checkOrder(order);
    if (n == 0) return;
    chosenKernels().drawSequence3D(n, contexts.first(n, __func__), order.slot, order.splits,
                                   xis.first(n, __func__));
}

void drawBlueSamples1D(std::size_t n, ArrayArgument<const SampleCtx> contexts, Order order,
                       ArrayArgument<float> xis) {
    detail::checkOrder(order);
    if (n == 0) return;
    chosenKernels().drawBlue1D(n, contexts.first(n, __func__), order.slot, order.splits,
                               xis.first(n, __func__));
}

void drawBlueSamples2D(std::size_t n, ArrayArgument<const SampleCtx> contexts, Order order,
                       ArrayArgument<Float2> xis) {
    detail::checkOrder(order);
    if (n == 0) return;
    chosenKernels().drawBlue2D(n, contexts.first(n, __func__), order.slot, order.splits,
                               xis.first(n, __func__));
}

void drawBlueSamples3D(std::size_t n, ArrayArgument<const SampleCtx> contexts, Order order,
                       ArrayArgument<Float3> xis) {
    detail::checkOrder(order);
    if (n == 0) return;
    chosenKernels().drawBlue3D(n, contexts.first(n, __func__), order.slot, order.splits,
                               xis.first(n, __func__));
}

void drawSequenceBits1D(std::size_t n, ArrayArgument<const SampleCtx> contexts, Order order,
                        ArrayArgument<uint32_t> bits) {
    detail::checkOrder(order);
    if (n == 0) return;
    chosenKernels().drawSequenceBits1D(n, contexts.first(n, __func__), order.slot, order.splits,
                                       bits.first(n, __func__));
}

void drawSequenceBits2D(std::size_t n, ArrayArgument<const SampleCtx> contexts, Order order,
                        ArrayArgument<Bits2> bits) {
    detail::checkOrder(order);
    if (n == 0) return;
    chosenKernels().drawSequenceBits2D(n, contexts.first(n, __func__), order.slot, order.splits,
                                       bits.first(n, __func__));
}

void drawSequenceBits3D(std::size_t n, ArrayArgument<const SampleCtx> contexts, Order order,
                        ArrayArgument<Bits3> bits) {
    detail::checkOrder(order);
    if (n == 0) return;
    chosenKernels().drawSequenceBits3D(n, contexts.first(n, __func__), order.slot, order.splits,
                                       bits.first(n, __func__));
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
