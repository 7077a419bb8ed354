// SPDX-License-Identifier: Apache-2.0
//
// wellstrat bank: searches the orders of the slots of wellstrat/joint.h, and judges them.

#include "bank/header.h"
#include "bank/judgement.h"
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

constexpr auto kExamples =
    R"(Prints include/wellstrat/joint_bank.h: 16 orders of points that are stratified together, found by a
search that takes some minutes and gives the same bank on every machine. What it looks for is in
tools/bank_search/merit.h.

With --judge, nothing is searched. Instead, the slots in the library are judged: for products of two
integrands, each a function of the 1D, 2D or 3D sample of one slot, the error with N points over
that of padded domains, over all pairs of slots and both directions: the mean, the worst, and the
pair of slots that has it. Exact, as no sample is drawn. A*B is A of one slot times B of the other,
A alone is A*A. Without --integrands: all products of what `study` has, which takes minutes.

Examples:
  wellstrat bank --slots 4
  wellstrat bank -o joint_bank.h
  wellstrat bank --judge
  wellstrat bank --judge --integrands disk,linear*edge-30 --slots 8

Exit codes: 0 done, 2 error.
)";

struct BankOptions {
    uint64_t seed = bank::SearchOptions().seed;
    uint64_t width = bank::SearchOptions().width;
    uint64_t slots = kJointSlots;
    bool judge = false;
    std::vector<std::string> integrands;
    std::string output = "-";
};

std::string searched(const BankOptions& options) {
    ProgressBar bar("searching:");
    bank::SearchOptions search;
    search.seed = static_cast<uint32_t>(options.seed);
    search.width = static_cast<unsigned>(options.width);
    search.slots = options.slots;
    return bankHeader(bank::searchBank(search, [&](double done) { bar.show(done); }));
}

Bank libraryBank(std::size_t slots) {
    Bank result(slots);
    for (std::size_t d = 0; d < slots; ++d) {
        std::copy_n(kJointBank[d], bank::kDigits, result[d].begin());
    }
    return result;
}

std::string judged(const BankOptions& options) {
    const Bank slots = libraryBank(options.slots);
    return options.integrands.empty() ? judgedDraws(slots)
                                      : judgedProducts(slots, options.integrands);
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
    CLI::Option* const width =
        addNumber(*command, "--width", options->width, {1, 100000},
                  fmt::format("Banks that the search continues at once [{}]", options->width));
    addNumber(*command, "--slots", options->slots, {2, kJointSlots},
              "Only the first so many slots; the first 8 depend on no others [16]");
    CLI::Option* const judge =
        command->add_flag("--judge", options->judge, "Judge the slots of the library instead")
            ->excludes(seed)
            ->excludes(width);
    command
        ->add_option("--integrands", options->integrands,
                     "With --judge: A,B*C,..., products of two slots [all]")
        ->delimiter(',')
        ->type_name("NAMES")
        ->needs(judge);
    command->add_option("-o", options->output, "Write to FILE [standard output]")
        ->type_name("FILE");
    command->footer(kExamples);
    command->callback([options] { run(*options); });
}

} // namespace wellstrat::cli
