// SPDX-License-Identifier: Apache-2.0
//
// Which samples a path draws: those of the domain tree in renderer/README.md, each once. Guards
// against what no mean shows: two uses of one sample are as correlated in any generator.

#include "rendering.h"

#include "renderer/sampling_domains.h"
#include "wellstrat/camera.h"
#include "wellstrat/random_generator.h"

#include <algorithm>
#include <array>
#include <map>
#include <memory>
#include <mutex>
#include <utility>

namespace wellstrat::render {
namespace {

using SampleCtx = RixRNG::SampleCtx;

/// Random samples, and a list of all that were asked for.
class Recorder : public Generator {
public:
    float Sample1D(const SampleCtx& sc, unsigned i) const override {
        record(sc);
        return random_.Sample1D(sc, i);
    }
    Float2 Sample2D(const SampleCtx& sc, unsigned i) const override {
        record(sc);
        return random_.Sample2D(sc, i);
    }
    Float3 Sample3D(const SampleCtx& sc, unsigned i) const override {
        record(sc);
        return random_.Sample3D(sc, i);
    }

    /// How often the sample was drawn.
    unsigned count(SampleCtx sc) const {
        const auto found = counts_.find({sc.patternid, sc.sampleid});
        return found == counts_.end() ? 0 : found->second;
    }
    unsigned largestCount() const {
        unsigned largest = 0;
        for (const auto& entry : counts_) largest = std::max(largest, entry.second);
        return largest;
    }
    /// How often samples with this number were drawn, of all patterns.
    unsigned countAt(unsigned sampleid) const {
        unsigned sum = 0;
        for (const auto& [sample, count] : counts_) sum += sample.second == sampleid ? count : 0;
        return sum;
    }
    /// How many samples of a pattern were drawn.
    unsigned samplesOf(SampleCtx sc) const {
        unsigned sum = 0;
        for (const auto& entry : counts_) sum += entry.first.first == sc.patternid;
        return sum;
    }

private:
    void record(const SampleCtx& sc) const {
        const std::lock_guard<std::mutex> lock(mutex_);
        ++counts_[{sc.patternid, sc.sampleid}];
    }

    RandomGenerator random_;
    mutable std::mutex mutex_;
    mutable std::map<std::pair<unsigned, unsigned>, unsigned> counts_;
};

/// Listens to each slot of joint.h by itself.
class SlotRecorder final : public OrderedGenerator {
public:
    /// Of a slot, or with kJointSlots of all padded domains.
    const Recorder& of(unsigned slot) const { return recorders_[slot]; }

    float OrderedSample1D(const SampleCtx& sc, unsigned i, Order order) const override {
        return recorders_[order.slot].Sample1D(sc, i);
    }
    Float2 OrderedSample2D(const SampleCtx& sc, unsigned i, Order order) const override {
        return recorders_[order.slot].Sample2D(sc, i);
    }
    Float3 OrderedSample3D(const SampleCtx& sc, unsigned i, Order order) const override {
        return recorders_[order.slot].Sample3D(sc, i);
    }

private:
    std::array<Recorder, kJointSlots + 1> recorders_;
};

/// A white box with a lamp, from within, and an environment that is sampled but never seen: no path
/// ends early.
Scene closedBox() {
    Scene scene;
    addQuads(scene, box(Float3(0.0f), {1, 0, 0}, {0, 1, 0}, {0, 0, 1}),
             addMaterial(scene, lambertian(Float3(1.0f))));
    scene.spheres.push_back({{0.3f, 0.3f, 0.3f},
                             0.1f,
                             addMaterial(scene,
                                         [] {
                                             Material lamp = lambertian(Float3(0.9f));
                                             lamp.emission = Float3(1.0f);
                                             return lamp;
                                         }()),
                             {}});
    scene.environment.emplace().map =
        std::make_shared<Texture>(2, 1, std::vector<Float3>(2, Float3(1.0f)));
    scene.camera = lookAt({-0.5f, 0, 0}, {1, 0, 0}, {0, 1, 0}, 1.2f);
    return scene;
}

constexpr unsigned kSide = 3;
constexpr unsigned kSamples = 4;
constexpr unsigned kSeed = 5;

SamplingOptions listenedTo(const Generator& recorder, unsigned split, bool distrib) {
    SamplingOptions options = optionsOfDepth(2);
    options.generator = &recorder;
    options.seed = kSeed;
    options.split = split;
    options.distrib = distrib;
    return options;
}

void record(const Recorder& recorder, unsigned split, bool distrib) {
    renderFilm(closedBox(), kSide, kSamples, listenedTo(recorder, split, distrib));
}

/// Calls check(camera context) for all samples of the picture.
template <class Check>
void forEachSample(const Check& check) {
    for (int i = 0; i < static_cast<int>(kSide * kSide); ++i)
        for (unsigned s = 0; s < kSamples; ++s) {
            check(cameraContext(i % static_cast<int>(kSide), i / static_cast<int>(kSide), 0, s,
                                kSeed));
        }
}

TEST(Domains, AreThoseOfTheTree) {
    const Recorder recorder;
    record(recorder, 1, false);
    EXPECT_EQ(recorder.largestCount(), 1u);
    forEachSample([&](SampleCtx camera) {
        EXPECT_EQ(recorder.count(camera), 0u); // parents are not drawn from
        EXPECT_EQ(recorder.count(camera.NewDomain(kPixelFilterScramble)), 1u);
        EXPECT_EQ(recorder.count(camera.NewDomain(kLensScramble)), 1u);
        EXPECT_EQ(recorder.count(camera.NewDomain(kTimeScramble)), 1u);
        SampleCtx hit = camera;
        for (unsigned bounce = 0; bounce < 2; ++bounce) {
            hit = hit.NewDomain(kHitScramble);
            EXPECT_EQ(recorder.count(hit), 0u);
            for (const RixRNG::Scramble scramble :
                 {lightScramble(bounce), environmentScramble(bounce), bxdfScramble(bounce)}) {
                EXPECT_EQ(recorder.count(hit.NewDomain(scramble)), 1u) << bounce;
            }
        }
    });
}

/// The light samples of the first hits of a pixel use up one sequence from its beginning.
TEST(Domains, SplitLightSamplesAreConsecutive) {
    constexpr unsigned kSplit = 3;
    const Recorder recorder;
    record(recorder, kSplit, false);
    EXPECT_EQ(recorder.largestCount(), 1u);
    forEachSample([&](SampleCtx camera) {
        const SampleCtx hit = camera.NewDomain(kHitScramble);
        for (const RixRNG::Scramble scramble : {lightScramble(0), environmentScramble(0)}) {
            SampleCtx light = hit.NewDomainSplit(scramble, kSplit);
            EXPECT_EQ(light.sampleid, camera.sampleid * kSplit);
            for (unsigned i = 0; i < kSplit; ++i, ++light.sampleid) {
                EXPECT_EQ(recorder.count(light), 1u);
            }
            EXPECT_EQ(recorder.samplesOf(light), kSplit * kSamples);
        }
        EXPECT_EQ(recorder.count(hit.NewDomain(bxdfScramble(0))), 1u);
    });
}

/// Later hits have patterns of their own in each sample, and take as many as they are worth: here
/// all, for nothing was lost at the first hit but on the lamp.
TEST(Domains, DistributedLightSamplesBeginAtZero) {
    constexpr unsigned kSplit = 3;
    const Recorder recorder;
    record(recorder, kSplit, true);
    EXPECT_EQ(recorder.largestCount(), 1u);
    forEachSample([&](SampleCtx camera) {
        const SampleCtx hit = camera.NewDomain(kHitScramble).NewDomain(kHitScramble);
        for (const RixRNG::Scramble scramble : {lightScramble(1), environmentScramble(1)}) {
            const SampleCtx light = hit.NewDomainDistrib(scramble, 0);
            EXPECT_EQ(recorder.samplesOf(light), kSplit);
            EXPECT_EQ(recorder.count(light), 1u);
            EXPECT_EQ(recorder.samplesOf(hit.NewDomain(scramble)), 0u);
        }
    });
}

/// The numbers of samples fall with the throughput.
TEST(Domains, DistributionFollowsThroughput) {
    Scene scene = closedBox();
    scene.materials[0].baseColor = Float3(0.39f);
    scene.materials[1].baseColor = Float3(0.39f);
    const Recorder recorder;
    renderFilm(scene, 1, 1, listenedTo(recorder, 10, true));
    SampleCtx hit = cameraContext(0, 0, 0, 0, kSeed).NewDomain(kHitScramble);
    EXPECT_EQ(recorder.samplesOf(hit.NewDomain(lightScramble(0))), 10u);
    hit = hit.NewDomain(kHitScramble); // throughput 0.39
    EXPECT_EQ(recorder.samplesOf(hit.NewDomainDistrib(lightScramble(1), 0)), 4u);
    hit = hit.NewDomain(kHitScramble); // 0.1521
    EXPECT_EQ(recorder.samplesOf(hit.NewDomainDistrib(lightScramble(2), 0)), 2u);
}

/// Guards against slots that are taken twice on a path, which correlates the two uses: in one
/// pixel, whatever the splits, a slot has each sample once. The paths are long enough to need all
/// slots, and to go on without.
TEST(Domains, SlotsAreUsedOnceOnAPath) {
    constexpr unsigned kDepth = 8;
    for (const unsigned split : {1u, 3u}) {
        for (const bool distrib : {false, true}) {
            const SlotRecorder slots;
            SamplingOptions options = listenedTo(slots, split, distrib);
            options.depth = kDepth;
            renderFilm(closedBox(), 1, kSamples, options);
            const auto timesAt = [&](unsigned slot, unsigned most) { // some paths end early
                unsigned all = 0;
                for (unsigned s = 0; s < split * kSamples; ++s) {
                    const unsigned times = slots.of(slot).countAt(s);
                    EXPECT_LE(times, most) << "slot " << slot << ", sample " << s;
                    all += times;
                }
                return all;
            };
            for (unsigned slot = 0; slot < kJointSlots; ++slot) {
                EXPECT_TRUE(timesAt(slot, 1) > 0 || distrib) << "slot " << slot;
            }
            EXPECT_GT(timesAt(kJointSlots, ~0u), 0u);
        }
    }
}

} // namespace
} // namespace wellstrat::render
