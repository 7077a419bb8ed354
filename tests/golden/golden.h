// SPDX-License-Identifier: Apache-2.0
//
// Golden values: records of what the library must answer to given arguments, forever, for one
// stream version. A record is a line of words,
//
//     <kind> <arguments, hexadecimal> = <results, hexadecimal>
//
// in which samples are the integers k of the floats k * 2^-24. Needs nothing but the library, so
// that builds for other architectures can run it.

#pragma once

#include "RixRNG.h"
#include "wellstrat/camera.h"
#include "wellstrat/random_generator.h"
#include "wellstrat/version.h"

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

/// x, y and z of the samples of all contexts, drawn in all the ways there are, which must agree.
inline Words sampleBits(std::vector<SampleCtx> contexts, const RixRNG::Generator* generator) {
    const auto n = static_cast<unsigned>(contexts.size());
    const RixRNG rng(contexts.data(), n, generator);
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

inline Words sample(const Words& a) { return sampleBits({{a[0], a[1]}}, nullptr); }

inline Words randomSample(const Words& a) {
    const wellstrat::RandomGenerator random;
    return sampleBits({{a[0], a[1]}}, &random);
}

inline Words run(const Words& a) {
    std::vector<SampleCtx> contexts;
    for (uint32_t i = 0; i < a[2]; ++i) contexts.push_back({a[0], a[1] + i});
    return digest(sampleBits(std::move(contexts), nullptr));
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
    const uint32_t word = HashToUnsigned(a[0], a[1]);
    if (bitsOf(HashToRandom(a[0], a[1])) != word >> 8) {
        throw std::runtime_error("HashToRandom is not HashToUnsigned");
    }
    return {word};
}

inline Words words(SampleCtx sc) { return {sc.patternid, sc.sampleid}; }

inline Words domain(const Words& a) {
    return words(SampleCtx{a[0], a[1]}.NewDomain(static_cast<Scramble>(a[2])));
}
inline Words distrib(const Words& a) {
    return words(SampleCtx{a[0], a[1]}.NewDomainDistrib(static_cast<Scramble>(a[2]), a[3]));
}
inline Words split(const Words& a) {
    return words(SampleCtx{a[0], a[1]}.NewDomainSplit(static_cast<Scramble>(a[2]), a[3]));
}
inline Words camera(const Words& a) {
    return words(
        wellstrat::cameraContext(static_cast<int>(a[0]), static_cast<int>(a[1]), a[2], a[3]));
}
inline Words stream(const Words&) { return {wellstrat::kStreamVersion}; }

struct Kind {
    const char* name;
    unsigned arguments;
    Words (*answer)(const Words& arguments);
};

constexpr Kind kKinds[] = {
    {"stream", 0, stream},       // = version
    {"sample", 2, sample},       // patternid sampleid = x y z
    {"random", 2, randomSample}, // patternid sampleid = x y z, of the RandomGenerator
    {"run", 3, run},             // patternid first count = digest of the x, y, z of all
    {"table", 1, table},         // table = digest of its 4096 points
    {"hash", 2, hash},           // a b = HashToUnsigned
    {"domain", 3, domain},       // patternid sampleid scramble = patternid sampleid
    {"distrib", 4, distrib},     // patternid sampleid scramble newsampleid = patternid sampleid
    {"split", 4, split},         // patternid sampleid scramble newnumsamples = patternid sampleid
    {"camera", 4, camera},       // x y frame sampleid = patternid sampleid
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
