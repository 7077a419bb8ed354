// SPDX-License-Identifier: Apache-2.0
#include "bank/judgement.h"

#include "bank_search/judge.h"
#include "common/command_line/errors.h"
#include "common/command_line/progress.h"
#include "wellstrat/analysis/integrands.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <iterator>
#include <map>
#include <utility>

namespace wellstrat::cli {
namespace {

using bank::Bank;
using bank::ByDigits;
using bank::Judge;
using bank::kDigits;

constexpr unsigned kFirstDigits = 2; ///< the first N of a table is 4

/// A product: f of one slot, g of another.
struct Meeting {
    std::size_t slotF, slotG, f, g;
};

struct Worst {
    double ratio = -1;
    Meeting meeting{};
};

/// Means and worst ratios of some meetings.
class Summary {
public:
    void add(const Meeting& meeting, const ByDigits& ratios) {
        ++count_;
        for (unsigned m = 0; m <= kDigits; ++m) {
            sums_[m] += ratios[m];
            if (ratios[m] > worst_[m].ratio) worst_[m] = {ratios[m], meeting};
        }
    }

    ByDigits mean() const {
        ByDigits result = sums_;
        for (double& value : result) value /= count_;
        return result;
    }

    ByDigits worst() const {
        ByDigits result{};
        for (unsigned m = 0; m <= kDigits; ++m) result[m] = worst_[m].ratio;
        return result;
    }

    /// The slots of the worst ratios.
    std::string worstPairs() const {
        std::string text;
        for (unsigned m = kFirstDigits; m <= kDigits; ++m) {
            const Meeting& meeting = worst_[m].meeting;
            text += fmt::format(" {:>5}", fmt::format("{}-{}", meeting.slotF, meeting.slotG));
        }
        return text;
    }

    /// The worst ratio for 64 points or more, in words.
    std::string worstOfAll(const Judge& judge) const {
        const auto worst =
            std::max_element(worst_.begin() + 6, worst_.end(),
                             [](const Worst& a, const Worst& b) { return a.ratio < b.ratio; });
        const auto& [slotF, slotG, f, g] = worst->meeting;
        return fmt::format("{:.2f} with {} points: {} of slot {}, {} of slot {}", worst->ratio,
                           1u << (worst - worst_.begin()), judge.integrands()[f].name, slotF,
                           judge.integrands()[g].name, slotG);
    }

private:
    double count_ = 0;
    ByDigits sums_{};
    std::array<Worst, kDigits + 1> worst_{};
};

std::string head(const std::string& what) {
    std::string text = fmt::format("{:<24} {:<5}", what, "");
    for (unsigned m = kFirstDigits; m <= kDigits; ++m) text += fmt::format(" {:5}", 1u << m);
    return text + '\n';
}

std::string row(const std::string& name, const std::string& what, const ByDigits& values) {
    std::string text = fmt::format("{:<24} {:<5}", name, what);
    for (unsigned m = kFirstDigits; m <= kDigits; ++m) text += fmt::format(" {:5.2f}", values[m]);
    return text + '\n';
}

std::string rows(const std::string& name, const Summary& summary) {
    return row(name, "mean", summary.mean()) + row("", "worst", summary.worst()) +
           fmt::format("{:<24} {:<5}{}\n", "", "pair", summary.worstPairs());
}

/// The ratios of all products, [f * integrands + g] by slots a > b, f being of slot a.
using PairRatios = std::map<std::pair<std::size_t, std::size_t>, std::vector<ByDigits>>;

PairRatios judgedPairs(const Bank& bank, const Judge& judge) {
    PairRatios result;
    for (std::size_t a = 0; a < bank.size(); ++a) {
        for (std::size_t b = 0; b < a; ++b) result[{a, b}];
    }
    ProgressBar bar("judging:");
    std::atomic<std::size_t> done{0};
    std::vector<PairRatios::iterator> pairs;
    for (auto pair = result.begin(); pair != result.end(); ++pair) pairs.push_back(pair);
    tbb::parallel_for(std::size_t{0}, pairs.size(), [&](std::size_t i) {
        const auto [a, b] = pairs[i]->first;
        pairs[i]->second = judge.ratios(bank[a], bank[b]);
        bar.show(static_cast<double>(++done) / static_cast<double>(pairs.size()));
    });
    return result;
}

Judge judgeOf(const std::vector<std::string>& names) {
    std::vector<bank::JudgedIntegrand> integrands(names.size());
    ProgressBar bar("measuring integrands:");
    std::atomic<std::size_t> done{0};
    tbb::parallel_for(std::size_t{0}, names.size(), [&](std::size_t i) {
        integrands[i] = bank::judgedIntegrand(makeIntegrand(names[i]));
        bar.show(static_cast<double>(++done) / static_cast<double>(names.size()));
    });
    return Judge(std::move(integrands));
}

/// All of study with one domain.
std::vector<std::string> integrandNames() {
    std::vector<std::string> names;
    const auto add = [&names](const std::string& name) {
        const bool known = std::find(names.begin(), names.end(), name) != names.end();
        if (!known && makeIntegrand(name).domains.size() == 1) names.push_back(name);
    };
    for (const IntegrandFamily& family : integrandFamilies()) {
        if (!family.hasParameter) add(family.name);
    }
    for (const IntegrandGroup& group : integrandGroups()) {
        for (const std::string& member : group.members) add(member);
    }
    return names;
}

/// Adds `name` if it is new, and returns its number.
std::size_t numberOf(std::vector<std::string>& names, const std::string& name) {
    if (makeIntegrand(name).domains.size() != 1) {
        throw CliError("option --integrands: '" + name + "' does not have just one domain");
    }
    const auto found = std::find(names.begin(), names.end(), name) - names.begin();
    const auto number = static_cast<std::size_t>(found);
    if (number == names.size()) names.push_back(name);
    return number;
}

} // namespace

std::string judgedProducts(const Bank& bank, const std::vector<std::string>& products) {
    std::vector<std::string> names;
    std::vector<std::pair<std::size_t, std::size_t>> factors;
    for (const std::string& product : products) {
        const std::size_t star = product.find('*');
        const std::size_t f = numberOf(names, product.substr(0, star));
        const bool isSquare = star == std::string::npos;
        factors.emplace_back(f, isSquare ? f : numberOf(names, product.substr(star + 1)));
    }
    const Judge judge = judgeOf(names);
    const PairRatios pairs = judgedPairs(bank, judge);
    std::string text = head("product");
    Summary all;
    for (std::size_t i = 0; i < products.size(); ++i) {
        const auto [f, g] = factors[i];
        Summary summary;
        for (const auto& [slots, ratios] : pairs) {
            const auto [a, b] = slots;
            const auto add = [&, a = a, b = b, &ratios = ratios, &f = f, &g = g](bool exchanged) {
                const Meeting meeting = exchanged ? Meeting{b, a, f, g} : Meeting{a, b, f, g};
                const std::size_t at = exchanged ? g * names.size() + f : f * names.size() + g;
                summary.add(meeting, ratios[at]);
                all.add(meeting, ratios[at]);
            };
            add(true);
            if (f != g) add(false);
        }
        text += rows(f == g ? products[i] + "^2" : products[i], summary);
        if (f == g) text += row("", "bound", judge.floor(f, bank.size()));
    }
    return products.size() == 1 ? text : text + rows("all", all);
}

std::string judgedDraws(const Bank& bank) {
    const Judge judge = judgeOf(integrandNames());
    const PairRatios pairs = judgedPairs(bank, judge);
    const std::vector<bank::JudgedIntegrand>& integrands = judge.integrands();
    std::string text = head("slots, draws");
    for (std::size_t slots = 4; slots / 2 < bank.size(); slots *= 2) {
        const std::size_t count = std::min(slots, bank.size());
        std::map<std::pair<unsigned, unsigned>, Summary> summaries;
        for (const auto& [numbers, ratios] : pairs) {
            const auto [a, b] = numbers;
            if (a >= count) continue;
            for (std::size_t f = 0; f < integrands.size(); ++f) {
                for (std::size_t g = 0; g < integrands.size(); ++g) {
                    const Meeting meeting = integrands[f].dims <= integrands[g].dims
                                                ? Meeting{a, b, f, g}
                                                : Meeting{b, a, g, f};
                    summaries[{integrands[meeting.f].dims, integrands[meeting.g].dims}].add(
                        meeting, ratios[f * integrands.size() + g]);
                }
            }
        }
        for (const auto& [draws, summary] : summaries) {
            const std::string name = fmt::format("{}, {}D x {}D", count, draws.first, draws.second);
            text += rows(name, summary) + fmt::format("{:<24} {}\n", "", summary.worstOfAll(judge));
        }
    }
    return text;
}

} // namespace wellstrat::cli
