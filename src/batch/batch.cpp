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
            inSlot ? detail::blueSlotPoint(sc.patternid, sc.sampleid, order.slot, order.splits)
                   : detail::bluePoint(sc.patternid, sc.sampleid);
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

void drawSamples1D(std::size_t n, const SampleCtx* contexts, float* xis) {
    if (n > 0) chosenKernels().draw1D(n, tables(), readOnly(contexts), 0, xis);
}

void drawSamples2D(std::size_t n, const SampleCtx* contexts, Float2* xis) {
    if (n > 0) chosenKernels().draw2D(n, tables(), readOnly(contexts), 0, xis);
}

void drawSamples3D(std::size_t n, const SampleCtx* contexts, Float3* xis) {
    if (n > 0) chosenKernels().draw3D(n, tables(), readOnly(contexts), 0, xis);
}

void generateSamples1D(std::size_t n, SampleCtx* contexts, float* xis) {
    if (n > 0) chosenKernels().draw1D(n, tables(), contexts, 1, xis);
}

void generateSamples2D(std::size_t n, SampleCtx* contexts, Float2* xis) {
    if (n > 0) chosenKernels().draw2D(n, tables(), contexts, 1, xis);
}

void generateSamples3D(std::size_t n, SampleCtx* contexts, Float3* xis) {
    if (n > 0) chosenKernels().draw3D(n, tables(), contexts, 1, xis);
}

void drawJointSamples1D(std::size_t n, const SampleCtx* contexts, Order order, float* xis) {
    if (!detail::hasSlot(order)) return drawSamples1D(n, contexts, xis);
    if (n > 0) chosenKernels().drawJoint1D(n, tables(), contexts, order.slot, order.splits, xis);
}

void drawJointSamples2D(std::size_t n, const SampleCtx* contexts, Order order, Float2* xis) {
    if (!detail::hasSlot(order)) return drawSamples2D(n, contexts, xis);
    if (n > 0) chosenKernels().drawJoint2D(n, tables(), contexts, order.slot, order.splits, xis);
}

void drawJointSamples3D(std::size_t n, const SampleCtx* contexts, Order order, Float3* xis) {
    if (!detail::hasSlot(order)) return drawSamples3D(n, contexts, xis);
    if (n > 0) chosenKernels().drawJoint3D(n, tables(), contexts, order.slot, order.splits, xis);
}

void drawSequenceSamples1D(std::size_t n, const SampleCtx* contexts, Order order, float* xis) {
    detail::hasSlot(order);
    if (n > 0) chosenKernels().drawSequence1D(n, contexts, order.slot, order.splits, xis);
}

void drawSequenceSamples2D(std::size_t n, const SampleCtx* contexts, Order order, Float2* xis) {
    detail::hasSlot(order);
    if (n > 0) chosenKernels().drawSequence2D(n, contexts, order.slot, order.splits, xis);
}

void drawSequenceSamples3D(std::size_t n, const SampleCtx* contexts, Order order, Float3* xis) {
    detail::hasSlot(order);
    if (n > 0) chosenKernels().drawSequence3D(n, contexts, order.slot, order.splits, xis);
}

void drawBlueSamples1D(std::size_t n, const SampleCtx* contexts, Order order, float* xis) {
    detail::hasSlot(order);
    if (n > 0) chosenKernels().drawBlue1D(n, contexts, order.slot, order.splits, xis);
}

void drawBlueSamples2D(std::size_t n, const SampleCtx* contexts, Order order, Float2* xis) {
    detail::hasSlot(order);
    if (n > 0) chosenKernels().drawBlue2D(n, contexts, order.slot, order.splits, xis);
}

void drawBlueSamples3D(std::size_t n, const SampleCtx* contexts, Order order, Float3* xis) {
    detail::hasSlot(order);
    if (n > 0) chosenKernels().drawBlue3D(n, contexts, order.slot, order.splits, xis);
}

void drawSequenceBits1D(std::size_t n, const SampleCtx* contexts, Order order, uint32_t* bits) {
    detail::hasSlot(order);
    if (n > 0) chosenKernels().drawSequenceBits1D(n, contexts, order.slot, order.splits, bits);
}

void drawSequenceBits2D(std::size_t n, const SampleCtx* contexts, Order order, Bits2* bits) {
    detail::hasSlot(order);
    if (n > 0) chosenKernels().drawSequenceBits2D(n, contexts, order.slot, order.splits, bits);
}

void drawSequenceBits3D(std::size_t n, const SampleCtx* contexts, Order order, Bits3* bits) {
    detail::hasSlot(order);
    if (n > 0) chosenKernels().drawSequenceBits3D(n, contexts, order.slot, order.splits, bits);
}

void drawBlueBits1D(std::size_t n, const SampleCtx* contexts, Order order, uint32_t* bits) {
    drawBlueBits<scrambledBitsZ>(n, contexts, order, bits);
}

void drawBlueBits2D(std::size_t n, const SampleCtx* contexts, Order order, Bits2* bits) {
    drawBlueBits<scrambledBitsXY>(n, contexts, order, bits);
}

void drawBlueBits3D(std::size_t n, const SampleCtx* contexts, Order order, Bits3* bits) {
    drawBlueBits<scrambledBitsXYZ>(n, contexts, order, bits);
}

void newDomains(std::size_t n, const SampleCtx* parents, Scramble scramble, SampleCtx* children) {
    newDomainsSplit(n, parents, scramble, 1, children);
}

void newDomainsDistrib(std::size_t n, const SampleCtx* parents, Scramble scramble,
                       unsigned newsampleid, SampleCtx* children) {
    if (n > 0) chosenKernels().newDomainsDistrib(n, parents, scramble, newsampleid, children);
}

void newDomainsSplit(std::size_t n, const SampleCtx* parents, Scramble scramble,
                     unsigned newnumsamples, SampleCtx* children) {
    if (n > 0) chosenKernels().newDomainsSplit(n, parents, scramble, newnumsamples, children);
}

void newBlueDomainsSplit(std::size_t n, const SampleCtx* parents, Scramble scramble,
                         unsigned newnumsamples, SampleCtx* children) {
    if (n > 0) chosenKernels().newBlueDomainsSplit(n, parents, scramble, newnumsamples, children);
}

void newBlueDomainsDistrib(std::size_t n, const SampleCtx* parents, Scramble scramble,
                           unsigned newsampleid, SampleCtx* children) {
    if (n > 0) chosenKernels().newBlueDomainsDistrib(n, parents, scramble, newsampleid, children);
}

void hashToRandom(std::size_t n, const SampleCtx* contexts, float* xis) {
    if (n > 0) chosenKernels().hashToRandom(n, contexts, xis);
}

} // namespace stream1
} // namespace wellstrat
