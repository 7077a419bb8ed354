// SPDX-License-Identifier: Apache-2.0
//
// The certificates of the tables and of the samples that are drawn from them.

#include "certificate_lines.h"
#include "table_register.h"
#include "wellstrat/lookup.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <stdexcept>

namespace wellstrat {
inline namespace stream1 {
namespace {

constexpr unsigned kBlocks = kStratifiedSamples / kTableSize;

std::string tableName(unsigned table) { return "table " + std::to_string(table); }

PointBits samplePoint(uint32_t patternid, uint32_t sampleid) {
    const Float3 xi = sample3D(patternid, sampleid);
    return {fractionOf(xi.x), fractionOf(xi.y), fractionOf(xi.z)};
}

/// Checks pattern after pattern and keeps the lines.
class PatternChecker {
public:
    explicit PatternChecker(const std::string& patterns)
        : lines_(netLines(patterns + ", 3 of 48 blocks, m = 0..12, every aligned block")),
          draws_(lines_, patterns), tables_(0, kTableCount - 1), contexts_(kTableSize) {
        blocks_ = addLine("48 blocks from 48 different tables", "48 blocks of " + patterns);
        runOut_ = addLine("from sample 196608 on: one hash for each coordinate",
                          "samples of " + patterns);
    }

    void check(uint32_t patternid, unsigned middleBlock) {
        patternid_ = patternid;
        for (const unsigned block : {0u, middleBlock, kBlocks - 1}) checkBlock(block);
        checkDistinctTables();
        checkRunOut();
    }

    const CertificateLines& lines() const { return lines_; }

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

    /// The samples from `first` on.
    PointSet draw(uint32_t first, unsigned count) {
        for (uint32_t i = 0; i < count; ++i) contexts_[i] = {patternid_, first + i};
        return draws_.draw(RixRNG(contexts_.data(), count),
                           [&](unsigned i) { return sampleName(first + i); });
    }

    void checkBlock(unsigned block) {
        checkNets(
            draw(block * kTableSize, kTableSize), [&] { return blockName(block); }, lines_);
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
            draw(first, kRun);
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
        const Float3 xi = sample3D(patternid_, sampleid);
        const Float3 hashed(toUnitFloat(randomBits(patternid_, sampleid, Coordinate::x)),
                            toUnitFloat(randomBits(patternid_, sampleid, Coordinate::y)),
                            toUnitFloat(hashPair(patternid_, sampleid)));
        record(lines_[runOut_], xi == hashed, [&] { return sampleName(sampleid); });
        return xi;
    }

    CertificateLines lines_;
    DrawChecker draws_;
    TableRegister tables_;
    std::vector<SampleCtx> contexts_;
    uint32_t patternid_ = 0;
    std::size_t blocks_, runOut_; // places in lines_
};

} // namespace

CertificateLines certifyTables(unsigned first, unsigned last, const CertificateProgress& progress) {
    if (first > last || last >= kTableCount) {
        throw std::invalid_argument("tables " + std::to_string(first) + " to " +
                                    std::to_string(last) + " are asked for; accepted are ranges " +
                                    "within 0 to " + std::to_string(kTableCount - 1));
    }
    const unsigned count = last - first + 1;
    const std::string subject = std::to_string(count) + (count == 1 ? " table" : " tables");
    CertificateLines lines = netLines(subject + ", m = 0..12, every aligned block");
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

CertificateLines certifyPatterns(unsigned count, uint32_t seed,
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
