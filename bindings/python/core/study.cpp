// SPDX-License-Identifier: Apache-2.0

#include "study.h"

#include "wellstrat/blue.h"
#include "wellstrat/long.h"
#include "wellstrat/random_generator.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace python {
namespace {

using namespace wellstrat;

struct NamedSource {
    const char* name;
    PointSourcePtr source;
};

const std::vector<NamedSource>& sources() {
    static const LongProgressive longSamples;
    static const BlueProgressive blue;
    static const RandomGenerator random;
    static const std::vector<NamedSource> all = [] {
        std::vector<NamedSource> list;
        list.push_back({"pmj", generatorSource(nullptr)});
        list.push_back({"joint", jointSource()});
        list.push_back({"long", generatorSource(&longSamples)});
        list.push_back({"long-words", sequenceSource()});
        list.push_back({"blue", generatorSource(&blue)});
        list.push_back({"random", generatorSource(&random)});
        list.push_back({"sobol", sobolSource(SobolRandomization::none)});
        list.push_back({"sobol-shift", sobolSource(SobolRandomization::digitalShift)});
        list.push_back({"sobol-owen", sobolSource(SobolRandomization::owen)});
        list.push_back({"halton", haltonSource()});
        list.push_back({"jitter", jitteredSource()});
        return list;
    }();
    return all;
}

/// The points of one pattern, which others own.
class GivenPoints final : public PointSource {
public:
    explicit GivenPoints(const double* points) : points_(points) {}

    void draw(uint32_t /*pattern*/, const DomainDims& domains, std::size_t count,
              double* points) const override {
        std::copy(points_, points_ + count * totalDims(domains), points);
    }

private:
    const double* points_;
};

} // namespace

std::vector<std::string> sourceNames() {
    std::vector<std::string> names;
    for (const NamedSource& known : sources()) names.emplace_back(known.name);
    return names;
}

Study::Study(const std::vector<std::string>& integrands, std::vector<uint32_t> counts)
    : counts_(std::move(counts)) {
    for (const std::string& name : integrands) integrands_.push_back(makeIntegrand(name));
    if (integrands_.empty()) throw std::invalid_argument("there are no integrands");
    if (counts_.empty()) throw std::invalid_argument("there are no numbers of points");
    sums_.resize(integrands_.size() * counts_.size());
    addErrors(*sources().front().source, pointers(), counts_, {0, 0}, sums_.data()); // checks them
}

std::vector<const Integrand*> Study::pointers() const {
    std::vector<const Integrand*> all;
    for (const Integrand& integrand : integrands_) all.push_back(&integrand);
    return all;
}

void Study::addPatterns(const std::string& source, uint64_t begin, uint64_t end) {
    const auto named = std::find_if(sources().begin(), sources().end(),
                                    [&](const NamedSource& known) { return known.name == source; });
    if (named == sources().end()) throw std::invalid_argument("no generator is called " + source);
    named->source->check(integrands_.front().domains, counts_.back(), end);
    addErrors(*named->source, pointers(), counts_, {begin, end}, sums_.data());
    patterns_ += end - begin;
}

void Study::addPoints(const double* points, std::size_t first, std::size_t last) {
    const auto counts = counts_.begin();
    const std::vector<uint32_t> some(counts + static_cast<std::ptrdiff_t>(first),
                                     counts + static_cast<std::ptrdiff_t>(last));
    std::vector<ErrorSums> sums(integrands_.size() * some.size());
    addErrors(GivenPoints(points), pointers(), some, {0, 1}, sums.data());
    for (std::size_t i = 0; i < sums.size(); ++i) {
        sums_[i / some.size() * counts_.size() + first + i % some.size()] += sums[i];
    }
    patterns_ += last == counts_.size() ? 1 : 0;
}

std::vector<std::vector<ErrorEstimate>> Study::estimates() const {
    std::vector<std::vector<ErrorEstimate>> all(integrands_.size());
    for (std::size_t i = 0; i < sums_.size(); ++i) {
        all[i / counts_.size()].push_back(estimateError(sums_[i], patterns_));
    }
    return all;
}

std::vector<SlopeFit> Study::slopes(uint32_t firstCount) const {
    std::vector<SlopeFit> all;
    for (const std::vector<ErrorEstimate>& errors : estimates()) {
        std::vector<double> rmse(errors.size());
        std::transform(errors.begin(), errors.end(), rmse.begin(),
                       [](const ErrorEstimate& error) { return error.rmse; });
        all.push_back(fitSlope(counts_, rmse, firstCount));
    }
    return all;
}

} // namespace python
