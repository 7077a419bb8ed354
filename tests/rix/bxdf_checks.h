// SPDX-License-Identifier: Apache-2.0
//
// What must hold of any Bxdf, measured as a renderer would see it: through its factory, in batches,
// with samples of a RixRNG.

#pragma once

#include "RixShadingUtils.h"
#include "check.h"
#include "shading_context.h"

#include <cmath>
#include <cstdlib>
#include <dlfcn.h>
#include <vector>

/// The Bxdf of this program, found by name as a renderer finds a plug-in: the programs are built
/// with hidden symbols, so that PRMANEXPORT is what makes it visible.
class Plugin {
public:
    Plugin() {
        void* create = dlsym(RTLD_DEFAULT, "CreateRixBxdfFactory");
        CHECK(create != nullptr);
        if (create == nullptr) std::exit(exitCode());
        factory = reinterpret_cast<RixBxdfFactory* (*)(const char*)>(create)("");
    }
    ~Plugin() {
        void* destroy = dlsym(RTLD_DEFAULT, "DestroyRixBxdfFactory");
        CHECK(destroy != nullptr);
        reinterpret_cast<void (*)(RixBxdfFactory*)>(destroy)(factory);
    }
    Plugin(Plugin const&) = delete;
    Plugin& operator=(Plugin const&) = delete;

    RixBxdfFactory* factory;
};

/// The surface of all points, whose normal is no axis and whose tangent leans.
const RtNormal3 k_surfaceNormal(0.6f, -0.48f, 0.64f);
const RtVector3 k_surfaceTangent(0.36f, 0.48f, 0.8f);

/// The direction at an angle from the normal with this cosine, and this azimuth.
inline RtVector3 surfaceDirection(RtFloat cosine, RtFloat phi = 0.5f) {
    RtVector3 X, Y;
    RixComputeShadingBasis(k_surfaceNormal, k_surfaceTangent, X, Y);
    RtFloat sine = std::sqrt(RixMax(0.f, 1.f - cosine * cosine));
    return RixSphericalDirection(sine, cosine, phi, X, Y, k_surfaceNormal);
}

/// What a Bxdf says of directions.
struct Response {
    std::vector<RtVector3> Ln;
    std::vector<RtColorRGB> W;
    std::vector<RtFloat> FPdf, RPdf;

    explicit Response(std::size_t n) : Ln(n), W(n), FPdf(n), RPdf(n) {}
};

/// A batch of points of the surface with a view each, and the Bxdf there.
class Scatter {
public:
    Scatter(RixBxdfFactory* bxdfFactory, std::vector<RtVector3> const& views)
        : factory(bxdfFactory), Vn(views), Nn(views.size(), k_surfaceNormal),
          Tn(views.size(), k_surfaceTangent), context{static_cast<RtInt>(Vn.size()), Vn.data(),
                                                      Nn.data(), Tn.data()},
          bsdf(factory->BeginScatter(&context)) {
        for (unsigned i = 0; i < Vn.size(); i++) contexts.push_back({0x51ab0c3du, i});
    }
    ~Scatter() { factory->EndScatter(bsdf); }
    Scatter(Scatter const&) = delete;
    Scatter& operator=(Scatter const&) = delete;

    Response generate() {
        Response r(Vn.size());
        RixRNG rng = domain();
        bsdf->GenerateSample(&rng, r.Ln.data(), r.W.data(), r.FPdf.data(), r.RPdf.data());
        return r;
    }
    Response evaluate(std::vector<RtVector3> const& Ln) {
        Response r(Vn.size());
        r.Ln = Ln;
        RixRNG rng = domain();
        bsdf->EvaluateSample(&rng, Ln.data(), r.W.data(), r.FPdf.data(), r.RPdf.data());
        return r;
    }

private:
    RixRNG domain() { return RixRNG(contexts.data(), static_cast<unsigned>(contexts.size())); }

    RixBxdfFactory* factory;
    std::vector<RtVector3> Vn;
    std::vector<RtNormal3> Nn;
    std::vector<RtVector3> Tn;
    RixShadingContext context;
    RixBsdf* bsdf;
    std::vector<RixRNG::SampleCtx> contexts;
};

/// Integrals over directions of the light: what a white furnace shows, on the side of the viewer
/// and on the other, and the density (at most 1: less if a Bxdf gives up on some samples).
struct Integral {
    RtColorRGB near, far;
    RtFloat density = 0.f;

    Integral() : near(0.f), far(0.f) {}
    void add(RtVector3 const& view, RtVector3 const& light, RtColorRGB const& W, RtFloat mass) {
        const RtFloat sides = Dot(view, k_surfaceNormal) * Dot(light, k_surfaceNormal);
        (sides > 0.f ? near : far) += W;
        density += mass;
    }
};

/// From the samples of a RixRNG, 4096 of one pattern.
inline Integral sampled(RixBxdfFactory* factory, RtVector3 const& view) {
    const std::size_t count = 4096;
    Scatter scatter(factory, std::vector<RtVector3>(count, view));
    const Response r = scatter.generate();
    const Response again = scatter.evaluate(r.Ln);
    Integral sum;
    const RtFloat share = 1.f / static_cast<RtFloat>(count);
    for (std::size_t i = 0; i < count; i++) {
        if (r.FPdf[i] <= 0.f) continue;
        CHECK(std::fabs(r.Ln[i].Length() - 1.f) < 1e-5f);
        // What is generated is what is evaluated, except for the rounding of directions.
        CHECK(std::fabs(again.FPdf[i] - r.FPdf[i]) <= 0.01f * r.FPdf[i]);
        CHECK(std::fabs(again.RPdf[i] - r.RPdf[i]) <= 0.01f * r.RPdf[i]);
        CHECK((again.W[i] - r.W[i]).ChannelMax() <= 0.01f * r.W[i].ChannelMax());
        CHECK((r.W[i] - again.W[i]).ChannelMax() <= 0.01f * r.W[i].ChannelMax());
        sum.add(view, r.Ln[i], r.W[i] * (share / r.FPdf[i]), share);
    }
    return sum;
}

/// By the midpoints of 256 x 512 equal steps of the polar angle and the azimuth, without samples.
inline Integral integrated(RixBxdfFactory* factory, RtVector3 const& view) {
    const int rows = 256, columns = 512;
    std::vector<RtVector3> Ln;
    std::vector<RtFloat> area;
    for (int i = 0; i < rows; i++) {
        RtFloat sinTheta, cosTheta;
        RixSinCos(F_PI * (static_cast<RtFloat>(i) + .5f) / rows, &sinTheta, &cosTheta);
        for (int j = 0; j < columns; j++) {
            const RtFloat phi = F_TWOPI * (static_cast<RtFloat>(j) + .5f) / columns;
            Ln.push_back(surfaceDirection(cosTheta, phi));
            area.push_back(sinTheta * (F_PI / rows) * (F_TWOPI / columns));
        }
    }
    Scatter scatter(factory, std::vector<RtVector3>(Ln.size(), view));
    const Response r = scatter.evaluate(Ln);
    Integral sum;
    for (std::size_t i = 0; i < Ln.size(); i++) {
        sum.add(view, Ln[i], r.W[i] * area[i], r.FPdf[i] * area[i]);
    }
    return sum;
}

inline bool closeTo(RtColorRGB const& a, RtColorRGB const& b, RtFloat tolerance) {
    return (a - b).ChannelMax() <= tolerance && (b - a).ChannelMax() <= tolerance;
}

/// Samples weighted by density give the integrals, and the density is theirs.
inline void checkSampling(RixBxdfFactory* factory, RtVector3 const& view, RtFloat tolerance) {
    const Integral samples = sampled(factory, view), exact = integrated(factory, view);
    CHECK(closeTo(samples.near, exact.near, tolerance));
    CHECK(closeTo(samples.far, exact.far, tolerance));
    CHECK(std::fabs(samples.density - exact.density) <= tolerance);
    CHECK(samples.density <= 1.f);
}

/// With viewer and light exchanged, the response is the same and the densities change places.
/// `outsideSquared` is the square of the refractive index inside over that outside: a radiance that
/// leaves through the surface is that much smaller (Veach 1997, section 5.2).
inline void checkReciprocity(RixBxdfFactory* factory, RtFloat outsideSquared = 1.f) {
    std::vector<RtVector3> views, lights;
    for (const RtFloat cosView : {-.95f, -.5f, -.2f, .2f, .5f, .95f}) {
        for (const RtFloat cosLight : {-.9f, -.6f, -.3f, .3f, .6f, .9f}) {
            for (const RtFloat phi : {.5f, 1.5f, 3.6f}) {
                views.push_back(surfaceDirection(cosView));
                lights.push_back(surfaceDirection(cosLight, phi));
            }
        }
    }
    Scatter forwardScatter(factory, views), reverseScatter(factory, lights);
    const Response forward = forwardScatter.evaluate(lights),
                   reverse = reverseScatter.evaluate(views);
    bool anyResponse = false;
    for (std::size_t i = 0; i < views.size(); i++) {
        const RtFloat cosView = Dot(k_surfaceNormal, views[i]);
        const RtFloat cosLight = Dot(k_surfaceNormal, lights[i]);
        const RtFloat scale = cosView * cosLight > 0.f ? 1.f
                              : cosView > 0.f          ? outsideSquared
                                                       : 1.f / outsideSquared;
        const RtColorRGB a = forward.W[i] * (scale / std::fabs(cosLight));
        const RtColorRGB b = reverse.W[i] / std::fabs(cosView);
        CHECK(closeTo(a, b, 1e-3f * a.ChannelMax()));
        // A density of nearly 0 is a small difference of large numbers.
        CHECK(std::fabs(forward.RPdf[i] - reverse.FPdf[i]) <= 1e-3f * reverse.FPdf[i] + 1e-6f);
        anyResponse |= a.ChannelMax() > 0.f;
    }
    CHECK(anyResponse);
}
