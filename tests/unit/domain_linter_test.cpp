// SPDX-License-Identifier: Apache-2.0
//
// The linter, on integrators without a fault and with each of them.

#include "wellstrat/domain_linter.h"

#include "RixRNG.h"
#include "wellstrat/blue.h"
#include "wellstrat/camera.h"
#include "wellstrat/joint.h"
#include "wellstrat/long.h"
#include "wellstrat/random_generator.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <thread>
#include <vector>

namespace wellstrat {
namespace {

using Fault = DomainLinter::Fault;

constexpr Scramble kHit{0x03707344}, kLight{0xa4093822}, kBxdf{0x082efa98}, kGlossy{0x299f31d0},
    kVolume{0xec4e6c89};

/// What the integrator below does wrong.
enum class Plant {
    nothing,
    lightAndBxdfShareAScramble,
    sampleDrawnAgainIn3D,
    contextsCopied,
    hitsNotDerived,
    shortSplit,
    longSplit,
    slotAtEveryBounce,
    sampleidsSkipped,
    sampleidForgotten,
};

/// Traces paths through a row of pixels and draws all that a path tracer would, from splits,
/// distribution, and slots. Paths die and are compacted away.
class Integrator {
public:
    unsigned pixels = 8, samples = 6, bounces = 4;
    bool byHand = false; ///< derive what follows the camera without the RixRNG's help
    bool slots = false;
    bool blue = false; ///< contexts of a BlueProgressive
    Plant plant = Plant::nothing;

    void trace(const Generator* generator) const {
        for (unsigned s = 0; s < samples; ++s) {
            const bool forgets = plant == Plant::sampleidForgotten && s == 2;
            const bool skips = plant == Plant::sampleidsSkipped;
            tracePass(generator, forgets ? s - 1 : skips ? s * 2 : s);
        }
    }

private:
    using Contexts = std::vector<SampleCtx>;

    void tracePass(const Generator* generator, unsigned sampleid) const {
        Contexts contexts(pixels);
        for (unsigned i = 0; i < pixels; ++i) {
            contexts[i] = blue ? blueContext(static_cast<int>(i), 7, 1, sampleid)
                               : cameraContext(static_cast<int>(i), 7, 1, sampleid);
        }
        RixRNG rng(contexts.data(), pixels, generator);
        Contexts domain(pixels);
        draw2D(RixRNG(rng, kPixelFilterScramble, domain.data()));
        draw2D(RixRNG(rng, slots ? jointScramble(0) : kLensScramble, domain.data()));
        RixRNG time(rng, kTimeScramble, domain.data());
        for (unsigned i = 0; i < pixels; ++i) time.DrawSample1D(i);
        for (unsigned bounce = 0; bounce < bounces && rng.numPts > 0; ++bounce) {
            rng.numPts = compacted(rng, bounce);
            if (byHand) {
                rng.NewDomains(kHit, contexts.data());
            } else if (plant != Plant::hitsNotDerived || bounce == 0) {
                rng = RixRNG(rng, kHit, contexts.data());
            }
            shade(rng, bounce, domain);
        }
    }

    static void draw2D(const RixRNG& rng) {
        std::vector<RtFloat2> xi(rng.numPts);
        rng.DrawSamples2D(xi.data());
    }

    /// Some paths end; the contexts of the others move to the front.
    static unsigned compacted(const RixRNG& rng, unsigned bounce) {
        unsigned left = 0;
        for (unsigned i = 0; i < rng.numPts; ++i) {
            const SampleCtx sc = rng.sampleCtxArray[i];
            if (HashToRandom(sc.patternid, sc.sampleid + 1000 * bounce) < 0.8f) {
                rng.sampleCtxArray[left++] = sc;
            }
        }
        return left;
    }

    void shade(const RixRNG& hits, unsigned bounce, Contexts& domain) const {
        const unsigned taken = plant == Plant::shortSplit ? 3 : plant == Plant::longSplit ? 5 : 4;
        std::vector<RtFloat2> xi(pixels);
        RixRNG light(hits, kLight, domain.data(), RixRNG::Split{4});
        for (unsigned k = 0; k < taken; ++k) light.GenerateSamples2D(xi.data());

        Contexts bxdfContexts(pixels);
        const bool first = bounce == 0;
        const bool slot = slots && (first || plant == Plant::slotAtEveryBounce);
        const Scramble bxdfScramble = slot ? jointScramble(1) : kBxdf;
        RixRNG bxdf(hits, bxdfScramble, bxdfContexts.data());
        if (plant == Plant::contextsCopied) {
            const RixRNG volume(hits, kVolume, domain.data());
            std::copy_n(domain.data(), hits.numPts, bxdfContexts.data());
            draw2D(volume);
        }
        std::vector<float> lobes(pixels);
        draw2D(bxdf);
        bxdf.DrawSamples1D(lobes.data()); // z of the same points
        if (plant == Plant::sampleDrawnAgainIn3D) {
            for (unsigned i = 0; i < bxdf.numPts; ++i) bxdf.DrawSample3D(i);
        }
        if (plant == Plant::lightAndBxdfShareAScramble) {
            draw2D(RixRNG(hits, bxdfScramble, domain.data()));
        }
        distribute(hits);
    }

    /// Each point takes another number of samples, which have domains of their own.
    static void distribute(const RixRNG& hits) {
        for (unsigned i = 0; i < hits.numPts; ++i) {
            SampleCtx one = hits.sampleCtxArray[i], glossy;
            RixRNG rng(RixRNG(hits, &one, 1), kGlossy, &glossy, RixRNG::Distrib{0});
            const unsigned count = hits.sampleCtxArray[i].patternid % 4;
            for (unsigned k = 0; k < count; ++k) {
                SampleCtx light[2];
                RixRNG lights(rng, kLight, light, RixRNG::Split{2});
                for (int twice = 0; twice < 2; ++twice) lights.GenerateSample2D(0);
                rng.GenerateSample3D(0);
            }
        }
    }
};

std::vector<DomainLinter::Finding> findings(const Integrator& integrator) {
    const DomainLinter linter;
    integrator.trace(&linter);
    EXPECT_EQ(linter.report().rfind("no faults", 0) == 0, linter.findings().empty());
    return linter.findings();
}

std::vector<DomainLinter::Finding> findings(Plant plant) {
    Integrator integrator;
    integrator.plant = plant;
    return findings(integrator);
}

std::string textOf(const std::vector<DomainLinter::Finding>& list) {
    std::string text;
    for (const auto& finding : list) text += finding.message + "\n";
    return text;
}

/// Exactly one finding has this fault and contains these words, and no finding has another fault.
void expectOnly(const std::vector<DomainLinter::Finding>& list, Fault fault,
                const std::string& words, uint64_t count = 0) {
    unsigned found = 0;
    for (const auto& finding : list) {
        EXPECT_EQ(finding.fault, fault) << finding.message;
        if (finding.message.find(words) == std::string::npos) continue;
        ++found;
        if (count > 0) {
            EXPECT_EQ(finding.count, count);
        }
        EXPECT_GT(finding.count, 0u);
    }
    EXPECT_EQ(found, 1u) << words << " in\n" << textOf(list);
}

TEST(DomainLinter, FindsNothingInAFaultlessIntegrator) {
    for (const bool byHand : {false, true}) {
        for (const unsigned pixels : {1u, 8u, 200u}) {
            Integrator integrator;
            integrator.pixels = pixels;
            integrator.byHand = byHand;
            EXPECT_EQ(textOf(findings(integrator)), "") << pixels << " pixels, " << byHand;
        }
    }
}

TEST(DomainLinter, SaysHowMuchItSaw) {
    const DomainLinter linter;
    EXPECT_EQ(linter.report(), "no faults in 0 draws of 0 domains\n");
    SampleCtx contexts[3] = {{1, 0}, {2, 0}, {3, 0}}, lens[3];
    const RixRNG camera(contexts, 3, &linter);
    float xi[3];
    camera.DrawSamples1D(xi);
    RixRNG(camera, kLensScramble, lens).DrawSample2D(1);
    EXPECT_EQ(linter.report(), "no faults in 4 draws of 2 domains\n");
}

TEST(DomainLinter, FindsDomainsDrawnTwice) {
    expectOnly(findings(Plant::lightAndBxdfShareAScramble), Fault::drawnTwice,
               "camera > 0x03707344 > 0x082efa98: one 2D sample");
    expectOnly(findings(Plant::sampleDrawnAgainIn3D), Fault::drawnTwice,
               "camera > 0x03707344 > 0x03707344 > 0x082efa98: one 3D sample");
    expectOnly(findings(Plant::hitsNotDerived), Fault::drawnTwice,
               "camera > 0x03707344 > 0xa4093822 split 4: one 2D sample");
}

TEST(DomainLinter, FindsDomainsDrawnTwiceBelowDistribution) {
    const DomainLinter linter;
    for (unsigned s = 0; s < 5; ++s) {
        SampleCtx camera{77, s}, glossy, light;
        const RixRNG rng(&camera, 1, &linter);
        RixRNG distributed(rng, kGlossy, &glossy, RixRNG::Distrib{0});
        for (unsigned k = 0; k < 3; ++k) {
            distributed.GenerateSample2D(0);
            const RixRNG lights(distributed, kLight, &light);
            lights.DrawSample1D(0);
            lights.DrawSample1D(0);
        }
    }
    expectOnly(linter.findings(), Fault::drawnTwice,
               "camera > 0x299f31d0 distribution > 0xa4093822: one 1D sample", 15);
}

TEST(DomainLinter, FindsCopiedContexts) {
    const auto list = findings(Plant::contextsCopied);
    expectOnly(list, Fault::samePattern,
               "camera > 0x03707344 > 0x082efa98 and camera > 0x03707344 > 0xec4e6c89: ");
    bool isCamera = false;
    for (int x = 0; x < 8; ++x) {
        isCamera |= list.at(0).path.patternid == cameraContext(x, 7, 1, 0).patternid;
    }
    EXPECT_TRUE(isCamera) << "the path that is named is one that there is";
}

/// What follows from one fault is one finding, which names where it happened.
TEST(DomainLinter, NamesTheDomainsWherePatternsMeet) {
    const DomainLinter linter;
    SampleCtx camera{77, 3}, a, b, child;
    const RixRNG rng(&camera, 1, &linter);
    RixRNG(rng, kLensScramble, &child).DrawSample2D(0);
    const RixRNG bxdf(rng, kBxdf, &a);
    const RixRNG light(rng, kLight, &b);
    b = a;
    for (const Scramble scramble : {kVolume, kGlossy}) {
        RixRNG(bxdf, scramble, &child, RixRNG::Split{1}).DrawSample2D(0);
        RixRNG(light, scramble, &child).DrawSample2D(0);
    }
    expectOnly(linter.findings(), Fault::samePattern,
               "camera > 0x082efa98 and camera > 0xa4093822: one pattern");
    EXPECT_EQ(linter.findings().front().path.patternid, 77u);
    EXPECT_EQ(linter.findings().front().path.sampleid, 3u);
}

/// Two domains that draw from 4000 patterns each, `shared` of which are the same.
std::string patternsShared(unsigned shared) {
    constexpr unsigned kPatterns = 4000;
    const DomainLinter linter;
    std::vector<SampleCtx> a(kPatterns), b(kPatterns), contexts(kPatterns);
    const RixRNG camera(contexts.data(), kPatterns, &linter);
    const RixRNG bxdf(camera, kBxdf, a.data()), light(camera, kLight, b.data());
    for (unsigned i = 0; i < kPatterns; ++i) {
        a[i] = {i, 0};
        b[i] = {i + kPatterns - shared, 0};
    }
    std::vector<float> xi(kPatterns);
    bxdf.DrawSamples1D(xi.data());
    light.DrawSamples1D(xi.data());
    return textOf(linter.findings());
}

/// Of random patterns, one pair coincides with probability 0.004, and four with 10^-11.
TEST(DomainLinter, LetsFewPatternsCoincideByChance) {
    EXPECT_EQ(patternsShared(0), "");
    EXPECT_EQ(patternsShared(1), "");
    EXPECT_EQ(patternsShared(4), "camera > 0x082efa98 and camera > 0xa4093822: one pattern\n");
}

TEST(DomainLinter, FindsSplitsThatDrawAnotherCount) {
    expectOnly(findings(Plant::shortSplit), Fault::splitCount,
               "camera > 0x03707344 > 0xa4093822 split 4: visits draw fewer than 4 samples");
    expectOnly(findings(Plant::longSplit), Fault::splitCount,
               "camera > 0x03707344 > 0xa4093822 split 4: visits draw more than 4 samples");
}

/// Draws `taken` of a split by 4 and nothing else.
std::string splitAlone(unsigned taken, unsigned paths) {
    const DomainLinter linter;
    for (unsigned s = 0; s < paths; ++s) {
        SampleCtx camera{77, s}, light;
        RixRNG rng(RixRNG(&camera, 1, &linter), kLight, &light, RixRNG::Split{4});
        for (unsigned k = 0; k < taken; ++k) rng.GenerateSample2D(0);
    }
    return textOf(linter.findings());
}

TEST(DomainLinter, JudgesASplitThatIsAllThereIs) {
    EXPECT_EQ(splitAlone(4, 5), "");
    EXPECT_EQ(splitAlone(4, 1), "");
    const std::string name = "camera > 0xa4093822 split 4: visits draw ";
    EXPECT_EQ(splitAlone(3, 5), name + "fewer than 4 samples\n");
    EXPECT_EQ(splitAlone(1, 1), name + "fewer than 4 samples\n");
    for (const unsigned taken : {5u, 6u, 7u, 8u, 12u}) {
        EXPECT_EQ(splitAlone(taken, 5), name + "more than 4 samples\n") << taken;
    }
}

/// Domains below a split take only those of its samples whose paths go on.
TEST(DomainLinter, LetsPathsEndBelowASplit) {
    const DomainLinter linter;
    for (unsigned s = 0; s < 8; ++s) {
        SampleCtx camera{77, s}, lens, direction, hit;
        const RixRNG rng(&camera, 1, &linter);
        RixRNG(rng, kLensScramble, &lens).DrawSample2D(0);
        RixRNG directions(rng, kBxdf, &direction, RixRNG::Split{3});
        for (unsigned k = 0; k < 3; ++k) {
            directions.DrawSample2D(0);
            if ((s + k) % 3 == 1) RixRNG(directions, kHit, &hit).DrawSample2D(0);
            if ((s + k) % 4 == 1) { // the same by hand
                hit = directions.NewDomain(0, kVolume);
                RixRNG(directions, &hit, 1).DrawSample2D(0);
            }
            ++direction.sampleid;
        }
    }
    EXPECT_EQ(textOf(linter.findings()), "");
}

TEST(DomainLinter, FindsSlotsTakenTwice) {
    Integrator integrator;
    integrator.slots = true;
    integrator.plant = Plant::slotAtEveryBounce;
    const std::string words =
        "slot 1 twice on a path: camera > 0x03707344 > 0x03707344 > 0x6a6f696f (slot 1) and "
        "camera > 0x03707344 > 0x6a6f696f (slot 1)";
    expectOnly(findings(integrator), Fault::slotTwice, words);
    const JointProgressive joint;
    const DomainLinter linter(&joint);
    integrator.trace(&linter);
    expectOnly(linter.findings(), Fault::slotTwice, words);
}

/// The way back to the camera's context is the generator's. All pixels are of one tile, in which
/// coincidences are one.
TEST(DomainLinter, KnowsHowBlueDomainsAreDerived) {
    const BlueProgressive blue;
    const auto findingsOf = [&](Plant plant) {
        Integrator integrator;
        integrator.slots = integrator.blue = true;
        integrator.plant = plant;
        const DomainLinter linter(&blue);
        integrator.trace(&linter);
        return linter.findings();
    };
    EXPECT_EQ(textOf(findingsOf(Plant::nothing)), "");
    expectOnly(findingsOf(Plant::slotAtEveryBounce), Fault::slotTwice,
               "slot 1 twice on a path: camera > 0x03707344 > 0x03707344 > 0x6a6f696f (slot 1) and "
               "camera > 0x03707344 > 0x6a6f696f (slot 1)");
    for (const auto& [plant, fault] : {std::pair(Plant::contextsCopied, Fault::samePattern),
                                       std::pair(Plant::shortSplit, Fault::splitCount),
                                       std::pair(Plant::sampleidsSkipped, Fault::skipped)}) {
        const std::vector<DomainLinter::Finding> findings = findingsOf(plant);
        ASSERT_FALSE(findings.empty());
        EXPECT_EQ(findings.front().fault, fault) << textOf(findings);
    }
}

/// Slots have no meaning below distribution and below large splits.
TEST(DomainLinter, LetsSlotsBeOrdinaryWhereTheyAre) {
    const DomainLinter linter;
    SampleCtx camera{77, 3}, parent, slot;
    const RixRNG rng(&camera, 1, &linter);
    RixRNG(rng, jointScramble(2), &slot).DrawSample2D(0);
    RixRNG(RixRNG(rng, kGlossy, &parent, RixRNG::Distrib{0}), jointScramble(2), &slot)
        .DrawSample2D(0);
    RixRNG(RixRNG(rng, kVolume, &parent, RixRNG::Split{kMaxJointSplit + 1}), jointScramble(2),
           &slot)
        .DrawSample2D(0);
    EXPECT_EQ(textOf(linter.findings()), "");
    RixRNG(RixRNG(rng, kBxdf, &parent, RixRNG::Split{kMaxJointSplit}), jointScramble(2), &slot)
        .DrawSample2D(0);
    expectOnly(linter.findings(), Fault::slotTwice, "slot 2 twice on a path: ");
}

/// What an integrator does that makes an array of its own for some of a slot's points, and fills it
/// by hand: a new domain, or the slot's own.
TEST(DomainLinter, FindsSlotsThatAViewLoses) {
    for (const bool derives : {false, true}) {
        for (const bool raw : {false, true}) {
            const JointProgressive joint;
            const DomainLinter linter(&joint);
            SampleCtx camera[4] = {{77, 0}, {77, 1}, {77, 2}, {77, 3}}, slots[4], some[2];
            const RixRNG rng(camera, 4, &linter);
            const RixRNG slot(rng, jointScramble(2), slots);
            RtFloat2 xi[4];
            slot.DrawSamples2D(xi);
            const RixRNG view(slot, some, 2);
            for (unsigned k = 0; k < 2; ++k) {
                const unsigned i = 2 * k + 1;
                some[k] = slots[i];
                if (derives) some[k] = raw ? slots[i].NewDomain(kBxdf) : slot.NewDomain(i, kBxdf);
            }
            view.DrawSamples2D(xi);
            const auto list = linter.findings();
            const auto isLost = [](const auto& found) { return found.fault == Fault::slotLost; };
            EXPECT_EQ(std::count_if(list.begin(), list.end(), isLost), 1) << textOf(list);
            EXPECT_NE(textOf(list).find("camera > 0x6a6f6970 (view): contexts"), std::string::npos)
                << textOf(list);
        }
    }
}

/// The same by indices, and views of domains that have no slot to lose.
TEST(DomainLinter, LetsSubsetsAndOtherViewsBe) {
    const JointProgressive joint;
    const DomainLinter linter(&joint);
    SampleCtx camera[4] = {{77, 0}, {77, 1}, {77, 2}, {77, 3}}, slots[4], some[2], rest[2];
    const RixRNG rng(camera, 4, &linter);
    const RixRNG slot(rng, jointScramble(2), slots);
    RtFloat2 xi[4];
    const unsigned odd[] = {3, 1}, even[] = {0, 2};
    RixRNG(slot, odd, 2, some).DrawSamples2D(xi);
    RixRNG(slot, even, 2, rest).DrawSamples2D(xi);
    RixRNG(slot, kBxdf, odd, 2, some).DrawSamples2D(xi);
    RixRNG(slot, jointScramble(3), even, 2, rest, RixRNG::Split{1}).DrawSamples2D(xi);
    const RixRNG volume(rng, kVolume, slots);
    const RixRNG view(volume, some, 2);
    for (unsigned k = 0; k < 2; ++k) some[k] = slots[odd[k]];
    view.DrawSamples2D(xi);
    EXPECT_EQ(textOf(linter.findings()), "");
}

TEST(DomainLinter, FindsSkippedSampleids) {
    const auto list = findings(Plant::sampleidsSkipped);
    expectOnly(list, Fault::skipped, "sampleids are skipped", 5);
    EXPECT_EQ(list.front().path.sampleid, 1u);
}

/// A path drawn again is not a heap of domains drawn twice.
TEST(DomainLinter, FindsRepeatedPaths) {
    Integrator integrator;
    integrator.plant = Plant::sampleidForgotten; // 0, 1, 1, 3, ...: 1 again and no 2
    const auto list = findings(integrator);
    ASSERT_EQ(list.size(), 2u) << textOf(list);
    EXPECT_EQ(list[0].fault, Fault::skipped);
    EXPECT_EQ(list[0].path.sampleid, 2u);
    EXPECT_EQ(list[1].fault, Fault::repeated);
    EXPECT_EQ(list[1].path.sampleid, 1u);
    EXPECT_EQ(list[1].count, integrator.pixels);
}

TEST(DomainLinter, FindsPicturesDrawnAgain) {
    const DomainLinter linter;
    Integrator integrator;
    for (int pass = 0; pass < 3; ++pass) integrator.trace(&linter);
    expectOnly(linter.findings(), Fault::repeated, "whole paths are drawn again",
               uint64_t{integrator.pixels} * integrator.samples);
}

TEST(DomainLinter, FindsARepeatedSampleOfTheOnlyDomain) {
    const DomainLinter linter;
    for (const unsigned s : {4u, 5u, 5u, 6u}) {
        SampleCtx camera{77, s};
        RixRNG(&camera, 1, &linter).DrawSample2D(0);
    }
    expectOnly(linter.findings(), Fault::repeated, "whole paths are drawn again", 1);
}

TEST(DomainLinter, ForgetsWhenCleared) {
    DomainLinter linter;
    Integrator integrator;
    integrator.trace(&linter);
    linter.clear();
    EXPECT_EQ(linter.report(), "no faults in 0 draws of 0 domains\n");
    integrator.trace(&linter);
    EXPECT_EQ(textOf(linter.findings()), "");
}

/// All kinds of draws of `with` and of `without`, and of their children, are the same.
void expectSameSamples(const RixRNG& with, const RixRNG& without) {
    const unsigned n = with.numPts;
    std::vector<float> a1(n), b1(n);
    std::vector<RtFloat2> a2(n), b2(n);
    std::vector<RtFloat3> a3(n), b3(n);
    with.DrawSamples1D(a1.data());
    with.DrawSamples2D(a2.data());
    with.DrawSamples3D(a3.data());
    without.DrawSamples1D(b1.data());
    without.DrawSamples2D(b2.data());
    without.DrawSamples3D(b3.data());
    EXPECT_EQ(a1, b1);
    EXPECT_EQ(a2, b2);
    EXPECT_EQ(a3, b3);
    for (unsigned i = 0; i < n; ++i) {
        EXPECT_EQ(with.DrawSample1D(i), b1[i]);
        EXPECT_EQ(with.DrawSample2D(i), b2[i]);
        EXPECT_EQ(with.DrawSample3D(i), b3[i]);
    }
}

TEST(DomainLinter, PassesSamplesOn) {
    const JointProgressive joint;
    const RandomGenerator random;
    const LongProgressive longer;
    const BlueProgressive blue;
    const Generator* const inners[] = {nullptr, &joint, &random, &longer, &blue};
    for (const Generator* inner : inners) {
        const DomainLinter linter(inner);
        std::vector<SampleCtx> contexts(37), a(37), b(37), c(37), d(37);
        for (unsigned i = 0; i < 37; ++i) contexts[i] = {i * 99, i * i * i * 9};
        const RixRNG with(contexts.data(), 37, &linter);
        const RixRNG without(contexts.data(), 37, inner);
        expectSameSamples(with, without);
        const RixRNG slot(with, jointScramble(3), a.data(), RixRNG::Split{5});
        const RixRNG sameSlot(without, jointScramble(3), b.data(), RixRNG::Split{5});
        expectSameSamples(slot, sameSlot);
        expectSameSamples(RixRNG(slot, jointScramble(4), c.data()),
                          RixRNG(sameSlot, jointScramble(4), d.data()));
        expectSameSamples(RixRNG(slot, jointScramble(4), c.data(), RixRNG::Distrib{7}),
                          RixRNG(sameSlot, jointScramble(4), d.data(), RixRNG::Distrib{7}));
    }
}

TEST(DomainLinter, FindsNothingInSlotsUsedOnce) {
    Integrator integrator;
    integrator.slots = true;
    const JointProgressive joint;
    const DomainLinter linter(&joint);
    integrator.trace(&linter);
    EXPECT_EQ(textOf(linter.findings()), "");
}

/// Chains of any splits and contexts that were never derived are judged without a crash.
TEST(DomainLinter, SurvivesAnyContexts) {
    const DomainLinter linter;
    uint32_t state = 1;
    const auto random = [&state](uint32_t n) { return scaleToRange(state = mixBits(++state), n); };
    const unsigned splits[] = {0, 1, 2, 7, 1u << 16, 1u << 31, ~0u};
    for (int path = 0; path < 300; ++path) {
        SampleCtx sc{random(3), random(4) - 2}, next;
        RixRNG rng(&sc, 1, &linter);
        for (int depth = 0; depth < 5; ++depth) {
            const Scramble scramble{random(3)};
            const RixRNG::Split split{splits[random(7)]};
            rng = random(4) == 0 ? RixRNG(rng, scramble, &next, RixRNG::Distrib{random(2)})
                                 : RixRNG(rng, scramble, &next, split);
            if (random(4) == 0) next = {random(5), 0u - random(5)};
            if (random(2) == 0) rng.GenerateSample2D(0);
            if (random(2) == 0) rng.GenerateSample1D(0);
        }
    }
    EXPECT_GT(linter.findings().size(), 0u);
}

TEST(DomainLinter, FindsTheSameFromManyThreads) {
    Integrator integrator;
    integrator.plant = Plant::contextsCopied;
    const DomainLinter alone;
    const DomainLinter shared;
    for (int i = 0; i < 4; ++i) integrator.trace(&alone);
    std::vector<std::thread> threads;
    for (int i = 0; i < 4; ++i) threads.emplace_back([&] { integrator.trace(&shared); });
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(alone.report(), shared.report());
}

} // namespace
} // namespace wellstrat
