// SPDX-License-Identifier: Apache-2.0

#include "set_summary.h"

#include <fmt/format.h>

#include <functional>
#include <utility>

namespace wellstrat::cli {
namespace {

class Summary {
public:
    explicit Summary(const Measures& measures) : measures_(measures) {}

    /// Adds what valueOf(set) gives, unless it is nowhere there.
    template <class ValueOf>
    void add(std::string measure, bool leastIsWorst, const ValueOf& valueOf) {
        const SetMeasures& first = measures_.sets.front().found;
        if (!valueOf(first)) return;
        SummaryRow row{std::move(measure), 0, *valueOf(first), measures_.sets.front().name};
        for (const NamedSetMeasures& set : measures_.sets) {
            const double value = *valueOf(set.found);
            row.mean += value / static_cast<double>(measures_.sets.size());
            if (leastIsWorst ? value < row.worst : value > row.worst) {
                row.worst = value;
                row.worstSet = set.name;
            }
        }
        rows_.push_back(std::move(row));
    }

    std::vector<SummaryRow> take() { return std::move(rows_); }

private:
    const Measures& measures_;
    std::vector<SummaryRow> rows_;
};

using Value = std::optional<double>;

Value minimumOf(const std::optional<NearestDistances>& distances) {
    return distances ? Value(distances->minimum) : Value();
}

} // namespace

std::vector<SummaryRow> summaryOf(const Measures& measures) {
    if (measures.sets.empty()) return {};
    Summary summary(measures);
    for (std::size_t k = 0; k < measures.nets.size(); ++k) {
        const std::string projection = projectionName(measures.nets[k].projection, measures.dims);
        summary.add("t " + projection, false,
                    [k](const SetMeasures& set) { return Value(set.nets[k].t); });
        summary.add("t of blocks " + projection, false,
                    [k](const SetMeasures& set) { return Value(set.nets[k].sequenceT); });
    }
    summary.add("star", false,
                [](const SetMeasures& set) { return set.star ? Value(set.star->upper) : Value(); });
    for (std::size_t k = 0; k < kL2Kinds.size(); ++k) {
        summary.add(fmt::format("L2 {}", kL2Kinds[k].name), false,
                    [k](const SetMeasures& set) { return set.l2[k]; });
    }
    summary.add("distance in cube", true,
                [](const SetMeasures& set) { return minimumOf(set.onCube); });
    summary.add("distance on torus", true,
                [](const SetMeasures& set) { return minimumOf(set.onTorus); });
    return summary.take();
}

} // namespace wellstrat::cli
