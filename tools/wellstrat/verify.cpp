// SPDX-License-Identifier: Apache-2.0
//
// wellstrat verify: checks every promise about stratification and prints the certificate.

#include "commands.h"
#include "common/command_line/errors.h"
#include "common/command_line/options.h"
#include "common/command_line/progress.h"
#include "common/command_line/versions.h"
#include "common/output/output_file.h"
#include "wellstrat/analysis/certificate.h"
#include "wellstrat/tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace wellstrat::cli {
namespace {

constexpr auto kExamples =
    R"(Every promise is checked exactly: of the elementary intervals, strata and boxes that must hold
a certain number of points, each one is counted: of the tables, of patterns of samples from them,
of patterns of long, and of pixels and blocks of pixels of blue.

Examples:
  wellstrat verify
  wellstrat verify --tables 0..7 --patterns 100
  wellstrat verify --json > certificate.json

Exit codes: 0 all promises hold, 1 a promise does not hold, 2 error.
)";

constexpr uint32_t kPatternSeed = 1;

struct VerifyOptions {
    std::string tables = "all";
    uint64_t patterns = 1000;
    bool json = false;
};

struct TableRange {
    unsigned first, last;
};

TableRange parseTables(const std::string& text) {
    constexpr NumberRange range{0, kTableCount - 1};
    if (text == "all") return {0, kTableCount - 1};
    const size_t dots = text.find("..");
    uint64_t first = 0, last = 0;
    if (dots == std::string::npos || !parseNumber(text.substr(0, dots), range, first) ||
        !parseNumber(text.substr(dots + 2), range, last) || first > last) {
        throw CliError(fmt::format("--tables: neither 'all' nor A..B with 0 <= A <= B <= {}: '{}'",
                                   range.max, text));
    }
    return {static_cast<unsigned>(first), static_cast<unsigned>(last)};
}

using Certificate = std::vector<CertificateLine>;

Certificate certify(TableRange range, unsigned patterns) {
    Certificate certificate;
    {
        ProgressBar bar("checking tables:");
        certificate = certifyTables(range.first, range.last, [&](double done) { bar.show(done); });
    }
    using Certify = Certificate (*)(unsigned, uint32_t, const CertificateProgress&);
    const std::pair<const char*, Certify> checks[] = {{"checking patterns:", certifyPatterns},
                                                      {"checking long:", certifyLong},
                                                      {"checking blue:", certifyBlue}};
    for (const auto& [label, certify] : checks) {
        ProgressBar bar(label);
        const Certificate users =
            certify(patterns, kPatternSeed, [&](double done) { bar.show(done); });
        certificate.insert(certificate.end(), users.begin(), users.end());
    }
    return certificate;
}

bool holds(const Certificate& certificate) {
    return std::all_of(certificate.begin(), certificate.end(),
                       [](const CertificateLine& line) { return line.violations == 0; });
}

std::string result(const CertificateLine& line) {
    return line.violations == 0 ? "ok" : fmt::format("{} VIOLATED", line.violations);
}

/// The promises, each under what it was checked of.
std::string tableText(const Certificate& certificate) {
    size_t promiseWidth = 0;
    uint64_t intervals = 0, violations = 0;
    for (const CertificateLine& line : certificate) {
        promiseWidth = std::max(promiseWidth, line.promise.size());
        intervals += line.intervals;
        violations += line.violations;
    }
    std::string text = versionLine() + "\n", subject;
    const auto out = std::back_inserter(text);
    for (const CertificateLine& line : certificate) {
        if (line.subject != subject) {
            subject = line.subject;
            fmt::format_to(out, "\n{}:\n", subject);
        }
        fmt::format_to(out, "  {:<{}}  {:>11}  {}\n", line.promise, promiseWidth, line.intervals,
                       result(line));
        if (!line.firstViolation.empty())
            fmt::format_to(out, "    first: {}\n", line.firstViolation);
    }
    fmt::format_to(out, "\n{} intervals checked, {}\n", intervals,
                   violations == 0 ? "all promises hold" : fmt::format("{} violated", violations));
    return text;
}

std::string jsonText(const Certificate& certificate, TableRange range, uint64_t patterns) {
    nlohmann::ordered_json json = versionedJson();
    json["tables"] = {range.first, range.last};
    json["patterns"] = patterns;
    json["pattern_seed"] = kPatternSeed;
    json["passed"] = holds(certificate);
    json["lines"] = nlohmann::ordered_json::array();
    for (const CertificateLine& line : certificate) {
        json["lines"].push_back({{"promise", line.promise},
                                 {"subject", line.subject},
                                 {"intervals", line.intervals},
                                 {"violations", line.violations},
                                 {"first_violation", line.firstViolation}});
    }
    return json.dump(2) + "\n";
}

int verify(const VerifyOptions& options) {
    const TableRange range = parseTables(options.tables);
    const Certificate certificate = certify(range, static_cast<unsigned>(options.patterns));
    printText(options.json ? jsonText(certificate, range, options.patterns)
                           : tableText(certificate));
    return holds(certificate) ? 0 : kExitViolation;
}

} // namespace

void addVerify(CLI::App& app, int& exitCode) {
    CLI::App* const command =
        app.add_subcommand("verify", "Check every promise about stratification");
    const auto options = std::make_shared<VerifyOptions>();
    command->add_option("--tables", options->tables, "The tables to check: all or A..B [all]")
        ->type_name("RANGE");
    addNumber(*command, "--patterns", options->patterns, {0, kMaxWord},
              "Random patterns of each generator, beside some special ones [1000]");
    command->add_flag("--json", options->json, "Print the certificate as JSON");
    command->footer(kExamples);
    command->callback([options, &exitCode] { exitCode = verify(*options); });
}

} // namespace wellstrat::cli
