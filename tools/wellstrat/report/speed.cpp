// SPDX-License-Identifier: Apache-2.0

#include "figures.h"
#include "sections.h"

#include <fmt/format.h>

namespace wellstrat::cli {

void addSpeed(ReportWriter& report, const BenchResults& bench) {
    report.page.section("Speed");
    report.page.paragraph(
        fmt::format("Measured by `scripts/bench` on {}{}; batches run on {}. All tables are built "
                    "in {:.1f} ms.",
                    bench.processor, bench.date.empty() ? "" : ", " + bench.date, bench.target,
                    bench.tablesMs));
    const std::vector<BenchTime> bars = bench.of2DSamples();
    if (!bars.empty()) {
        report.page.figure({{{"times of 2D samples", report.draw("speed", speedFigure(bars))}},
                            "Nanoseconds for a 2D sample, shorter is faster: wellstrat blue, "
                            "others gray. Batches have 4096 samples."});
    }
    HtmlTable table{"All medians. The spread is half the interquartile range.",
                    {"benchmark", "ns", "spread (%)"},
                    {}};
    for (const BenchTime& time : bench.times) {
        table.rows.push_back(
            {time.name, fmt::format("{:.2f}", time.median), fmt::format("{:.0f}", time.spread)});
    }
    report.page.table(table);
}

} // namespace wellstrat::cli
