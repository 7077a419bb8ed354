// SPDX-License-Identifier: Apache-2.0
//
// Functions of the C interface: samples.

#include "c/batch.h"
#include "c/call.h"
#include "c/generators.h"
#include "wellstrat/blue_lookup.h"
#include "wellstrat/c.h"
#include "wellstrat/sequence_slots.h"
#include "wellstrat/tables.h"

namespace wellstrat {
inline namespace stream1 {
namespace {

void draw(const Generator& generator, unsigned n, const SampleCtx& sc, Order order, float* xis) {
    generator.MultiOrderedSample1D(n, sc, order, xis);
}
void draw(const Generator& generator, unsigned n, const SampleCtx& sc, Order order, Float2* xis) {
    generator.MultiOrderedSample2D(n, sc, order, xis);
}
void draw(const Generator& generator, unsigned n, const SampleCtx& sc, Order order, Float3* xis) {
    generator.MultiOrderedSample3D(n, sc, order, xis);
}

/// Samples of this type, of n contexts. `xisName` is what the function calls `xis`.
template <class Sample>
int drawn(const char* function, wellstrat_domain domain, std::size_t n,
          const wellstrat_context* contexts, float* xis, const char* xisName) {
    return c::guarded(function, [&] {
        const Generator& generator = c::generatorOf(domain);
        const Order order = c::drawnOrderOf(domain);
        const unsigned count = c::checkedCount(n);
        c::checkPointer(contexts, "contexts", n);
        c::checkPointer(xis, xisName, n);
        if (count > 0) {
            draw(generator, count, *c::contexts(contexts), order, reinterpret_cast<Sample*>(xis));
        }
    });
}

/// The digits of a sample of a computed sequence before they are scrambled, and the seed of that.
struct SeededPoint {
    PointDigits digits;
    uint32_t seed;
};

SeededPoint longPoint(SampleCtx sc, Order order) {
    const uint32_t seed = sequenceSeed(sc.patternid);
    return {order.slot == kJointSlots ? sequencePoint(seed, sc.sampleid)
                                      : slotDigits(seed, sc.sampleid, order.slot, order.splits),
            seed};
}

SeededPoint bluePoint(SampleCtx sc, Order order) {
    const detail::BluePoint point =
        order.slot == kJointSlots
            ? detail::bluePoint(sc.patternid, sc.sampleid)
            : detail::blueSlotPoint(sc.patternid, sc.sampleid, order.slot, order.splits);
    return {point.digits, point.seed};
}

} // namespace
} // namespace stream1
} // namespace wellstrat

using namespace wellstrat;

int wellstrat_build_tables() {
    return c::guarded(__func__, [] { buildTables(); });
}

int wellstrat_draw_sample_1d(wellstrat_domain domain, wellstrat_context context, float* xi) {
    return drawn<float>(__func__, domain, 1, &context, xi, "xi");
}

int wellstrat_draw_sample_2d(wellstrat_domain domain, wellstrat_context context, float* xi) {
    return drawn<Float2>(__func__, domain, 1, &context, xi, "xi");
}

int wellstrat_draw_sample_3d(wellstrat_domain domain, wellstrat_context context, float* xi) {
    return drawn<Float3>(__func__, domain, 1, &context, xi, "xi");
}

int wellstrat_draw_samples_1d(wellstrat_domain domain, size_t n, const wellstrat_context* contexts,
                              float* xis) {
    return drawn<float>(__func__, domain, n, contexts, xis, "xis");
}

int wellstrat_draw_samples_2d(wellstrat_domain domain, size_t n, const wellstrat_context* contexts,
                              float* xis) {
    return drawn<Float2>(__func__, domain, n, contexts, xis, "xis");
}

int wellstrat_draw_samples_3d(wellstrat_domain domain, size_t n, const wellstrat_context* contexts,
                              float* xis) {
    return drawn<Float3>(__func__, domain, n, contexts, xis, "xis");
}

int wellstrat_draw_words(wellstrat_domain domain, size_t n, const wellstrat_context* contexts,
                         uint32_t* words) {
    return c::guarded(__func__, [&] {
        c::generatorOf(domain);
        const Order order = c::drawnOrderOf(domain);
        if (domain.generator != WELLSTRAT_LONG && domain.generator != WELLSTRAT_BLUE) {
            throw std::invalid_argument("samples of generator " + std::to_string(domain.generator) +
                                        " have 24 bits; accepted are 2 (long) and 3 (blue)");
        }
        const unsigned count = c::checkedCount(n);
        c::checkPointer(contexts, "contexts", n);
        c::checkPointer(words, "words", n);
        for (unsigned i = 0; i < count; ++i) {
            const SampleCtx sc = c::contexts(contexts)[i];
            const SeededPoint point =
                domain.generator == WELLSTRAT_LONG ? longPoint(sc, order) : bluePoint(sc, order);
            for (const Coordinate axis : {Coordinate::x, Coordinate::y, Coordinate::z}) {
                *words++ = scrambledBits(digitsOf(point.digits, axis), point.seed, axis);
            }
        }
    });
}
