// SPDX-License-Identifier: Apache-2.0
//
// The compiled part of the Python package: loops over contiguous arrays. The package around it
// (bindings/python/src/wellstrat) checks arguments, makes arrays and documents.

#include "buffer.h"
#include "draw.h"
#include "errors.h"
#include "gil.h"
#include "map.h"

#include "RixShadingUtils.h"
#include "wellstrat/batch.h"
#include "wellstrat/batch_target.h"
#include "wellstrat/blue_domain.h"
#include "wellstrat/camera.h"
#include "wellstrat/tables.h"
#include "wellstrat/version.h"

#include <pybind11/pybind11.h>

namespace py = pybind11;

namespace python {
namespace {

using wellstrat::SampleCtx;
using wellstrat::Scramble;

/// A drawing of `dims` coordinates, whose tables are there. They are built with the lock held, so
/// that no other thread forks meanwhile.
Drawing makeDrawing(Generator generator, unsigned dims, unsigned slot, unsigned splits,
                    double offset) {
    if (generator == Generator::pmj) wellstrat::tables();
    return {generator, dims, wellstrat::jointOrder(slot, splits), offset};
}

template <typename Real>
void drawContexts(const py::object& contexts, Generator generator, unsigned dims, unsigned slot,
                  unsigned splits, const py::object& out) {
    const Buffer<const SampleCtx> in(contexts);
    const Buffer<Real> xis(out);
    xis.expect(in.size() * dims);
    const Drawing drawing = makeDrawing(generator, dims, slot, splits, 0.0);
    computeUnlocked(in.size(), [&](std::size_t begin, std::size_t end) {
        draw(end - begin, in.data() + begin, drawing, xis.data() + begin * dims);
    });
}

template <typename Real>
void drawPatterns(const py::object& patterns, std::size_t count, uint32_t first,
                  Generator generator, unsigned dims, unsigned slot, double offset,
                  const py::object& out) {
    const Buffer<const uint32_t> ids(patterns);
    const Buffer<Real> xis(out);
    xis.expect(ids.size() * count * dims);
    const Drawing drawing = makeDrawing(generator, dims, slot, 1, offset);
    const Runs runs{ids.data(), count, first};
    computeUnlocked(ids.size() * count, [&](std::size_t begin, std::size_t end) {
        drawRuns(runs, begin, end, drawing, xis.data() + begin * dims);
    });
}

/// contexts[row * width + column] = context(x + column, y + row)
template <typename Context>
void fillPixels(unsigned width, unsigned height, const py::object& out, Context context) {
    const Buffer<SampleCtx> contexts(out);
    contexts.expect(std::size_t{width} * height);
    computeUnlocked(contexts.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            contexts.data()[i] = context(static_cast<int>(i % width), static_cast<int>(i / width));
        }
    });
}

void cameraContexts(unsigned width, unsigned height, int x, int y, unsigned frame,
                    unsigned sampleid, unsigned seed, const py::object& out) {
    fillPixels(width, height, out, [=](int column, int row) {
        return wellstrat::cameraContext(x + column, y + row, frame, sampleid, seed);
    });
}

void blueContexts(unsigned width, unsigned height, int x, int y, unsigned seed, unsigned sampleid,
                  const py::object& out) {
    fillPixels(width, height, out, [=](int column, int row) {
        return wellstrat::blueContext(x + column, y + row, seed, sampleid);
    });
}

using Derive = void (*)(std::size_t, wellstrat::ArrayArgument<const SampleCtx>, Scramble, unsigned,
                        wellstrat::ArrayArgument<SampleCtx>);

template <Derive kTables, Derive kBlue>
void deriveDomains(const py::object& parents, unsigned scramble, unsigned number, bool isBlue,
                   const py::object& out) {
    const Buffer<const SampleCtx> in(parents);
    const Buffer<SampleCtx> children(out);
    children.expect(in.size());
    const Derive derive = isBlue ? kBlue : kTables;
    computeUnlocked(in.size(), [&](std::size_t begin, std::size_t end) {
        derive(end - begin, in.data() + begin, static_cast<Scramble>(scramble), number,
               children.data() + begin);
    });
}

void hashToRandom(const py::object& contexts, const py::object& out) {
    const Buffer<const SampleCtx> in(contexts);
    const Buffer<float> xis(out);
    xis.expect(in.size());
    computeUnlocked(in.size(), [&](std::size_t begin, std::size_t end) {
        wellstrat::hashToRandom(end - begin, in.data() + begin, xis.data() + begin);
    });
}

/// xis[i] is remapped in place; indices[i] is what its row of weights chose, with probability
/// probabilities[i]. One row for all, or one for each.
void chooseAndRemap(const py::object& samples, const py::object& weights, unsigned choices,
                    const py::object& indices, const py::object& probabilities) {
    const Buffer<float> xis(samples);
    const Buffer<const float> rows(weights);
    const Buffer<int64_t> chosen(indices);
    const Buffer<float> probability(probabilities);
    const std::size_t stride = rows.size() == choices ? 0 : choices;
    rows.expect(stride == 0 ? choices : choices * xis.size());
    chosen.expect(xis.size());
    probability.expect(xis.size());
    computeUnlocked(xis.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            chosen.data()[i] = RixChooseAndRemap(xis.data()[i], rows.data() + i * stride, choices,
                                                 probability.data() + i);
        }
    });
}

void applyMap(const char* name, const py::object& in, const py::object& out) {
    const Map* const map = findMap(name);
    if (map == nullptr) throw std::invalid_argument("no map of this name");
    const Buffer<const float> rows(in);
    const Buffer<float> results(out);
    const std::size_t n = rows.size() / map->inputs;
    rows.expect(n * map->inputs);
    results.expect(n * map->outputs);
    computeUnlocked(n, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            map->apply(rows.data() + i * map->inputs, results.data() + i * map->outputs);
        }
    });
}

unsigned jointScramble(unsigned slot) {
    return static_cast<unsigned>(wellstrat::jointScramble(slot));
}

} // namespace
} // namespace python

PYBIND11_MODULE(_core, m) {
    using namespace python;

    m.attr("version") = WELLSTRAT_VERSION_STRING;
    m.attr("stream_version") = wellstrat::kStreamVersion;
    m.attr("slots") = wellstrat::kJointSlots;
    m.attr("max_splits") = wellstrat::kMaxJointSplit;
    py::enum_<Generator>(m, "Generator")
        .value("pmj", Generator::pmj)
        .value("long", Generator::longSequence)
        .value("blue", Generator::blue)
        .value("random", Generator::random);

    m.def("batch_target", wellstrat::chosenBatchTarget);
    m.def("draw_float32", drawContexts<float>);
    m.def("draw_float64", drawContexts<double>);
    m.def("samples_float32", drawPatterns<float>);
    m.def("samples_float64", drawPatterns<double>);
    m.def("camera_contexts", cameraContexts);
    m.def("blue_contexts", blueContexts);
    m.def("new_domain_split",
          deriveDomains<wellstrat::newDomainsSplit, wellstrat::newBlueDomainsSplit>);
    m.def("new_domain_distrib",
          deriveDomains<wellstrat::newDomainsDistrib, wellstrat::newBlueDomainsDistrib>);
    m.def("hash_to_random", hashToRandom);
    m.def("choose_and_remap", chooseAndRemap);
    m.def("apply_map", applyMap);
    m.def("joint_scramble", jointScramble);

    nameWhatIsMissing();
    watchForExit();
}
