// SPDX-License-Identifier: Apache-2.0
//
// The compiled part of wellstrat.analysis. It is a module of its own, so that only those who
// measure points need FFTW. Arrays are contiguous and of the right size: analysis.py checks before.

#include "buffer.h"
#include "errors.h"
#include "interruptible.h"
#include "study.h"

#include "wellstrat/analysis/discrepancy.h"
#include "wellstrat/analysis/geometry.h"
#include "wellstrat/analysis/image_spectrum.h"
#include "wellstrat/analysis/independence.h"
#include "wellstrat/analysis/nets.h"
#include "wellstrat/analysis/spectrum.h"

#include <pybind11/stl.h>

#include <memory>
#include <tuple>

namespace py = pybind11;

namespace python {
namespace {

using namespace wellstrat;

/// Copies of all points of an array of (count, dims) values in double.
UnitPoints unitPoints(const py::object& array, unsigned dims) {
    const Buffer<const double> values(array);
    const Unlocked unlocked;
    return {values.data(), values.size() / dims, dims};
}

PointSet pointSet(const py::object& array, unsigned dims) {
    const Buffer<const double> values(array);
    const Unlocked unlocked;
    return PointSet::fromFloats(values.data(), values.size() / dims, dims);
}

unsigned netQuality(const py::object& array, unsigned dims, bool isSequence) {
    return computeInterruptibly([isSequence, points = pointSet(array, dims)] {
        return isSequence ? tValueOfSequence(points) : tValue(points);
    });
}

std::vector<double> discrepancies(const py::object& array, unsigned dims,
                                  const std::vector<L2Kind>& kinds) {
    return computeInterruptibly(
        [kinds, points = unitPoints(array, dims)] { return l2Discrepancies(points, kinds); });
}

std::pair<double, double> starBounds(const py::object& array, unsigned dims, std::size_t sweeps) {
    const StarBounds bounds = computeInterruptibly(
        [sweeps, points = unitPoints(array, dims)] { return starDiscrepancy(points, sweeps); });
    return {bounds.lower, bounds.upper};
}

std::pair<double, double> nearest(const py::object& array, unsigned dims, Topology topology) {
    const NearestDistances distances =
        computeInterruptibly([topology, points = unitPoints(array, dims)] {
            return nearestDistances(points, topology);
        });
    return {distances.minimum, distances.mean};
}

std::vector<double> pairs(const py::object& array, unsigned dims, double range, unsigned bins) {
    return computeInterruptibly([range, bins, points = unitPoints(array, dims)] {
        return pairCorrelation(points, range, bins).values;
    });
}

/// Adds points to a shared periodogram, which is lost after Ctrl-C.
void addToPeriodogram(const std::shared_ptr<Periodogram>& periodogram, const py::object& array,
                      unsigned dims) {
    computeInterruptibly(
        [periodogram, points = unitPoints(array, dims)] { periodogram->add(points); });
}

/// power[(fy + most) * (2 most + 1) + fx + most]
void copyPower(const Periodogram& periodogram, const py::object& out) {
    const Buffer<double> power(out);
    const int most = periodogram.maxFrequency();
    const int side = 2 * most + 1;
    power.expect(static_cast<std::size_t>(side) * static_cast<std::size_t>(side));
    double* next = power.data();
    for (int fy = -most; fy <= most; ++fy) {
        for (int fx = -most; fx <= most; ++fx) *next++ = periodogram.power(fx, fy);
    }
}

std::tuple<int, int, double> peak(const Periodogram& periodogram) {
    const SpectralPeak highest = highestPeak(periodogram);
    return {highest.fx, highest.fy, highest.power};
}

std::pair<std::vector<double>, std::vector<double>> radial(const Periodogram& periodogram) {
    RadialSpectrum spectrum = radialSpectrum(periodogram);
    return {std::move(spectrum.mean), std::move(spectrum.anisotropyDb)};
}

/// The mean frequencies and powers of rings.
std::pair<std::vector<double>, std::vector<double>>
pictureSpectrum(const py::object& pictures, std::size_t width, std::size_t height) {
    const Buffer<const double> values(pictures);
    const std::vector<double> pixels(values.data(), values.data() + values.size());
    const std::vector<RingPower> rings = computeInterruptibly([=] {
        ImagePeriodogram periodogram(width, height);
        const std::size_t size = width * height;
        for (std::size_t begin = 0; begin + size <= pixels.size(); begin += size) {
            const auto first = pixels.begin() + static_cast<std::ptrdiff_t>(begin);
            periodogram.add({first, first + static_cast<std::ptrdiff_t>(size)});
        }
        return radialPower(periodogram);
    });
    std::pair<std::vector<double>, std::vector<double>> columns;
    for (const RingPower& ring : rings) {
        columns.first.push_back(ring.frequency);
        columns.second.push_back(ring.power);
    }
    return columns;
}

py::dict independence(const std::vector<py::object>& arrays, const std::vector<unsigned>& dims,
                      unsigned gridSide, std::size_t worst) {
    std::vector<SampleStream> streams;
    for (std::size_t i = 0; i < arrays.size(); ++i) {
        streams.push_back({std::to_string(i), unitPoints(arrays[i], dims.at(i))});
    }
    const IndependenceReport report =
        computeInterruptibly([gridSide, worst, streams = std::move(streams)] {
            return testIndependence(streams, gridSide, worst);
        });
    py::list pairs;
    for (const CoordinatePair& pair : report.worst) {
        using namespace py::literals;
        pairs.append(py::dict("streams"_a = py::make_tuple(pair.first, pair.second),
                              "coordinates"_a = py::make_tuple(pair.firstDim, pair.secondDim),
                              "correlation"_a = pair.correlation, "chi_square"_a = pair.chiSquare,
                              "probability"_a = pair.probability()));
    }
    py::dict result;
    result["pairs"] = report.pairs;
    result["probability"] = report.probability();
    result["correlation_spread"] = report.correlationSpread;
    result["mean_chi_square"] = report.meanChiSquare;
    result["worst"] = pairs;
    return result;
}

void addPatterns(Study& study, const std::string& source, uint64_t begin, uint64_t end) {
    const Unlocked unlocked;
    study.addPatterns(source, begin, end);
}

void addPoints(Study& study, const py::object& array, std::size_t first, std::size_t last) {
    const Buffer<const double> points(array);
    const Unlocked unlocked;
    study.addPoints(points.data(), first, last);
}

/// Of an integrand: RMSE, its band and the bias by number of points, and the slope.
using Errors = std::tuple<std::vector<double>, std::vector<double>, std::vector<double>,
                          std::vector<double>, double>;

std::vector<Errors> results(const Study& study, uint32_t firstCount) {
    std::vector<Errors> all;
    const std::vector<SlopeFit> slopes = study.slopes(firstCount);
    for (const std::vector<ErrorEstimate>& errors : study.estimates()) {
        std::vector<double> rmse, low, high, bias;
        for (const ErrorEstimate& error : errors) {
            rmse.push_back(error.rmse);
            low.push_back(error.low);
            high.push_back(error.high);
            bias.push_back(error.bias);
        }
        all.emplace_back(rmse, low, high, bias, slopes[all.size()].slope);
    }
    return all;
}

/// Name, dimensions of the domains, formula.
std::vector<std::tuple<std::string, DomainDims, std::string>> families() {
    std::vector<std::tuple<std::string, DomainDims, std::string>> all;
    for (const IntegrandFamily& family : integrandFamilies()) {
        all.emplace_back(family.name, family.domains, family.formula);
    }
    return all;
}

} // namespace
} // namespace python

PYBIND11_MODULE(_analysis, m) {
    using namespace python;
    using namespace wellstrat;

    py::enum_<L2Kind>(m, "L2Kind")
        .value("star", L2Kind::star)
        .value("centered", L2Kind::centered)
        .value("wrap_around", L2Kind::wrapAround)
        .value("mixture", L2Kind::mixture)
        .value("modified", L2Kind::modified);
    py::enum_<Topology>(m, "Topology")
        .value("cube", Topology::cube)
        .value("torus", Topology::torus);
    m.attr("max_net_dims") = PointSet::kMaxDimensions;
    m.attr("max_dims") = UnitPoints::kMaxDimensions;
    m.attr("max_frequency") = Periodogram::kMaxFrequency;

    m.def("t_value", netQuality);
    m.def("l2_discrepancies", discrepancies);
    m.def("star_discrepancy", starBounds);
    m.def("nearest_distances", nearest);
    m.def("largest_minimum_distance", largestMinimumDistance);
    m.def("pair_correlation", pairs);
    m.def("usual_pair_range", usualPairRange);
    m.def("usual_max_frequency", usualMaxFrequency);
    m.def("picture_spectrum", pictureSpectrum);
    m.def("independence", independence);
    m.def("usual_grid_side", usualGridSide);
    m.def("families", families);
    m.def("domains", [](const std::string& name) { return makeIntegrand(name).domains; });
    m.def("source_names", sourceNames);

    py::class_<Periodogram, std::shared_ptr<Periodogram>>(m, "Periodogram")
        .def(py::init<int>())
        .def("add", addToPeriodogram)
        .def("copy_power", copyPower)
        .def("peak", peak)
        .def("radial", radial);
    py::class_<Study>(m, "Study")
        .def(py::init<const std::vector<std::string>&, std::vector<uint32_t>>())
        .def_property_readonly("dims", &Study::dims)
        .def("add_patterns", addPatterns)
        .def("add_points", addPoints)
        .def("results", results);

    nameWhatIsMissing();
    watchForExit();
}
