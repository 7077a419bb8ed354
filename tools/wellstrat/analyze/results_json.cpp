// SPDX-License-Identifier: Apache-2.0

#include "common/command_line/versions.h"
#include "results.h"
#include "set_summary.h"

#include <fmt/format.h>

#include <cmath>

namespace wellstrat::cli {
namespace {

using Json = nlohmann::ordered_json;

template <class Value>
Json jsonOf(const std::optional<Value>& value) {
    return value ? Json(*value) : Json(nullptr);
}

Json jsonOf(const std::optional<NearestDistances>& distances) {
    if (!distances || std::isinf(distances->minimum)) return nullptr;
    return {{"minimum", distances->minimum}, {"mean", distances->mean}};
}

Json jsonOf(const NetQuality& net) {
    return {{"projection", net.projection},
            {"t", net.t},
            {"sequence_t", jsonOf(net.sequenceT)},
            {"base4_boxes", jsonOf(net.holdsBase4Boxes)}};
}

Json jsonOf(const PlaneSpectrum& plane) {
    return {{"projection", plane.projection},
            {"max_frequency", plane.periodogram.maxFrequency()},
            {"radial_mean", plane.radial.mean},
            {"anisotropy_db", plane.radial.anisotropyDb},
            {"peak", {{"frequency", {plane.peak.fx, plane.peak.fy}}, {"power", plane.peak.power}}}};
}

Json jsonOf(const FamilyIndependence& family, unsigned dims) {
    Json worst = Json::array();
    for (const CoordinatePair& pair : family.report.worst) {
        worst.push_back({{"first", coordinateName(family, pair.first, pair.firstDim, dims)},
                         {"second", coordinateName(family, pair.second, pair.secondDim, dims)},
                         {"correlation", pair.correlation},
                         {"chi_square", pair.chiSquare},
                         {"probability", pair.probability()}});
    }
    return {{"family", family.name},
            {"pairs", family.report.pairs},
            {"grid_side", family.gridSide},
            {"correlation_spread", family.report.correlationSpread},
            {"mean_chi_square", family.report.meanChiSquare},
            {"worst", worst}};
}

template <class Range, class... More>
Json arrayOf(const Range& range, const More&... more) {
    Json array = Json::array();
    for (const auto& element : range) array.push_back(jsonOf(element, more...));
    return array;
}

/// Infinity, of a single point, is no JSON.
Json finite(double value) { return std::isinf(value) ? Json(nullptr) : Json(value); }

/// What was measured of one set alone.
Json jsonOf(const SetMeasures& set) {
    Json json;
    json["nets"] = arrayOf(set.nets);
    Json& discrepancy = json["discrepancy"];
    discrepancy["star"] = nullptr;
    if (set.star) discrepancy["star"] = {set.star->lower, set.star->upper};
    for (std::size_t k = 0; k < kL2Kinds.size(); ++k) {
        discrepancy[fmt::format("l2_{}", kL2Kinds[k].name)] = jsonOf(set.l2[k]);
    }
    json["nearest"] = {{"cube", jsonOf(set.onCube)}, {"torus", jsonOf(set.onTorus)}};
    json["pair_correlation"] = nullptr;
    if (set.pairs) {
        json["pair_correlation"] = {{"step", set.pairs->step}, {"values", set.pairs->values}};
    }
    return json;
}

Json summaryJson(const Measures& measures) {
    Json json = Json::array();
    for (const SummaryRow& row : summaryOf(measures)) {
        json.push_back({{"measure", row.measure},
                        {"mean", finite(row.mean)},
                        {"worst", finite(row.worst)},
                        {"worst_set", row.worstSet}});
    }
    return json;
}

Json setsJson(const Measures& measures) {
    Json json = Json::array();
    for (const NamedSetMeasures& set : measures.sets) {
        json.push_back({{"name", set.name}});
        json.back().update(jsonOf(set.found));
    }
    return json;
}

} // namespace

std::string measuresJson(const Measures& measures, const std::string& subject) {
    Json json = versionedJson();
    json["subject"] = subject;
    json["points"] = measures.count;
    json["dimensions"] = measures.dims;
    json.update(jsonOf(static_cast<const SetMeasures&>(measures)));
    json["nearest"]["of_largest_minimum"] = jsonOf(packing(measures));
    json["sets"] = setsJson(measures);
    json["summary"] = summaryJson(measures);
    json["spectrum"] = {{"realizations", measures.realizations},
                        {"projections", arrayOf(measures.spectra)}};
    json["independence"] = arrayOf(measures.independence, measures.dims);
    // File names need not be UTF-8.
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

} // namespace wellstrat::cli
