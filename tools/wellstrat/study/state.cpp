// SPDX-License-Identifier: Apache-2.0

#include "state.h"

#include "common/command_line/errors.h"
#include "common/command_line/versions.h"
#include "common/output/output_file.h"

#include <fmt/format.h>

#include <cerrno>
#include <charconv>
#include <fstream>
#include <iterator>

namespace wellstrat::cli {
namespace {

constexpr const char* kEnd = "end";

/// All that must be the same for sums to be added.
nlohmann::ordered_json planJson(const StudyPlan& plan) {
    nlohmann::ordered_json json = versionedJson();
    json["generators"] = nlohmann::ordered_json::array();
    for (const StudySource& source : plan.sources) json["generators"].push_back(source.name);
    json["integrands"] = nlohmann::ordered_json::array();
    for (const IntegrandPicture& integrand : plan.integrands) {
        json["integrands"].push_back(integrand.name);
    }
    json["counts"] = plan.counts;
    json["filter"] = nullptr;
    if (plan.filter) json["filter"] = {plan.filter->sigma(), plan.integrands[0].size};
    return json;
}

void appendSum(const ExactSum& sum, std::string& text) {
    for (const uint64_t word : sum.words()) {
        fmt::format_to(std::back_inserter(text), "{:016x}", word);
    }
}

/// Reads the 64 digits at `digits`.
bool parseSum(const char* digits, ExactSum& sum) {
    std::array<uint64_t, 4> words{};
    for (uint64_t& word : words) {
        const auto [stop, error] = std::from_chars(digits, digits + 16, word, 16);
        if (error != std::errc() || stop != digits + 16) return false;
        digits = stop;
    }
    sum = ExactSum(words);
    return true;
}

constexpr std::size_t kSumDigits = 64;

bool parseCell(const std::string& line, ErrorSums& sums) {
    return line.size() == 3 * kSumDigits && parseSum(line.data(), sums.first) &&
           parseSum(line.data() + kSumDigits, sums.second) &&
           parseSum(line.data() + 2 * kSumDigits, sums.fourth);
}

/// The first line of a state; null if it is none.
nlohmann::ordered_json readHead(std::istream& in) {
    std::string line;
    std::getline(in, line);
    nlohmann::ordered_json head = nlohmann::ordered_json::parse(line, nullptr, false);
    if (!head.is_object()) return {};
    for (const char* key : {"patterns", "planned"}) {
        if (!head.contains(key) || !head[key].is_number_unsigned()) return {};
    }
    return head;
}

void checkSamePlan(const std::string& path, const nlohmann::ordered_json& saved,
                   const StudyPlan& plan) {
    const nlohmann::ordered_json planned = planJson(plan);
    for (const auto& [key, value] : planned.items()) {
        if (saved.value(key, nlohmann::ordered_json()) == value) continue;
        throw CliError(fmt::format("--resume: the study in '{}' differs in: {}", path, key));
    }
}

} // namespace

void saveState(const std::string& path, const StudyPlan& plan, const StudyResult& result) {
    nlohmann::ordered_json head = planJson(plan);
    head["patterns"] = result.patterns;
    head["planned"] = plan.patterns;
    OutputFile out(path);
    out.write(head.dump() + "\n");
    std::string line;
    for (const ErrorSums& sums : result.sums) {
        line.clear();
        for (const ExactSum* sum : {&sums.first, &sums.second, &sums.fourth}) {
            appendSum(*sum, line);
        }
        out.write(line + "\n");
    }
    out.write(std::string(kEnd) + "\n");
    out.commit();
}

bool isFinished(const std::string& path) {
    std::ifstream in(path);
    const nlohmann::ordered_json head = readHead(in);
    return !head.is_null() && head["patterns"] >= head["planned"];
}

StudyResult loadState(const std::string& path, const StudyPlan& plan) {
    const CliError damaged(fmt::format("--resume: '{}' is no state of a study", path));
    std::ifstream in(path);
    if (!in) throw fileError("read", path, errno);
    const nlohmann::ordered_json head = readHead(in);
    if (head.is_null()) throw damaged;
    checkSamePlan(path, head, plan);
    StudyResult result{head["patterns"].get<uint64_t>(), std::vector<ErrorSums>(plan.cells())};
    std::string line;
    for (ErrorSums& sums : result.sums) {
        if (!std::getline(in, line) || !parseCell(line, sums)) throw damaged;
    }
    if (!std::getline(in, line) || line != kEnd) throw damaged;
    if (result.patterns > plan.patterns) {
        throw CliError(
            fmt::format("--resume: the study in '{}' has {} patterns already, more than "
                        "--patterns {}",
                        path, result.patterns, plan.patterns));
    }
    return result;
}

} // namespace wellstrat::cli
