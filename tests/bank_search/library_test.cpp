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
    const Row worst[] = {{"64", {1.04, 1.32, 2.69}},   {"128", {1.13, 1.27, 1.88}},
                         {"256", {1.11, 1.32, 2.03}},  {"512", {0.96, 1.26, 1.91}},
                         {"1024", {1.02, 1.23, 1.92}}, {"2048", {0.97, 1.18, 1.67}},
                         {"4096", {0.77, 1.1, 2.03}}};
    const Row mean[] = {{"1D x 1D", {0.154, 0.183, 0.215}}, {"1D x 2D", {0.384, 0.404, 0.453}},
                        {"1D x 3D", {0.459, 0.489, 0.536}}, {"2D x 2D", {0.46, 0.479, 0.523}},
                        {"2D x 3D", {0.545, 0.568, 0.61}},  {"3D x 3D", {0.605, 0.63, 0.671}}};
    const Judge judge(judgedLab(plainLab()), kLast);
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

/// What models of the merit have on average.
TEST(BankOfLibrary, ModelsAreAsTheDecisionSays) {
    const Row mean[] = {{"^band [1-4]", {0.735, 0.764, 0.799}},
                        {"^stripes", {0.272, 0.298, 0.395}},
                        {"by 2", {0.404, 0.435, 0.501}},
                        {"by 4", {0.439, 0.489, 0.545}},
                        {"by 16", {0.537, 0.589, 0.626}}};
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
