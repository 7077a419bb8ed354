// SPDX-License-Identifier: Apache-2.0
//
// wellstrat bank: searches the orders of the slots of wellstrat/joint.h, and judges them.

#include "bank_search/judge.h"
#include "bank_search/search.h"
#include "commands.h"
#include "common/command_line/errors.h"
#include "common/command_line/options.h"
#include "common/command_line/progress.h"
#include "common/output/output_file.h"
#include "wellstrat/joint_bank.h"
#include "wellstrat/joint_lookup.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <string>
#include <vector>

namespace wellstrat::cli {
namespace {

using bank::Bank;
using bank::ByDigits;

constexpr auto kExamples =
    R"(Prints include/wellstrat/joint_bank.h: 16 orders of a table's points that are stratified together,
found by a search that takes some minutes and gives the same bank on every machine. What it looks
for is in tools/bank_search/merit.h.

With --judge, nothing is searched. Instead, the slots in the library are judged: for each integrand,
as a function of one domain times the same of another, the error with N points over that of padded
domains, over all pairs of slots. Exact, as no sample is drawn.

Examples:
  wellstrat bank --slots 4
  wellstrat bank -o joint_bank.h
  wellstrat bank --judge
  wellstrat bank --judge --integrands disk,edge-30 --slots 8

Exit codes: 0 done, 2 error.
)";

struct BankOptions {
    uint64_t seed = bank::SearchOptions().seed;
    uint64_t rounds = bank::SearchOptions().rounds;
    uint64_t slots = kJointSlots;
    bool judge = false;
    std::vector<std::string> integrands;
    std::string output = "-";
};

std::string headerText(const Bank& slots) {
    std::string text = R"(// SPDX-License-Identifier: Apache-2.0
//
// The orders of the slots of joint.h. Made by `wellstrat bank`, which see for how.

#pragma once

#include <cstdint>

namespace wellstrat {

/// Row d is the matrix U_d over GF(2) of slot d, given by its columns: column k is what bit k of an
/// index contributes to the place of the sample, bit r of a column being row r. Upper triangular
/// with a diagonal of ones.
)";
    const auto out = std::back_inserter(text);
    fmt::format_to(out, "inline constexpr uint16_t kJointBank[{}][{}] = {{\n", slots.size(),
                   bank::kDigits);
    for (const bank::Columns& columns : slots) {
        fmt::format_to(out, "    {{{:#05x}}},\n", fmt::join(columns, ", "));
    }
    return text + "};\n\n} // namespace wellstrat\n";
}

std::string searched(const BankOptions& options) {
    ProgressBar bar("searching:");
    bank::SearchOptions search;
    search.seed = static_cast<uint32_t>(options.seed);
    search.rounds = static_cast<unsigned>(options.rounds);
    search.slots = options.slots;
    return headerText(bank::searchBank(search, [&](double done) { bar.show(done); }));
}

Bank libraryBank(std::size_t slots) {
    Bank result(slots);
    for (std::size_t d = 0; d < slots; ++d) {
        std::copy_n(kJointBank[d], bank::kDigits, result[d].begin());
    }
    return result;
}

/// Those of `--judge`, or all 2D ones that the groups have.
std::vector<std::string> integrandNames(const BankOptions& options) {
    if (!options.integrands.empty()) return options.integrands;
    std::vector<std::string> names;
    const auto add = [&names](const std::string& name) {
        const bool known = std::find(names.begin(), names.end(), name) != names.end();
        if (!known && makeIntegrand(name).domains == DomainDims{2}) names.push_back(name);
    };
    for (const IntegrandFamily& family : integrandFamilies()) {
        if (!family.hasParameter) add(family.name);
    }
    for (const IntegrandGroup& group : integrandGroups()) {
        for (const std::string& member : group.members) add(member);
    }
    return names;
}

/// The mean and the worst ratio, or the bound and nothing, for each number of points.
std::string row(const std::string& name, const std::string& what, const ByDigits& values) {
    std::string text = fmt::format("{:<16} {:<5}", name, what);
    for (unsigned m = 2; m <= bank::kDigits; ++m) {
        fmt::format_to(std::back_inserter(text), " {:5.2f}", values[m]);
    }
    return text + '\n';
}

std::string judged(const BankOptions& options) {
    const Bank slots = libraryBank(options.slots);
    const std::vector<std::string> names = integrandNames(options);
    std::string text = fmt::format("{:<16} {:<5}", "integrand^2", "");
    for (unsigned m = 2; m <= bank::kDigits; ++m) {
        fmt::format_to(std::back_inserter(text), " {:5}", 1u << m);
    }
    text += '\n';
    bank::Judgement all{};
    ProgressBar bar("judging:");
    for (std::size_t i = 0; i < names.size(); ++i) {
        const bank::Judgement one = bank::judge(slots, makeIntegrand(names[i]));
        text += row(names[i], "mean", one.mean) + row("", "worst", one.worst) +
                row("", "bound", one.bound);
        for (unsigned m = 0; m <= bank::kDigits; ++m) {
            all.mean[m] += one.mean[m] / static_cast<double>(names.size());
            all.worst[m] = std::max(all.worst[m], one.worst[m]);
            all.bound[m] += one.bound[m] / static_cast<double>(names.size());
        }
        bar.show(static_cast<double>(i + 1) / static_cast<double>(names.size()));
    }
    if (names.size() == 1) return text;
    return text + row("all", "mean", all.mean) + row("", "worst", all.worst) +
           row("", "bound", all.bound);
}

void run(const BankOptions& options) {
    OutputFile file(options.output);
    file.write(options.judge ? judged(options) : searched(options));
    file.commit();
}

} // namespace

void addBank(CLI::App& app, int& /*exitCode*/) {
    CLI::App* const command =
        app.add_subcommand("bank", "Search the orders of slots that are stratified together");
    const auto options = std::make_shared<BankOptions>();
    CLI::Option* const seed = addNumber(*command, "--seed", options->seed, {0, kMaxWord},
                                        fmt::format("Seed of the search [{}]", options->seed));
    CLI::Option* const rounds =
        addNumber(*command, "--rounds", options->rounds, {0, 1000000},
                  fmt::format("Attempts to improve 2, 4, 8 and 16 slots [{}]", options->rounds));
    addNumber(*command, "--slots", options->slots, {2, kJointSlots},
              "Only the first so many slots, which depend on no others [16]");
    CLI::Option* const judge =
        command->add_flag("--judge", options->judge, "Judge the slots of the library instead")
            ->excludes(seed)
            ->excludes(rounds);
    command
        ->add_option("--integrands", options->integrands,
                     "With --judge: A,B,... with one 2D domain each [all in the groups of study]")
        ->delimiter(',')
        ->type_name("NAMES")
        ->needs(judge);
    command->add_option("-o", options->output, "Write to FILE [standard output]")
        ->type_name("FILE");
    command->footer(kExamples);
    command->callback([options] { run(*options); });
}

} // namespace wellstrat::cli
