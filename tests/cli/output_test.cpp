// SPDX-License-Identifier: Apache-2.0
//
// Axes, names and marks of pages and pictures.

#include "common/output/axes.h"
#include "common/output/html_page.h"
#include "common/output/readable_names.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>
#include <utility>

namespace wellstrat::cli {
namespace {

AxisRange rangeOf(double low, double high) {
    AxisRange range;
    for (const double value : {high, low, 0.0, std::nan("")}) range.add(value);
    return range;
}

TEST(Axes, EndWithTheDataAndDouble) {
    EXPECT_EQ(doublingAxis("x", rangeOf(1, 16)),
              "set logscale x\nset xrange [1:16]\nset xtics (1, 2, 4, 8, 16)\n");
    EXPECT_EQ(doublingAxis("x", rangeOf(3, 48)),
              "set logscale x\nset xrange [3:48]\nset xtics (4, 8, 16, 32)\n");
    EXPECT_EQ(doublingAxis("x", rangeOf(1, 4096)),
              "set logscale x\nset xrange [1:4096]\nset xtics (1, 4, 16, 64, 256, 1024, 4096)\n");
}

TEST(Axes, OfDecimalNumbers) {
    EXPECT_EQ(decimalAxis("y", rangeOf(0.04, 0.3)),
              "set logscale y\nset yrange [0.04:0.3]\n"
              "set ytics ('0.05' 0.05, '0.1' 0.1, '0.2' 0.2)\n");
    EXPECT_EQ(decimalAxis("y", rangeOf(1e-6, 1)),
              "set logscale y\nset yrange [1e-06:1]\n"
              "set ytics ('10^{-6}' 1e-06, '10^{-5}' 1e-05, '10^{-4}' 0.0001, '0.001' 0.001, "
              "'0.01' 0.01, '0.1' 0.1, '1' 1)\n");
    EXPECT_NE(decimalAxis("y", rangeOf(1e-6, 4e-6)).find("'2\u00b710^{-6}' 2e-06"),
              std::string::npos);
    EXPECT_EQ(decimalAxis("y", rangeOf(0.0225, 0.097)),
              "set logscale y\nset yrange [0.0225:0.097]\n"
              "set ytics ('0.03' 0.03, '0.05' 0.05, '0.07' 0.07)\n");
}

/// gnuplot takes no range of one number, and nothing is a range of none.
TEST(Axes, OfOneNumberAndNone) {
    EXPECT_EQ(decimalAxis("y", rangeOf(1, 1)),
              "set logscale y\nset yrange [0.8:1.25]\nset ytics ('1' 1)\n");
    EXPECT_EQ(doublingAxis("x", {}), "set logscale x\nset xrange [0.8:1.25]\nset xtics (1)\n");
}

TEST(ReadableNames, OfGeneratorsAndIntegrands) {
    EXPECT_EQ(generatorTitle("pmj"), "Stratified");
    EXPECT_EQ(generatorTitle("long:3+7"), "Stratified, long, slots 3+7");
    EXPECT_EQ(generatorTitle("file:a/b.npy"), "b.npy");
    EXPECT_EQ(generatorTitle("gsl-sobol"), "gsl-sobol");
    EXPECT_EQ(integrandTitle("gaussian-3d"), "Gaussian 3D");
    EXPECT_EQ(integrandTitle("disk^2*linear"), "Disk in 2 domains times linear");
    EXPECT_EQ(integrandTitle("box-1d-7"), "Box 1D 7");
}

TEST(HtmlTable, MarksTheBest) {
    HtmlTable table{"", {"name", "a", "b"}, {}};
    table.rows = {
        {"p", "2e-3", "0 (1)"}, {"q", "1e-3", "-"}, {"r", "1e-3", "0 (0)"}, {"s", "0", "1"}};
    using Cells = std::set<std::pair<std::size_t, std::size_t>>;
    table.markBest(1, {0, 1, 2}, Best::least);
    EXPECT_EQ(table.best, (Cells{{1, 1}, {2, 1}}));
    table.best.clear();
    table.markBest(2, Best::least);
    EXPECT_EQ(table.best, (Cells{{0, 2}, {2, 2}}));
    table.best.clear();
    table.markBest(1, Best::most);
    EXPECT_EQ(table.best, (Cells{{0, 1}}));
    table.best.clear();
    table.markBest(1, {1, 2}, Best::least); // all the same
    table.markBest(0, Best::least);         // no numbers
    EXPECT_TRUE(table.best.empty());
}

} // namespace
} // namespace wellstrat::cli
