// SPDX-License-Identifier: Apache-2.0

#include "measures.h"

#include "wellstrat/analysis/nets.h"

#include <fmt/format.h>
#include <tbb/parallel_for_each.h>

#include <algorithm>
#include <mutex>
#include <numeric>

namespace wellstrat::cli {
namespace {

constexpr unsigned kPairBins = 48;
constexpr std::size_t kWorstPairs = 5;
/// Steps of the search for the star discrepancy in 3D, which takes some seconds for them, and the
/// least number of sweeps of all points, however many there are.
constexpr std::size_t kStarWork = std::size_t{1} << 21, kMinStarSweeps = 32;
/// Values that the periodograms of all projections may have.
constexpr std::size_t kSpectrumValues = std::size_t{1} << 24;

bool isPowerOfTwo(std::size_t n) { return (n & (n - 1)) == 0; }

/// All projections with `size` coordinates.
std::vector<Projection> projections(unsigned dims, unsigned size) {
    std::vector<Projection> result{{}};
    for (unsigned k = 0; k < size; ++k) {
        std::vector<Projection> longer;
        for (const Projection& shorter : result) {
            for (unsigned d = shorter.empty() ? 0 : shorter.back() + 1; d < dims; ++d) {
                longer.push_back(shorter);
                longer.back().push_back(d);
            }
        }
        result = std::move(longer);
    }
    return result;
}

/// All of them up to the dimensions that nets.h takes, else those in one and two dimensions.
std::vector<Projection> netProjections(unsigned dims) {
    std::vector<Projection> result;
    for (unsigned size = 1; size <= (dims <= PointSet::kMaxDimensions ? dims : 2); ++size) {
        for (Projection& projection : projections(dims, size)) {
            result.push_back(std::move(projection));
        }
    }
    return result;
}

PointSet netPoints(const UnitPoints& points, const Projection& projection) {
    std::vector<double> values;
    for (std::size_t i = 0; i < points.count(); ++i) {
        for (const unsigned d : projection) values.push_back(points.coordinate(d)[i]);
    }
    return PointSet::fromFloats(values.data(), points.count(),
                                static_cast<unsigned>(projection.size()));
}

void measureNet(const UnitPoints& points, NetQuality& net) {
    const PointSet set = netPoints(points, net.projection);
    net.t = tValue(set);
    if (points.dims() <= kMaxFastL2Dimensions || set.count() <= kMaxSquarePoints)
        net.sequenceT = tValueOfSequence(set);
    if (set.dims() <= 3 && set.countLog2() % 2 == 0)
        net.holdsBase4Boxes = checkNet(set, 0, NetBase::four).holds();
}

int maxFrequencyFor(std::size_t count, std::size_t planes) {
    const auto values = [&](int frequency) {
        const auto highest = static_cast<std::size_t>(frequency);
        return planes * (2 * highest + 1) * (highest + 1);
    };
    int frequency = usualMaxFrequency(count);
    while (values(frequency) > kSpectrumValues) frequency /= 2;
    return frequency;
}

void measureSpectrum(const MeasuredSet& set, PlaneSpectrum& spectrum) {
    for (std::size_t r = 0; r < set.realizations; ++r) {
        spectrum.periodogram.add(set.points(r).projection(spectrum.projection));
    }
    spectrum.radial = radialSpectrum(spectrum.periodogram);
    spectrum.peak = highestPeak(spectrum.periodogram);
}

/// What may be done in any order, at once.
struct Task {
    double cost; ///< about the seconds for 2^20 points in 3D, by scripts/bench --analysis
    std::function<void()> run;
};
using Tasks = std::vector<Task>;

constexpr double kNetCost = 0.5, kStarCost = 13, kL2Cost = 14, kDistanceCost = 0.5, kPairCost = 10,
                 kPeriodogramCost = 0.3, kIndependenceCost = 2;

void addNetTasks(const UnitPoints& points, SetMeasures& found, Tasks& tasks) {
    if (!isPowerOfTwo(points.count())) return;
    for (Projection& projection : netProjections(points.dims())) {
        found.nets.push_back({std::move(projection), 0, {}, {}});
    }
    for (NetQuality& net : found.nets)
        tasks.push_back({kNetCost, [&] { measureNet(points, net); }});
}

void addL2Tasks(const UnitPoints& points, SetMeasures& found, Tasks& tasks) {
    if (points.dims() <= kMaxFastL2Dimensions) {
        tasks.push_back({kL2Cost, [&] {
                             std::vector<L2Kind> kinds(kL2Kinds.size());
                             std::transform(kL2Kinds.begin(), kL2Kinds.end(), kinds.begin(),
                                            [](const NamedL2& named) { return named.kind; });
                             const std::vector<double> values = l2Discrepancies(points, kinds);
                             std::copy(values.begin(), values.end(), found.l2.begin());
                         }});
        return;
    }
    if (points.count() > kMaxSquarePoints) return;
    for (std::size_t k = 0; k < kL2Kinds.size(); ++k) {
        tasks.push_back(
            {kL2Cost, [&, k] { found.l2[k] = l2Discrepancy(points, kL2Kinds[k].kind); }});
    }
}

void addStarTask(const UnitPoints& points, SetMeasures& found, Tasks& tasks) {
    if (points.dims() > kMaxStarDimensions) return;
    tasks.push_back({kStarCost, [&] {
                         const std::size_t sweeps =
                             std::max(kStarWork / points.count(), kMinStarSweeps);
                         found.star = starDiscrepancy(points, sweeps);
                     }});
}

void addDistanceTasks(const UnitPoints& points, SetMeasures& found, Tasks& tasks) {
    tasks.push_back(
        {kDistanceCost, [&] { found.onCube = nearestDistances(points, Topology::cube); }});
    tasks.push_back(
        {kDistanceCost, [&] { found.onTorus = nearestDistances(points, Topology::torus); }});
}

void addPairTask(const UnitPoints& points, SetMeasures& found, Tasks& tasks) {
    if (points.dims() > kMaxPairDimensions || points.count() < 2) return;
    tasks.push_back({kPairCost, [&] {
                         const double range = usualPairRange(points.count(), points.dims());
                         found.pairs = pairCorrelation(points, range, kPairBins);
                     }});
}

/// What is measured of each set.
void addSetTasks(const UnitPoints& points, const MeasureChoice& choice, SetMeasures& found,
                 Tasks& tasks) {
    if (choice.star) addStarTask(points, found, tasks);
    if (choice.l2) addL2Tasks(points, found, tasks);
    if (choice.nets) addNetTasks(points, found, tasks);
    if (choice.pairs) addPairTask(points, found, tasks);
    if (choice.distances) addDistanceTasks(points, found, tasks);
}

void addSpectrumTasks(const MeasuredSet& set, Measures& result, Tasks& tasks) {
    const std::vector<Projection> planes = projections(result.dims, 2);
    for (const Projection& plane : planes) {
        result.spectra.push_back(
            {plane, Periodogram(maxFrequencyFor(result.count, planes.size())), {}, {}});
    }
    const double cost = kPeriodogramCost * static_cast<double>(set.realizations);
    for (PlaneSpectrum& spectrum : result.spectra) {
        tasks.push_back({cost, [&] { measureSpectrum(set, spectrum); }});
    }
}

/// One after the other: the streams of a family take the most memory of all.
void addIndependenceTask(const MeasuredSet& set, Measures& result, Tasks& tasks) {
    if (result.count < 3 || set.families.empty()) return;
    tasks.push_back({kIndependenceCost, [&] {
                         const unsigned gridSide = usualGridSide(result.count);
                         for (const StreamFamily& source : set.families) {
                             const std::vector<SampleStream> streams = source.streams();
                             FamilyIndependence family{source.name, {}, gridSide, {}};
                             for (const SampleStream& stream : streams)
                                 family.streams.push_back(stream.name);
                             family.report = testIndependence(streams, gridSide, kWorstPairs);
                             result.independence.push_back(std::move(family));
                         }
                     }});
}

/// A task for each set, one after the other of its measures in it.
void addNamedSetTasks(const MeasuredSet& set, Measures& result, Tasks& tasks) {
    for (const std::string& name : set.names) result.sets.push_back({name, {}});
    for (std::size_t r = 0; r < result.sets.size(); ++r) {
        tasks.push_back({kStarCost + kL2Cost + kPairCost, [&, r] {
                             const UnitPoints points = set.points(r);
                             Tasks ofSet;
                             addSetTasks(points, result.choice, result.sets[r].found, ofSet);
                             for (const Task& task : ofSet) task.run();
                         }});
    }
}

/// Those that take longest first, so that no processor waits for long at the end.
void runAll(Tasks& tasks, const std::function<void(double)>& progress) {
    const auto plus = [](double sum, const Task& task) { return sum + task.cost; };
    const double all = std::accumulate(tasks.begin(), tasks.end(), 0.0, plus);
    std::stable_sort(tasks.begin(), tasks.end(),
                     [](const Task& a, const Task& b) { return a.cost > b.cost; });
    double done = 0;
    std::mutex mutex;
    if (progress) progress(0);
    tbb::parallel_for_each(tasks, [&](const Task& task) {
        task.run();
        const std::lock_guard<std::mutex> lock(mutex);
        done += task.cost;
        if (progress) progress(std::min(done / all, 1.0));
    });
}

} // namespace

std::string projectionName(const Projection& projection, unsigned dims) {
    std::string name;
    for (const unsigned d : projection) {
        if (!name.empty()) name += ", ";
        name += dims <= 3 ? std::string(1, "xyz"[d]) : fmt::format("x{}", d + 1);
    }
    return projection.size() == 1 ? name : "(" + name + ")";
}

Measures measure(const MeasuredSet& set, const MeasureChoice& choice,
                 const std::function<void(double)>& progress) {
    const UnitPoints points = set.points(0);
    Measures result{};
    result.choice = choice;
    result.count = points.count();
    result.realizations = set.realizations;
    result.dims = points.dims();
    Tasks tasks;
    if (set.names.empty()) addSetTasks(points, choice, result, tasks);
    if (choice.spectra) addSpectrumTasks(set, result, tasks);
    addNamedSetTasks(set, result, tasks);
    if (choice.independence) addIndependenceTask(set, result, tasks);
    runAll(tasks, progress);
    if (!result.sets.empty()) static_cast<SetMeasures&>(result) = result.sets.front().found;
    return result;
}

} // namespace wellstrat::cli
