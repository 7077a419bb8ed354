// SPDX-License-Identifier: Apache-2.0

#include "golden_questions.h"

#include "wellstrat/version.h"

#include <algorithm>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace gpu_check {
namespace {

using Words = std::vector<uint32_t>;

struct NamedKind {
    const char* name;
    Kind kind;
    std::size_t arguments;
};

constexpr NamedKind kNames[] = {{"sample", Kind::sample, 2},
                                {"random", Kind::random, 2},
                                {"joint", Kind::joint, 4},
                                {"long", Kind::longSample, 2},
                                {"longslot", Kind::longSlot, 4},
                                {"blue", Kind::blue, 2},
                                {"blueslot", Kind::blueSlot, 4},
                                {"sequence", Kind::sequence, 2},
                                {"hash", Kind::hash, 2},
                                {"domain", Kind::domain, 3},
                                {"distrib", Kind::distrib, 4},
                                {"split", Kind::split, 4},
                                {"camera", Kind::camera, 4},
                                {"seeded", Kind::seeded, 5},
                                {"bluesplit", Kind::blueSplit, 4},
                                {"bluedistrib", Kind::blueDistrib, 4},
                                {"bluecamera", Kind::blueCamera, 4}};

struct ParsedLine {
    std::string kind;
    Words arguments, expected;
};

ParsedLine parse(const std::string& line) {
    std::istringstream in(line);
    ParsedLine parsed;
    in >> parsed.kind;
    Words* side = &parsed.arguments;
    for (std::string word; in >> word;) {
        if (word == "=") {
            side = &parsed.expected;
            continue;
        }
        std::size_t used = 0;
        side->push_back(static_cast<uint32_t>(std::stoul(word, &used, 16)));
        if (used != word.size()) throw std::invalid_argument(word);
    }
    return parsed;
}

/// Appends the questions of a line. Whether its answer is their digest.
bool appendQuestions(const ParsedLine& line, std::vector<Question>& questions) {
    const Words& a = line.arguments;
    if (line.kind == "run" && a.size() == 3) {
        for (uint32_t i = 0; i < a[2]; ++i) questions.push_back({Kind::sample, {a[0], a[1] + i}});
        return true;
    }
    if (line.kind == "table" && a.size() == 1) {
        for (uint32_t i = 0; i < wellstrat::kTableSize; ++i) {
            questions.push_back({Kind::tablePoint, {a[0], i}});
        }
        return true;
    }
    if (line.kind == "stream" && a.empty()) return false;
    for (const NamedKind& named : kNames) {
        if (line.kind != named.name || a.size() != named.arguments) continue;
        Question question{named.kind, {}};
        std::copy(a.begin(), a.end(), question.arguments);
        questions.push_back(question);
        return false;
    }
    throw std::invalid_argument(line.kind);
}

/// As golden::digest (tests/golden/golden.h).
Words fowlerNollVo(const Words& words) {
    uint32_t hash = 2166136261u;
    for (const uint32_t word : words) {
        for (unsigned shift = 0; shift < 32; shift += 8) {
            hash = (hash ^ ((word >> shift) & 0xffu)) * 16777619u;
        }
    }
    return {hash};
}

} // namespace

void readGolden(const std::string& path, GoldenFile& golden) {
    std::ifstream file(path);
    if (!file) throw std::runtime_error("cannot read " + path);
    const std::size_t recordsBefore = golden.records.size();
    std::string line;
    for (unsigned number = 1; std::getline(file, line); ++number) {
        if (line.empty() || line[0] == '#') continue;
        try {
            const ParsedLine parsed = parse(line);
            const std::size_t first = golden.questions.size();
            const bool digested = appendQuestions(parsed, golden.questions);
            golden.records.push_back(
                {line, parsed.expected, first, golden.questions.size() - first, digested});
        } catch (const std::exception&) {
            throw std::runtime_error(path + ":" + std::to_string(number) +
                                     ": no golden record: " + line);
        }
    }
    if (golden.records.size() == recordsBefore) throw std::runtime_error("no records in " + path);
}

bool agrees(const GoldenRecord& record, const std::vector<Answer>& answers) {
    if (record.questions == 0) return record.expected == Words{wellstrat::kStreamVersion};
    Words words;
    for (std::size_t i = 0; i < record.questions; ++i) {
        const Answer& answer = answers[record.firstQuestion + i];
        words.insert(words.end(), answer.words, answer.words + 3);
    }
    if (record.digested) return record.expected == fowlerNollVo(words);
    words.resize(record.expected.size());
    return !words.empty() && record.expected == words;
}

} // namespace gpu_check
