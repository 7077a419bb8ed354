// SPDX-License-Identifier: Apache-2.0
//
// Functions of the C interface: samples.

#include "c/batch.h"
#include "c/call.h"
#include "c/generators.h"
#include "wellstrat/batch.h"
#include "wellstrat/c.h"
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
        const auto drawBits =
            domain.generator == WELLSTRAT_LONG ? drawSequenceBits3D : drawBlueBits3D;
        drawBits(count, c::contexts(contexts), order, reinterpret_cast<Bits3*>(words));
    });
}
