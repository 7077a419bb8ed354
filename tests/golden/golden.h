// SPDX-License-Identifier: Apache-2.0
//
// Golden values: records of what the library must answer to given arguments, forever, for one
// stream version. A record is a line of words,
//
//     <kind> <arguments, hexadecimal> = <results, hexadecimal>
//
// in which samples are the integers k of the floats k * 2^-24. Each answer is computed by the
// scalar and by the batch functions, which must agree. Needs nothing but the library, so that
// builds for other architectures can run it.

#pragma once

#include "RixRNG.h"
#include "wellstrat/batch.h"
#include "wellstrat/blue.h"
#include "wellstrat/camera.h"
#include "wellstrat/joint.h"
#include "wellstrat/long.h"
#include "wellstrat/random_generator.h"
#include "wellstrat/sequence.h"
#include "wellstrat/version.h"

#include <algorithm>
#include <cstdint>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace golden {

using Words = std::vector<uint32_t>;
using SampleCtx = RixRNG::SampleCtx;
using Scramble = RixRNG::Scramble;

/// The 24 bits of a sample. Throws if the float is no multiple of 2^-24 in [0, 1).
inline uint32_t bitsOf(float xi) {
    const float scaled = xi * 0x1p24f;
    if (!(scaled >= 0 && scaled < 0x1p24f)) throw std::runtime_error("a sample outside [0, 1)");
    const auto bits = static_cast<uint32_t>(scaled);
    if (static_cast<float>(bits) != scaled) throw std::runtime_error("no multiple of 2^-24");
    return bits;
}

/// A batch that starts with the context: long enough for whole vectors of any batch target, with a
/// rest after them.
inline std::vector<SampleCtx> batchFrom(uint32_t patternid, uint32_t sampleid) {
    std::vector<SampleCtx> contexts;
    for (uint32_t i = 0; i < 2 * 16 + 5; ++i) contexts.push_back({patternid + i, sampleid + i});
    return contexts;
}

/// x, y and z of the samples of all contexts, drawn in all the ways there are, which must agree.
inline Words sampleBits(const RixRNG& rng) {
    const unsigned n = rng.numPts;
    std::vector<float> z(n);
    std::vector<RtFloat2> xy(n);
    std::vector<RtFloat3> xyz(n);
    rng.DrawSamples1D(z.data());
    rng.DrawSamples2D(xy.data());
    rng.DrawSamples3D(xyz.data());
    Words bits;
    for (unsigned i = 0; i < n; ++i) {
        if (rng.DrawSample3D(i) != xyz[i] || rng.DrawSample2D(i) != xy[i] ||
            rng.DrawSample1D(i) != z[i] || RtFloat3(xy[i].x, xy[i].y, z[i]) != xyz[i]) {
            throw std::runtime_error("draws of one context differ");
        }
        for (const float xi : {xyz[i].x, xyz[i].y, xyz[i].z}) bits.push_back(bitsOf(xi));
    }
    return bits;
}

/// x, y and z of the first sample of batchFrom(a[0], a[1]).
inline Words firstSample(const Words& a, const RixRNG::Generator* generator,
                         RixRNG::Order order = {}) {
    auto contexts = batchFrom(a[0], a[1]);
    RixRNG rng(contexts, static_cast<unsigned>(contexts.size()), generator);
    rng.order = order;
    Words bits = sampleBits(rng);
    bits.resize(3);
    return bits;
}

/// Fowler, Noll and Vo's hash FNV-1a of the bytes of the words, lowest first: stands for values too
/// many to list.
inline Words digest(const Words& words) {
    uint32_t hash = 2166136261u;
    for (const uint32_t word : words) {
        for (unsigned shift = 0; shift < 32; shift += 8) {
            hash = (hash ^ ((word >> shift) & 0xffu)) * 16777619u;
        }
    }
    return {hash};
}

inline Words sample(const Words& a) { return firstSample(a, nullptr); }

inline Words randomSample(const Words& a) {
    const wellstrat::RandomGenerator random;
    return firstSample(a, &random);
}

inline Words jointSample(const Words& a) {
    const wellstrat::JointProgressive joint;
    return firstSample(a, &joint, wellstrat::jointOrder(a[2], a[3]));
}

inline Words longSample(const Words& a) {
    const wellstrat::LongProgressive longSamples;
    return firstSample(a, &longSamples);
}

inline Words longSlotSample(const Words& a) {
    const wellstrat::LongProgressive longSamples;
    return firstSample(a, &longSamples, wellstrat::jointOrder(a[2], a[3]));
}

inline Words blueSample(const Words& a) {
    const wellstrat::BlueProgressive blue;
    return firstSample(a, &blue);
}

inline Words blueSlotSample(const Words& a) {
    const wellstrat::BlueProgressive blue;
    return firstSample(a, &blue, wellstrat::jointOrder(a[2], a[3]));
}

/// All 32 bits of x, y and z, which floats cut.
inline Words sequenceWords(const Words& a) {
    Words bits;
    for (const auto c :
         {wellstrat::Coordinate::x, wellstrat::Coordinate::y, wellstrat::Coordinate::z}) {
        bits.push_back(wellstrat::sequenceBits(a[0], a[1], c));
    }
    return bits;
}

/// Drawn in batches of 1, 2, 3, ... samples, so that vectors have rests of any length.
inline Words run(const Words& a) {
    std::vector<SampleCtx> contexts;
    for (uint32_t i = 0; i < a[2]; ++i) contexts.push_back({a[0], a[1] + i});
    Words bits;
    for (uint32_t first = 0, n = 1; first < a[2]; first += n, ++n) {
        const Words some = sampleBits({&contexts[first], std::min(n, a[2] - first)});
        bits.insert(bits.end(), some.begin(), some.end());
    }
    return digest(bits);
}

inline Words table(const Words& a) {
    Words values;
    for (uint32_t i = 0; i < wellstrat::kTableSize; ++i) {
        for (const auto c :
             {wellstrat::Coordinate::x, wellstrat::Coordinate::y, wellstrat::Coordinate::z}) {
            values.push_back(wellstrat::tableValue(a[0], i, c));
        }
    }
    return digest(values);
}

inline Words hash(const Words& a) {
    const auto contexts = batchFrom(a[0], a[1]);
    std::vector<float> xis(contexts.size());
    wellstrat::hashToRandom(contexts.size(), contexts.data(), xis.data());
    for (std::size_t i = 0; i < contexts.size(); ++i) {
        const SampleCtx sc = contexts[i];
        const uint32_t bits = HashToUnsigned(sc.patternid, sc.sampleid) >> 8;
        if (bitsOf(HashToRandom(sc.patternid, sc.sampleid)) != bits || bitsOf(xis[i]) != bits) {
            throw std::runtime_error("HashToRandom is not HashToUnsigned");
        }
    }
    return {HashToUnsigned(a[0], a[1])};
}

inline Words words(SampleCtx sc) { return {sc.patternid, sc.sampleid}; }

/// The domain of the first context of batchFrom(a[0], a[1]), of all of which domain(rng, i) for the
/// i-th and domains(rng, out) for all must agree.
template <typename Domain, typename Domains>
Words firstDomain(const Words& a, Domain domain, Domains domains,
                  const wellstrat::Generator* generator = nullptr) {
    auto parents = batchFrom(a[0], a[1]);
    const RixRNG rng(parents.data(), static_cast<unsigned>(parents.size()), generator);
    std::vector<SampleCtx> children(parents.size());
    domains(rng, children.data());
    for (unsigned i = 0; i < rng.numPts; ++i) {
        if (words(domain(rng, i)) != words(children[i])) {
            throw std::runtime_error("domains of one context differ");
        }
    }
    return words(children[0]);
}

inline Words domain(const Words& a) {
    const auto scramble = static_cast<Scramble>(a[2]);
    return firstDomain(
        a, [&](const RixRNG& rng, unsigned i) { return rng.NewDomain(i, scramble); },
        [&](const RixRNG& rng, SampleCtx* out) { rng.NewDomains(scramble, out); });
}
inline Words distrib(const Words& a) {
    const auto scramble = static_cast<Scramble>(a[2]);
    return firstDomain(
        a, [&](const RixRNG& rng, unsigned i) { return rng.NewDomainDistrib(i, scramble, a[3]); },
        [&](const RixRNG& rng, SampleCtx* out) { rng.NewDomainsDistrib(scramble, a[3], out); });
}
inline Words split(const Words& a) {
    const auto scramble = static_cast<Scramble>(a[2]);
    return firstDomain(
        a, [&](const RixRNG& rng, unsigned i) { return rng.NewDomainSplit(i, scramble, a[3]); },
        [&](const RixRNG& rng, SampleCtx* out) { rng.NewDomainsSplit(scramble, a[3], out); });
}
inline Words blueSplit(const Words& a) {
    const wellstrat::BlueProgressive blue;
    const auto scramble = static_cast<Scramble>(a[2]);
    return firstDomain(
        a, [&](const RixRNG& rng, unsigned i) { return rng.NewDomainSplit(i, scramble, a[3]); },
        [&](const RixRNG& rng, SampleCtx* out) { rng.NewDomainsSplit(scramble, a[3], out); },
        &blue);
}
inline Words blueDistrib(const Words& a) {
    const wellstrat::BlueProgressive blue;
    const auto scramble = static_cast<Scramble>(a[2]);
    return firstDomain(
        a, [&](const RixRNG& rng, unsigned i) { return rng.NewDomainDistrib(i, scramble, a[3]); },
        [&](const RixRNG& rng, SampleCtx* out) { rng.NewDomainsDistrib(scramble, a[3], out); },
        &blue);
}
inline Words blueCamera(const Words& a) {
    return words(
        wellstrat::blueContext(static_cast<int>(a[0]), static_cast<int>(a[1]), a[2], a[3]));
}
inline Words camera(const Words& a) {
    return words(
        wellstrat::cameraContext(static_cast<int>(a[0]), static_cast<int>(a[1]), a[2], a[3]));
}
inline Words seeded(const Words& a) {
    return words(
        wellstrat::cameraContext(static_cast<int>(a[0]), static_cast<int>(a[1]), a[2], a[3], a[4]));
}
inline Words stream(const Words&) { return {wellstrat::kStreamVersion}; }

struct Kind {
    const char* name;
    unsigned arguments;
    Words (*answer)(const Words& arguments);
};

constexpr Kind kKinds[] = {
    {"stream", 0, stream},           // = version
    {"sample", 2, sample},           // patternid sampleid = x y z
    {"random", 2, randomSample},     // patternid sampleid = x y z, of the RandomGenerator
    {"joint", 4, jointSample},       // patternid sampleid slot split = x y z, of JointProgressive
    {"long", 2, longSample},         // patternid sampleid = x y z, of LongProgressive
    {"longslot", 4, longSlotSample}, // patternid sampleid slot split = x y z, of LongProgressive
    {"blue", 2, blueSample},         // patternid sampleid = x y z, of BlueProgressive
    {"blueslot", 4, blueSlotSample}, // patternid sampleid slot split = x y z, of BlueProgressive
    {"sequence", 2, sequenceWords},  // patternid sampleid = x y z, fractions of 2^32
    {"run", 3, run},                 // patternid first count = digest of the x, y, z of all
    {"table", 1, table},             // table = digest of its 4096 points
    {"hash", 2, hash},               // a b = HashToUnsigned
    {"domain", 3, domain},           // patternid sampleid scramble = patternid sampleid
    {"distrib", 4, distrib},         // patternid sampleid scramble newsampleid = patternid sampleid
    {"split", 4, split},   // patternid sampleid scramble newnumsamples = patternid sampleid
    {"camera", 4, camera}, // x y frame sampleid = patternid sampleid
    {"seeded", 5, seeded}, // x y frame sampleid seed = patternid sampleid
    // The same of BlueProgressive.
    {"bluesplit", 4, blueSplit},
    {"bluedistrib", 4, blueDistrib},
    {"bluecamera", 4, blueCamera}, // x y seed sampleid = patternid sampleid
};

/// The line, without its end, of a record of this kind. Throws std::invalid_argument for a kind or
/// a number of arguments that there is not.
inline std::string record(const std::string& kindName, const Words& arguments) {
    for (const Kind& kind : kKinds) {
        if (kindName != kind.name) continue;
        if (arguments.size() != kind.arguments) {
            throw std::invalid_argument(kindName + " takes " + std::to_string(kind.arguments) +
                                        " arguments, not " + std::to_string(arguments.size()));
        }
        std::ostringstream line;
        line << std::hex << kindName;
        for (const uint32_t word : arguments) line << ' ' << word;
        line << " =";
        for (const uint32_t word : kind.answer(arguments)) line << ' ' << word;
        return line.str();
    }
    throw std::invalid_argument("there is no kind of record \"" + kindName + "\"");
}

} // namespace golden
