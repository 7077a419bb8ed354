// SPDX-License-Identifier: Apache-2.0
//
// Functions of the C interface: where contexts and domains begin, and how they are derived.

#include "c/batch.h"
#include "c/call.h"
#include "c/generators.h"
#include "wellstrat/blue_domain.h"
#include "wellstrat/c.h"
#include "wellstrat/camera.h"

#include <cstddef>

namespace wellstrat {
inline namespace stream1 {
namespace {

static_assert(WELLSTRAT_PIXEL_FILTER_SCRAMBLE == static_cast<unsigned>(kPixelFilterScramble) &&
                  WELLSTRAT_LENS_SCRAMBLE == static_cast<unsigned>(kLensScramble) &&
                  WELLSTRAT_TIME_SCRAMBLE == static_cast<unsigned>(kTimeScramble),
              "C has the scrambles of camera.h");
static_assert(sizeof(wellstrat_domain) == 8 && offsetof(wellstrat_domain, slot) == 4 &&
                  offsetof(wellstrat_domain, splits) == 6,
              "foreign callers know the layout");

wellstrat_context inC(SampleCtx context) { return {context.patternid, context.sampleid}; }

/// The arguments that all derivations have. `childrenName` is what the function calls `children`.
struct Derivation {
    const char* function;
    wellstrat_domain parent;
    Scramble scramble;
    std::size_t n;
    const wellstrat_context* parents;
    wellstrat_domain* child;
    wellstrat_context* children;
    const char* childrenName;
};

/// `split` as deriveOrder has it; derive(generator, order, n) derives n contexts, 1 or more.
template <class Derive>
int derived(const Derivation& to, unsigned split, const Derive& derive) {
    return c::guarded(to.function, [&] {
        const Generator& generator = c::generatorOf(to.parent);
        const Order order = c::orderOf(to.parent);
        const unsigned n = c::checkedCount(to.n);
        c::checkPointer(to.parents, "parents", n);
        c::checkPointer(to.child, "child");
        c::checkPointer(to.children, to.childrenName, n);

        const Order childOrder = generator.ChildOrder(order, to.scramble, split);
        if (n > 0) derive(generator, order, n);
        *to.child = {to.parent.generator, childOrder.slot, childOrder.splits};
    });
}

int derivedBySplit(const Derivation& to, unsigned newnumsamples) {
    return derived(to, newnumsamples, [&](const Generator& generator, Order order, unsigned n) {
        generator.MultiNewDomainSplit(n, *c::contexts(to.parents), order, to.scramble,
                                      newnumsamples, c::contexts(to.children));
    });
}

int derivedByDistrib(const Derivation& to, unsigned newsampleid) {
    return derived(to, 0, [&](const Generator& generator, Order order, unsigned n) {
        generator.MultiNewDomainDistrib(n, *c::contexts(to.parents), order, to.scramble,
                                        newsampleid, c::contexts(to.children));
    });
}

} // namespace
} // namespace stream1
} // namespace wellstrat

using namespace wellstrat;

wellstrat_context wellstrat_camera_context(int32_t x, int32_t y, uint32_t frame, uint32_t sampleid,
                                           uint32_t seed) {
    return inC(cameraContext(x, y, frame, sampleid, seed));
}

wellstrat_context wellstrat_blue_context(int32_t x, int32_t y, uint32_t seed, uint32_t sampleid) {
    return inC(blueContext(x, y, seed, sampleid));
}

int wellstrat_camera_domain(uint32_t generator, wellstrat_domain* domain) {
    return c::guarded(__func__, [&] {
        const Order root;
        const wellstrat_domain camera = {generator, root.slot, root.splits};
        c::generatorOf(camera);
        c::checkPointer(domain, "domain");
        *domain = camera;
    });
}

uint32_t wellstrat_joint_scramble(uint32_t slot) {
    return static_cast<uint32_t>(jointScramble(slot));
}

int wellstrat_new_domain(wellstrat_domain parent, uint32_t scramble, wellstrat_context context,
                         wellstrat_domain* child, wellstrat_context* newcontext) {
    return derivedBySplit(
        {__func__, parent, Scramble{scramble}, 1, &context, child, newcontext, "newcontext"}, 1);
}

int wellstrat_new_domain_split(wellstrat_domain parent, uint32_t scramble, uint32_t newnumsamples,
                               wellstrat_context context, wellstrat_domain* child,
                               wellstrat_context* newcontext) {
    return derivedBySplit(
        {__func__, parent, Scramble{scramble}, 1, &context, child, newcontext, "newcontext"},
        newnumsamples);
}

int wellstrat_new_domain_distrib(wellstrat_domain parent, uint32_t scramble, uint32_t newsampleid,
                                 wellstrat_context context, wellstrat_domain* child,
                                 wellstrat_context* newcontext) {
    return derivedByDistrib(
        {__func__, parent, Scramble{scramble}, 1, &context, child, newcontext, "newcontext"},
        newsampleid);
}

int wellstrat_new_domains(wellstrat_domain parent, uint32_t scramble, size_t n,
                          const wellstrat_context* parents, wellstrat_domain* child,
                          wellstrat_context* children) {
    return derivedBySplit(
        {__func__, parent, Scramble{scramble}, n, parents, child, children, "children"}, 1);
}

int wellstrat_new_domains_split(wellstrat_domain parent, uint32_t scramble, uint32_t newnumsamples,
                                size_t n, const wellstrat_context* parents, wellstrat_domain* child,
                                wellstrat_context* children) {
    return derivedBySplit(
        {__func__, parent, Scramble{scramble}, n, parents, child, children, "children"},
        newnumsamples);
}

int wellstrat_new_domains_distrib(wellstrat_domain parent, uint32_t scramble, uint32_t newsampleid,
                                  size_t n, const wellstrat_context* parents,
                                  wellstrat_domain* child, wellstrat_context* children) {
    return derivedByDistrib(
        {__func__, parent, Scramble{scramble}, n, parents, child, children, "children"},
        newsampleid);
}
