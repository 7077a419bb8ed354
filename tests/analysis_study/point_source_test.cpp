// SPDX-License-Identifier: Apache-2.0
//
// The sources of points: what a study relies on, and what each is known for.

#include "wellstrat/analysis/nets.h"
#include "wellstrat/analysis/point_source.h"
#include "wellstrat/joint.h"
#include "wellstrat/long.h"
#include "wellstrat/lookup.h"
#include "wellstrat/random_generator.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace wellstrat {
namespace {

using Points = std::vector<double>;

Points drawn(const PointSource& source, uint32_t pattern, const DomainDims& domains,
             std::size_t count) {
    Points points(count * totalDims(domains), -1);
    source.draw(pattern, domains, count, points.data());
    return points;
}

std::vector<std::pair<std::string, PointSourcePtr>> allSources() {
    static const RandomGenerator random;
    std::vector<std::pair<std::string, PointSourcePtr>> sources;
    sources.emplace_back("pmj", generatorSource(nullptr));
    sources.emplace_back("random", generatorSource(&random));
    static const LongProgressive longSamples;
    sources.emplace_back("joint", jointSource());
    sources.emplace_back("long", generatorSource(&longSamples));
    sources.emplace_back("long-words", sequenceSource());
    sources.emplace_back("long slots", jointSource({}, &longSamples));
    sources.emplace_back("sobol", sobolSource(SobolRandomization::none));
    sources.emplace_back("sobol-shift", sobolSource(SobolRandomization::digitalShift));
    sources.emplace_back("sobol-owen", sobolSource(SobolRandomization::owen));
    sources.emplace_back("halton", haltonSource());
    sources.emplace_back("jitter", jitteredSource());
    return sources;
}

/// The coordinates of one domain alone.
Points domainOf(const Points& points, const DomainDims& domains, std::size_t domain) {
    const unsigned dims = totalDims(domains);
    std::size_t first = 0;
    for (std::size_t d = 0; d < domain; ++d) first += domains[d];
    Points part;
    for (std::size_t i = 0; i < points.size(); i += dims) {
        part.insert(part.end(), points.begin() + std::ptrdiff_t(i + first),
                    points.begin() + std::ptrdiff_t(i + first + domains[domain]));
    }
    return part;
}

const DomainDims kMixed{2, 1, 3, 2};

TEST(PointSource, FillsAllCoordinatesInTheUnitInterval) {
    for (const auto& [name, source] : allSources()) {
        for (const std::size_t count : {0u, 1u, 2u, 7u, 100u, 1024u}) {
            for (const double value : drawn(*source, 5, kMixed, count)) {
                ASSERT_TRUE(value >= 0 && value < 1) << name << ' ' << value;
            }
        }
    }
}

/// Guards against a study that reads prefixes of points that are not those of a smaller draw.
TEST(PointSource, PrefixesAreSmallerDrawsIfItSaysSo) {
    for (const auto& [name, source] : allSources()) {
        const Points all = drawn(*source, 3, kMixed, 1000);
        for (const std::size_t count : {1u, 17u, 512u}) {
            const Points fewer = drawn(*source, 3, kMixed, count);
            EXPECT_EQ(std::equal(fewer.begin(), fewer.end(), all.begin()), source->isProgressive())
                << name;
        }
    }
}

TEST(PointSource, PatternsDifferUnlessNothingIsRandom) {
    for (const auto& [name, source] : allSources()) {
        EXPECT_EQ(drawn(*source, 1, {2}, 64), drawn(*source, 1, {2}, 64)) << name;
        EXPECT_EQ(drawn(*source, 1, {2}, 64) == drawn(*source, 2, {2}, 64), name == "sobol");
    }
}

/// Guards against domains in lockstep, and against a shuffle that is no permutation of each block.
TEST(PointSource, DomainsHoldTheSameNetsInAnotherOrder) {
    for (const auto& [name, source] : allSources()) {
        if (name == "random" || name == "halton" || name == "jitter") continue;
        const Points points = drawn(*source, 9, {2, 2, 2}, 1024);
        for (std::size_t domain = 0; domain < 3; ++domain) {
            const Points part = domainOf(points, {2, 2, 2}, domain);
            const PointSet set = PointSet::fromFloats(part.data(), 1024, 2);
            EXPECT_TRUE(checkSequence(set, 0).holds()) << name;
            EXPECT_TRUE(domain == 0 || part != domainOf(points, {2, 2, 2}, 0)) << name;
        }
    }
}

/// With two domains of N stratified points in lockstep or in mirrored order, the pairs of strata
/// repeat; paired at random, about 16 (1 - e^-4) of the 16 x 16 are hit by 1024 pairs: nearly all.
TEST(PointSource, DomainsPairAsIndependentOnes) {
    for (const auto& [name, source] : allSources()) {
        const Points points = drawn(*source, 4, {1, 1}, 1024);
        std::vector<bool> hit(256);
        for (std::size_t i = 0; i < points.size(); i += 2) {
            hit[std::size_t(points[i] * 16) * 16 + std::size_t(points[i + 1] * 16)] = true;
        }
        EXPECT_GT(std::count(hit.begin(), hit.end(), true), 235) << name;
    }
}

TEST(PointSource, DrawsTheSamplesThatRenderersDraw) {
    const Points points = drawn(*generatorSource(nullptr), 77, {2, 1, 3}, 100);
    for (unsigned i = 0; i < 100; ++i) {
        const auto context = [i](unsigned domain) {
            return SampleCtx{77, i}.NewDomain(static_cast<Scramble>(domain));
        };
        const Float2 xy = sample2D(context(0).patternid, i);
        const float z = sample1D(context(1).patternid, i);
        const Float3 xyz = sample3D(context(2).patternid, i);
        const Points expected{double(xy.x),  double(xy.y),  double(z),
                              double(xyz.x), double(xyz.y), double(xyz.z)};
        EXPECT_EQ(Points(points.begin() + 6 * i, points.begin() + 6 * i + 6), expected);
    }
}

/// The words are those that floats are cut from.
TEST(PointSource, WordsAreTheSamplesOfLong) {
    const LongProgressive longSamples;
    const Points words = drawn(*sequenceSource(), 77, {2, 1, 3}, 1000);
    const Points floats = drawn(*generatorSource(&longSamples), 77, {2, 1, 3}, 1000);
    for (std::size_t i = 0; i < words.size(); ++i) {
        EXPECT_EQ(std::floor(words[i] * 0x1p24) * 0x1p-24, floats[i]);
        EXPECT_EQ(std::fmod(words[i] * 0x1p32, 1), 0.5);
    }
}

TEST(PointSource, JointDrawsFromTheSlotsAndThenPadded) {
    const PointSourcePtr all = jointSource(), some = jointSource({7, 2});
    const Points first = drawn(*all, 77, {2, 1}, 5000), second = drawn(*some, 77, {2, 1, 3}, 5000);
    const auto patternOf = [](Scramble s) { return SampleCtx{77, 0}.NewDomain(s).patternid; };
    const auto point = [&](unsigned slot, unsigned i) {
        return jointSample3D(tables(), patternOf(jointScramble(slot)), i, slot, 1);
    };
    for (unsigned i = 0; i < 5000; ++i) {
        EXPECT_EQ(first[3 * i], double(point(0, i).x));
        EXPECT_EQ(first[3 * i + 2], double(point(1, i).z));
        EXPECT_EQ(second[6 * i + 1], double(point(7, i).y));
        EXPECT_EQ(second[6 * i + 2], double(point(2, i).z));
        EXPECT_EQ(second[6 * i + 3], double(sample2D(patternOf(static_cast<Scramble>(2)), i).x));
    }
    EXPECT_THROW(jointSource({0, 16}), std::invalid_argument);
    EXPECT_THROW(jointSource({3, 4, 3}), std::invalid_argument);
}

/// In base b the first b^k points have equal distances, also after a shift modulo 1.
TEST(PointSource, HaltonCoordinatesAreRadicalInverses) {
    const Points points = drawn(*haltonSource(), 8, {2, 1}, 125);
    for (const auto& [axis, count] : {std::pair{0u, 64u}, {1u, 81u}, {2u, 125u}}) {
        Points values;
        for (unsigned i = 0; i < count; ++i) values.push_back(points[3 * i + axis]);
        std::sort(values.begin(), values.end());
        for (unsigned i = 1; i < count; ++i) {
            EXPECT_NEAR(values[i] - values[i - 1], 1.0 / count, 1e-12);
        }
    }
    const double step = points[3 + 1] - points[1];
    EXPECT_NEAR(step < 0 ? step + 1 : step, 1.0 / 3, 1e-12);
}

TEST(PointSource, JitterPutsOnePointIntoEachCell) {
    const Points points = drawn(*jitteredSource(), 2, {2}, 49);
    std::vector<unsigned> cells(49);
    for (std::size_t i = 0; i < points.size(); i += 2) {
        ++cells[std::size_t(points[i] * 7) * 7 + std::size_t(points[i + 1] * 7)];
    }
    EXPECT_EQ(cells, std::vector<unsigned>(49, 1));
}

/// 11 points are 3 slabs of 3, 4 and 4 points. Guards against cells of unequal volume, which bias.
TEST(PointSource, JitterOfAnyCountHasEqualCells) {
    Points points = drawn(*jitteredSource(), 2, {2}, 11);
    std::vector<std::vector<double>> slabs(3);
    for (std::size_t i = 0; i < points.size(); i += 2) {
        slabs[points[i] < 3.0 / 11 ? 0 : points[i] < 7.0 / 11 ? 1 : 2].push_back(points[i + 1]);
    }
    for (std::size_t s = 0; s < 3; ++s) {
        std::sort(slabs[s].begin(), slabs[s].end());
        ASSERT_EQ(slabs[s].size(), s == 0 ? 3u : 4u);
        for (std::size_t i = 0; i < slabs[s].size(); ++i) {
            EXPECT_EQ(std::size_t(slabs[s][i] * double(slabs[s].size())), i);
        }
    }
}

} // namespace
} // namespace wellstrat
