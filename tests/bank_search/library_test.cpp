// SPDX-License-Identifier: Apache-2.0
//
// What is said of the slots of the library (docs/decisions/0027-no-bad-pair.md), exactly.

#include "bank_search/judge.h"
#include "bank_search/merit.h"
#include "lab.h"

#include "wellstrat/joint_bank.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <regex>
#include <string>
#include <utility>
#include <vector>

namespace bank_tests {
namespace {

using namespace wellstrat::bank;
using wellstrat::kJointBank;

constexpr std::size_t kFirstSlots[] = {4, 8, 16};
constexpr unsigned kFirst = 6, kLast = 12; ///< digits of N = 64 to 4096

Columns slotOfLibrary(std::size_t slot) {
    Columns result{};
    std::copy(std::begin(kJointBank[slot]), std::end(kJointBank[slot]), result.begin());
    return result;
}

/// A row of the decision's tables, by number of slots as in kFirstSlots.
struct Row {
    const char* name;
    double values[3];
};

/// Over the products of all integrands, the worst ratio of pairs of slots by N, and the mean over N
/// by what is drawn from the two slots; the finer grids of the decision have more levels.
TEST(BankOfLibrary, ProductsAreAsTheDecisionSays) {
    const Row worst[] = {{"64", {1.05, 1.32, 2.69}},   {"128", {1.12, 1.26, 1.87}},
                         {"256", {1.14, 1.34, 1.88}},  {"512", {0.98, 1.33, 1.93}},
                         {"1024", {1.07, 1.22, 1.87}}, {"2048", {1.03, 1.21, 1.7}},
                         {"4096", {0.99, 1.13, 1.58}}};
    const Row mean[] = {{"1D x 1D", {0.181, 0.194, 0.203}}, {"1D x 2D", {0.375, 0.405, 0.46}},
                        {"1D x 3D", {0.486, 0.503, 0.545}}, {"2D x 2D", {0.459, 0.475, 0.517}},
                        {"2D x 3D", {0.546, 0.57, 0.61}},   {"3D x 3D", {0.611, 0.636, 0.675}}};
    constexpr unsigned kGridDigits = 22;
    const Judge judge(judgedLab(plainLab(), kGridDigits), kLast);
    const auto& integrands = judge.integrands();
    std::map<std::string, double> most[3];
    std::map<std::string, std::pair<double, double>> sums[3];
    for (std::size_t a = 0; a < 16; ++a) {
        for (std::size_t b = 0; b < a; ++b) {
            const auto ratios = judge.ratios(slotOfLibrary(a), slotOfLibrary(b));
            for (std::size_t i = 0; i < ratios.size(); ++i) {
                const auto [low, high] = std::minmax(integrands[i / integrands.size()].dims,
                                                     integrands[i % integrands.size()].dims);
                const std::string draws = std::to_string(low) + "D x " + std::to_string(high) + 'D';
                for (unsigned m = kFirst; m <= kLast; ++m) {
                    for (std::size_t k = 0; k < 3; ++k) {
                        if (a >= kFirstSlots[k]) continue;
                        double& known = most[k][std::to_string(1u << m)];
                        known = std::max(known, ratios[i][m]);
                        sums[k][draws].first += ratios[i][m];
                        ++sums[k][draws].second;
                    }
                }
            }
        }
    }
    for (std::size_t k = 0; k < 3; ++k) {
        for (const auto& [name, values] : worst) {
            EXPECT_NEAR(most[k][name], values[k], 0.02) << kFirstSlots[k] << ' ' << name;
        }
        for (const auto& [name, values] : mean) {
            const auto [sum, count] = sums[k][name];
            EXPECT_NEAR(sum / count, values[k], 0.01) << kFirstSlots[k] << ' ' << name;
        }
    }
}

/// The geometric mean over products of 2D integrands of the two slots that most programs take.
TEST(BankOfLibrary, FirstTwoSlotsAreAsTheDecisionSays) {
    const double mean[] = {0.58, 0.57, 0.44, 0.4, 0.34, 0.29, 0.21};
    std::vector<JudgedIntegrand> lab = judgedLab(plainLab());
    lab.erase(std::remove_if(lab.begin(), lab.end(),
                             [](const JudgedIntegrand& f) { return f.dims != 2; }),
              lab.end());
    const Judge judge(lab, kLast);
    const auto ratios = judge.ratios(slotOfLibrary(0), slotOfLibrary(1));
    for (unsigned m = kFirst; m <= kLast; ++m) {
        double sum = 0;
        for (const ByDigits& ratio : ratios) sum += std::log(ratio[m]);
        EXPECT_NEAR(std::exp(sum / static_cast<double>(ratios.size())), mean[m - kFirst], 0.01)
            << m;
    }
}

/// What models of the merit have on average.
TEST(BankOfLibrary, ModelsAreAsTheDecisionSays) {
    const Row mean[] = {{"^band [1-4]", {0.76, 0.758, 0.801}},
                        {"^stripes", {0.24, 0.279, 0.396}},
                        {"by 2", {0.389, 0.421, 0.498}},
                        {"by 4", {0.432, 0.46, 0.544}},
                        {"by 16", {0.532, 0.559, 0.626}}};
    for (const auto& [name, values] : mean) {
        double sum = 0, count = 0;
        std::size_t k = 0;
        for (std::size_t a = 0; a < 16; ++a) {
            for (std::size_t b = 0; b < a; ++b) {
                for (const PairModel& model : pairModels()) {
                    if (!std::regex_search(model.name, std::regex(name))) continue;
                    const ByDigits ratios = squaredRatios(model, orderOf(slotOfLibrary(a), kLast),
                                                          orderOf(slotOfLibrary(b), kLast));
                    for (unsigned m = kFirst; m <= kLast; ++m, ++count) sum += std::sqrt(ratios[m]);
                }
            }
            if (a + 1 != kFirstSlots[k]) continue;
            EXPECT_NEAR(sum / count, values[k++], 0.0015) << a + 1 << ' ' << name;
        }
    }
}

} // namespace
} // namespace bank_tests
