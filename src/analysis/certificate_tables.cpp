// SPDX-License-Identifier: Apache-2.0

#include "wellstrat/analysis/certificate.h"

#include "table_register.h"
#include "wellstrat/analysis/nets.h"
#include "wellstrat/batch.h"
#include "wellstrat/lookup.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <stdexcept>

namespace wellstrat {
inline namespace stream1 {
namespace {

constexpr unsigned kBlocks = kStratifiedSamples / kTableSize;

struct NetPromise {
    const char* text;
    std::vector<unsigned> coordinates;
    unsigned t;
    NetBase base;
};

const std::vector<NetPromise>& netPromises() {
    static const std::vector<NetPromise> promises = {
        {"x: one point in each of 2^m strata", {0}, 0, NetBase::two},
        {"y: one point in each of 2^m strata", {1}, 0, NetBase::two},
        {"z: one point in each of 2^m strata", {2}, 0, NetBase::two},
        {"(x, y): (0,m,2)-net in base 2", {0, 1}, 0, NetBase::two},
        {"(x, y, z): (1,m,3)-net in base 2", {0, 1, 2}, 1, NetBase::two},
        {"(x, y, z): one point in each base-4 box, m even", {0, 1, 2}, 0, NetBase::four},
    };
    return promises;
}

CertificateLine emptyLine(const std::string& promise, const std::string& subject) {
    return {promise, subject, 0, 0, {}};
}

/// Counts one check of a line. `where` is called for the first violation only.
template <class Where>
void record(CertificateLine& line, bool kept, const Where& where) {
    ++line.intervals;
    if (kept) return;
    if (line.violations++ == 0) line.firstViolation = where();
}

std::vector<CertificateLine> netLines(const std::string& subject) {
    std::vector<CertificateLine> lines;
    for (const NetPromise& promise : netPromises()) {
        lines.push_back(emptyLine(promise.text, subject));
    }
    return lines;
}

/// Adds what the checks of all net promises find to the first lines of `lines`.
template <class Name>
void checkNets(const PointSet& points, const Name& name, std::vector<CertificateLine>& lines) {
    for (std::size_t i = 0; i < netPromises().size(); ++i) {
        const NetPromise& promise = netPromises()[i];
        const NetReport report =
            checkSequence(points.projection(promise.coordinates), promise.t, promise.base);
        CertificateLine& line = lines[i];
        if (line.violations == 0 && !report.holds()) {
            line.firstViolation = name() + ", " + report.firstViolation;
        }
        line.intervals += report.intervals;
        line.violations += report.violations;
    }
}

std::string tableName(unsigned table) { return "table " + std::to_string(table); }

bool isUnitMultiple(float value) {
    if (!(value >= 0.0f && value < 1.0f)) return false;
    const float scaled = value * 0x1p24f;
    return static_cast<float>(static_cast<uint32_t>(scaled)) == scaled;
}

/// A drawn value as a fraction of 2^32; 0 for one that is out of range, which is counted apart.
uint32_t fractionOf(float value) {
    return isUnitMultiple(value) ? static_cast<uint32_t>(value * 0x1p24f) << 8 : 0;
}

PointBits samplePoint(uint32_t patternid, uint32_t sampleid) {
    const Float3 xi = sample3D(patternid, sampleid);
    return {fractionOf(xi.x), fractionOf(xi.y), fractionOf(xi.z)};
}

/// Checks pattern after pattern and keeps the lines.
class PatternChecker {
public:
    explicit PatternChecker(const std::string& patterns)
        : lines_(netLines(patterns + ", 3 of 48 blocks, m = 0..12, every aligned block")),
          tables_(0, kTableCount - 1), contexts_(kTableSize), xi1_(kTableSize), xi2_(kTableSize),
          xi3_(kTableSize), bits_(kTableSize * 3) {
        const std::string samples = "samples of " + patterns;
        draws_ = addLine("1D draw = z, 2D draw = (x, y), batch = single draws", samples);
        values_ = addLine("values in [0, 1), multiples of 2^-24", "values of " + patterns);
        blocks_ = addLine("48 blocks from 48 different tables", "48 blocks of " + patterns);
        runOut_ = addLine("from sample 196608 on: one hash for each coordinate", samples);
    }

    void check(uint32_t patternid, unsigned middleBlock) {
        patternid_ = patternid;
        for (const unsigned block : {0u, middleBlock, kBlocks - 1}) checkBlock(block);
        checkDistinctTables();
        checkRunOut();
    }

    const std::vector<CertificateLine>& lines() const { return lines_; }

private:
    std::size_t addLine(const std::string& promise, const std::string& subject) {
        lines_.push_back(emptyLine(promise, subject));
        return lines_.size() - 1;
    }

    std::string sampleName(uint32_t sampleid) const {
        return "pattern " + std::to_string(patternid_) + ", sample " + std::to_string(sampleid);
    }

    std::string blockName(unsigned block) const {
        return "pattern " + std::to_string(patternid_) + ", block " + std::to_string(block);
    }

    void checkBlock(unsigned block) {
        const uint32_t first = block * kTableSize;
        for (uint32_t i = 0; i < kTableSize; ++i) contexts_[i] = {patternid_, first + i};
        drawSamples1D(kTableSize, contexts_.data(), xi1_.data());
        drawSamples2D(kTableSize, contexts_.data(), xi2_.data());
        drawSamples3D(kTableSize, contexts_.data(), xi3_.data());
        // Single draws backwards: samples do not depend on the order in which they are drawn.
        for (uint32_t i = kTableSize; i-- > 0;) {
            const Float3 xi = sample3D(patternid_, first + i);
            const bool batchAgrees =
                xi1_[i] == xi.z && xi2_[i] == Float2(xi.x, xi.y) && xi3_[i] == xi;
            checkDraw(first + i, xi, batchAgrees);
            bits_[i * 3] = fractionOf(xi.x);
            bits_[i * 3 + 1] = fractionOf(xi.y);
            bits_[i * 3 + 2] = fractionOf(xi.z);
        }
        checkNets(
            PointSet::fromIntegers(bits_.data(), kTableSize, 3), [&] { return blockName(block); },
            lines_);
    }

    /// `xi` is the 3D draw.
    void checkDraw(uint32_t sampleid, const Float3& xi, bool batchAgrees) {
        const auto name = [&] { return sampleName(sampleid); };
        const bool singleAgrees = sample1D(patternid_, sampleid) == xi.z &&
                                  sample2D(patternid_, sampleid) == Float2(xi.x, xi.y);
        record(lines_[draws_], batchAgrees && singleAgrees, name);
        for (const float value : {xi.x, xi.y, xi.z}) {
            record(lines_[values_], isUnitMultiple(value), name);
        }
    }

    void checkDistinctTables() {
        std::array<bool, kTableCount> used{};
        for (unsigned block = 0; block < kBlocks; ++block) {
            const unsigned table = tables_.find(fingerprint(
                [&](unsigned i) { return samplePoint(patternid_, block * kTableSize + i); }));
            record(lines_[blocks_], table < kTableCount && !used[table], [&] {
                return blockName(block) +
                       (table < kTableCount ? " repeats " + tableName(table) : " is of no table");
            });
            if (table < kTableCount) used[table] = true;
        }
    }

    void checkRunOut() {
        constexpr uint32_t kRun = 16;
        for (const uint32_t first : {kStratifiedSamples, 0x80000000u - kRun / 2, 0u - kRun}) {
            bool sharedXY = true, sharedYZ = true, sharedZX = true;
            for (uint32_t i = 0; i < kRun; ++i) {
                const Float3 xi = checkRunOutSample(first + i);
                sharedXY = sharedXY && xi.x == xi.y;
                sharedYZ = sharedYZ && xi.y == xi.z;
                sharedZX = sharedZX && xi.z == xi.x;
            }
            record(lines_[runOut_], !sharedXY && !sharedYZ && !sharedZX,
                   [&] { return sampleName(first) + " has one hash for two coordinates"; });
        }
    }

    Float3 checkRunOutSample(uint32_t sampleid) {
        const SampleCtx context{patternid_, sampleid};
        const Float3 xi = sample3D(patternid_, sampleid);
        Float3 batch;
        drawSamples3D(1, &context, &batch);
        checkDraw(sampleid, xi, batch == xi);
        const Float3 hashed(toUnitFloat(randomBits(patternid_, sampleid, Coordinate::x)),
                            toUnitFloat(randomBits(patternid_, sampleid, Coordinate::y)),
                            toUnitFloat(hashPair(patternid_, sampleid)));
        record(lines_[runOut_], xi == hashed, [&] { return sampleName(sampleid); });
        return xi;
    }

    std::vector<CertificateLine> lines_;
    TableRegister tables_;
    std::vector<SampleCtx> contexts_;
    std::vector<float> xi1_;
    std::vector<Float2> xi2_;
    std::vector<Float3> xi3_;
    std::vector<uint32_t> bits_;
    uint32_t patternid_ = 0;
    std::size_t draws_, values_, blocks_, runOut_; // places in lines_
};

/// Patterns that a renderer is likely to start from, and 2^32 - 0x9e3779b9, which is the one with
/// patternSeed 0: no digital shift and the simplest shuffle.
constexpr uint32_t kSpecialPatterns[] = {0,           1,           2,           0x7fffffffu,
                                         0x80000000u, 0xfffffffeu, 0xffffffffu, 0x61c88647u};

} // namespace

std::vector<CertificateLine> certifyTables(unsigned first, unsigned last,
                                           const CertificateProgress& progress) {
    if (first > last || last >= kTableCount) {
        throw std::invalid_argument("tables " + std::to_string(first) + " to " +
                                    std::to_string(last) + " are asked for; accepted are ranges " +
                                    "within 0 to " + std::to_string(kTableCount - 1));
    }
    const unsigned count = last - first + 1;
    const std::string subject = std::to_string(count) + (count == 1 ? " table" : " tables");
    std::vector<CertificateLine> lines = netLines(subject + ", m = 0..12, every aligned block");
    CertificateLine distinct = emptyLine("no two tables are the same", subject);
    const TableRegister tables(first, last);
    std::vector<uint32_t> bits(kTableSize * 3);
    for (unsigned table = first; table <= last; ++table) {
        for (unsigned i = 0; i < kTableSize; ++i) {
            const PointBits point = tablePoint(table, i);
            std::copy(point.begin(), point.end(), bits.begin() + i * 3);
        }
        checkNets(
            PointSet::fromIntegers(bits.data(), kTableSize, 3), [&] { return tableName(table); },
            lines);
        const unsigned same =
            tables.find(fingerprint([&](unsigned i) { return tablePoint(table, i); }));
        record(distinct, same == table,
               [&] { return tableName(table) + " repeats " + tableName(same); });
        if (progress) progress((table - first + 1.0) / count);
    }
    lines.push_back(distinct);
    return lines;
}

std::vector<CertificateLine> certifyPatterns(unsigned count, uint32_t seed,
                                             const CertificateProgress& progress) {
    constexpr unsigned kSpecial = std::size(kSpecialPatterns);
    const uint64_t total = uint64_t{kSpecial} + count;
    PatternChecker checker(std::to_string(total) + " patterns");
    for (uint64_t i = 0; i < total; ++i) {
        const uint32_t random = hashPair(seed, static_cast<uint32_t>(i));
        const unsigned middleBlock =
            i < kSpecial ? 1 : 1 + scaleToRange(mixBits(random), kBlocks - 2);
        const uint32_t patternid = i < kSpecial ? kSpecialPatterns[i] : random;
        checker.check(patternid, middleBlock);
        if (progress) progress(static_cast<double>(i + 1) / static_cast<double>(total));
    }
    return checker.lines();
}

} // namespace stream1
} // namespace wellstrat
