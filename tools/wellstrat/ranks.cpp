// SPDX-License-Identifier: Apache-2.0
//
// wellstrat ranks: searches the ranks of pixels and slots of wellstrat/blue_tables.h, and judges
// them.

#include "commands.h"
#include "common/command_line/options.h"
#include "common/command_line/progress.h"
#include "common/output/output_file.h"
#include "rank_search/judge.h"
#include "rank_search/search.h"
#include "rank_search/z_search.h"
#include "wellstrat/blue_tables.h"
#include "wellstrat/order.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <string>

namespace wellstrat::cli {
namespace {

constexpr auto kExamples =
    R"(Prints include/wellstrat/blue_tables.h: the ranks that make neighbouring pixels stratified together,
in a tile for padded domains and in one for slots, and what makes each slot's rank of the latter.
Found for the orders of slots in the library by a search that takes some minutes and gives the same
ranks on every machine. What it looks for is in tools/rank_search/merit.h.

With --z, prints the columns of the matrix Dz of include/wellstrat/rank.h instead, found likewise.

With --judge, nothing is searched. Instead, the ranks in the library are judged: for each model, the
error with N samples a pixel after a Gaussian filter of sigma 2 pixels, over that of independent
pixels with padded domains. Exact, as no sample is drawn.

Examples:
  wellstrat ranks -o blue_tables.h
  wellstrat ranks --z
  wellstrat ranks --judge
  wellstrat ranks --judge --slots 2

Exit codes: 0 done, 2 error.
)";

struct RanksOptions {
    uint64_t seed = ranks::SearchOptions().seed;
    uint64_t sweeps = ranks::SearchOptions().sweeps;
    uint64_t rounds = ranks::SearchOptions().rounds;
    uint64_t slots = kJointSlots;
    bool judge = false;
    bool z = false;
    std::string output = "-";
};

/// In rows of 16, in columns as clang-format wants them.
std::string tileText(const std::string& name, const ranks::Tile& tile) {
    std::string text = fmt::format("inline constexpr uint16_t {}[{}] = {{", name, tile.size());
    for (std::size_t i = 0; i < tile.size(); ++i) {
        const std::string number = fmt::format("{},", tile[i]);
        if (i % 16 == 0) text += "\n    ";
        text += i % 16 == 15 ? number : fmt::format("{:<6}", number);
    }
    return text + "\n};\n";
}

std::string headerText(const ranks::RankTables& tables) {
    std::string text = R"(// SPDX-License-Identifier: Apache-2.0
//
// The ranks of pixels (rank.h), and of slots. Made by `wellstrat ranks`, which see for how.

#pragma once

#include "wellstrat/platform.h"

#include <cstdint>

namespace wellstrat {
inline namespace stream1 {

/// Row d is the matrix V_d over GF(2) that makes the rank of slot d of that of a pixel, given by
/// its columns: column k is what bit k of the pixel's rank adds, bit r of a column being row r. In
/// blocks of 2 x 2 it is upper triangular with invertible blocks on its diagonal, so that aligned
/// runs of 4^a ranks are mapped to such runs.
)";
    fmt::format_to(std::back_inserter(text), "inline constexpr uint16_t kRankBank[{}][{}] = {{\n",
                   tables.bank.size(), kRankDigits);
    for (const ranks::RankColumns& columns : tables.bank) {
        fmt::format_to(std::back_inserter(text), "    {{{:#05x}}},\n", fmt::join(columns, ", "));
    }
    text += R"(};

/// The rank of pixel (x, y) of a toroidal tile is element (y & 63) << 6 | (x & 63). An aligned
/// block of 2^a x 2^a pixels has an aligned run of 4^a ranks. For padded domains.
)";
    text += tileText("kRankTilePadded", tables.padded);
    text += "\n/// The same for slots.\n" + tileText("kRankTileSlots", tables.slots);
    return text + "\n} // namespace stream1\n} // namespace wellstrat\n";
}

std::string searched(const RanksOptions& options) {
    ranks::SearchOptions search;
    search.seed = static_cast<uint32_t>(options.seed);
    search.sweeps = static_cast<unsigned>(options.sweeps);
    search.rounds = static_cast<unsigned>(options.rounds);
    search.slots = options.slots;
    ProgressBar bar("searching:");
    return headerText(ranks::searchRanks(search, [&](double done) { bar.show(done); }));
}

std::string searchedZ(const RanksOptions& options) {
    const RankMatrix matrix = ranks::searchZ(static_cast<uint32_t>(options.seed));
    return fmt::format("{:#010x}\n", fmt::join(matrix.column, ", "));
}

ranks::RankTables libraryTables(std::size_t slots) {
    ranks::RankTables tables{ranks::RankBank(slots),
                             {std::begin(kRankTilePadded), std::end(kRankTilePadded)},
                             {std::begin(kRankTileSlots), std::end(kRankTileSlots)}};
    for (std::size_t d = 0; d < slots; ++d) {
        std::copy_n(kRankBank[d], kRankDigits, tables.bank[d].begin());
    }
    return tables;
}

std::string judged(const RanksOptions& options) {
    std::string text = fmt::format("{:<28}", "");
    for (unsigned k = 0; k <= ranks::kRunDigits; ++k) text += fmt::format(" {:5}", 1u << k);
    text += '\n';
    for (const ranks::Judgement& row : ranks::judge(libraryTables(options.slots))) {
        text += fmt::format("{:<7} {:<15} {:<5} {:5.2f}\n", row.what, row.model, row.statistic,
                            fmt::join(row.ratios, " "));
    }
    return text;
}

void run(const RanksOptions& options) {
    OutputFile file(options.output);
    file.write(options.judge ? judged(options)
               : options.z   ? searchedZ(options)
                             : searched(options));
    file.commit();
}

} // namespace

void addRanks(CLI::App& app, int& /*exitCode*/) {
    CLI::App* const command = app.add_subcommand(
        "ranks", "Search the ranks of pixels that are stratified with their neighbours");
    const auto options = std::make_shared<RanksOptions>();
    CLI::Option* const seed = addNumber(
        *command, "--seed", options->seed, {0, kMaxWord},
        fmt::format("Seed of the search [{}, with --z {}]", options->seed, ranks::kSeedOfZ));
    CLI::Option* const sweeps =
        addNumber(*command, "--sweeps", options->sweeps, {0, 1000000},
                  fmt::format("Sweeps over a tile that is annealed [{}]", options->sweeps));
    CLI::Option* const rounds =
        addNumber(*command, "--rounds", options->rounds, {0, 1000},
                  fmt::format("Attempts to improve the ranks of slots [{}]", options->rounds));
    CLI::Option* const slots =
        addNumber(*command, "--slots", options->slots, {2, kJointSlots},
                  fmt::format("Only the first so many slots [{}]", options->slots));
    CLI::Option* const z = command->add_flag("--z", options->z, "Print the matrix Dz instead")
                               ->excludes(sweeps)
                               ->excludes(rounds)
                               ->excludes(slots);
    command->add_flag("--judge", options->judge, "Judge the ranks of the library instead")
        ->excludes(seed)
        ->excludes(sweeps)
        ->excludes(rounds)
        ->excludes(z);
    command->add_option("-o", options->output, "Write to FILE [standard output]")
        ->type_name("FILE");
    command->footer(kExamples);
    command->callback([options, seed] {
        if (options->z && seed->empty()) options->seed = ranks::kSeedOfZ;
        run(*options);
    });
}

} // namespace wellstrat::cli
