// SPDX-License-Identifier: Apache-2.0
//
// What passes samples on and records them. The judge is in domain_faults.cpp.

#include "wellstrat/domain_linter.h"

#include "debug/domain_faults.h"
#include "debug/draw_record.h"
#include "wellstrat/batch.h"
#include "wellstrat/lookup.h"

#include <cstdio>
#include <mutex>

namespace wellstrat {
inline namespace stream1 {

/// The generator of one domain: its derivation, and what makes its samples.
class DomainLinter::Domain final : public Generator {
public:
    Domain(State& state, const detail::Derivation& derivation, const Generator* inner)
        : state_(state), derivation_(derivation), inner_(inner) {}

    float Sample1D(const SampleCtx& sc, unsigned i) const override {
        record(1, sc, {0, 1});
        return inner_ ? inner_->Sample1D(sc, i) : sample1D(sc.patternid, sc.sampleid);
    }
    Float2 Sample2D(const SampleCtx& sc, unsigned i) const override {
        record(1, sc, {1, 0});
        return inner_ ? inner_->Sample2D(sc, i) : sample2D(sc.patternid, sc.sampleid);
    }
    Float3 Sample3D(const SampleCtx& sc, unsigned i) const override {
        record(1, sc, {1, 1});
        return inner_ ? inner_->Sample3D(sc, i) : sample3D(sc.patternid, sc.sampleid);
    }
    void MultiSample1D(unsigned n, const SampleCtx& sc, float* xis) const override {
        record(n, sc, {0, 1});
        inner_ ? inner_->MultiSample1D(n, sc, xis) : drawSamples1D(n, &sc, xis);
    }
    void MultiSample2D(unsigned n, const SampleCtx& sc, Float2* xis) const override {
        record(n, sc, {1, 0});
        inner_ ? inner_->MultiSample2D(n, sc, xis) : drawSamples2D(n, &sc, xis);
    }
    void MultiSample3D(unsigned n, const SampleCtx& sc, Float3* xis) const override {
        record(n, sc, {1, 1});
        inner_ ? inner_->MultiSample3D(n, sc, xis) : drawSamples3D(n, &sc, xis);
    }
    const Generator* ForChild(Scramble scramble, unsigned split) const override;

private:
    void record(unsigned n, const SampleCtx& first, detail::DrawCounts counts) const;

    State& state_;
    const detail::Derivation& derivation_;
    const Generator* const inner_;
};

class DomainLinter::State {
public:
    explicit State(const Generator* inner) : camera(domain(derivations_.camera(), inner)) {}

    const Domain& child(const detail::Derivation& parent, Scramble scramble, unsigned split,
                        const Generator* inner) {
        const std::lock_guard<std::mutex> lock(mutex_);
        return domain(derivations_.child(parent, scramble, split), inner);
    }

    void add(const detail::Derivation& domain, unsigned n, const SampleCtx* contexts,
             detail::DrawCounts counts) {
        const std::lock_guard<std::mutex> lock(mutex_);
        for (unsigned i = 0; i < n; ++i) record_.add(domain, contexts[i], counts);
    }

    std::vector<Finding> findings() {
        const std::lock_guard<std::mutex> lock(mutex_);
        return detail::findFaults(derivations_, record_);
    }

    std::string summary() {
        const std::lock_guard<std::mutex> lock(mutex_);
        return std::to_string(record_.draws()) + " draws of " + std::to_string(record_.domains()) +
               " domains";
    }

    void clear() {
        const std::lock_guard<std::mutex> lock(mutex_);
        record_ = {};
    }

private:
    /// One object for each derivation, and, should the inner generator have several for one, for
    /// each of these.
    const Domain& domain(const detail::Derivation& derivation, const Generator* inner) {
        std::unique_ptr<Domain>& domain = domains_[{&derivation, inner}];
        if (!domain) domain = std::make_unique<Domain>(*this, derivation, inner);
        return *domain;
    }

    std::mutex mutex_;
    detail::Derivations derivations_;
    detail::DrawRecord record_;
    std::map<std::pair<const detail::Derivation*, const Generator*>, std::unique_ptr<Domain>>
        domains_;

public:
    const Domain& camera;
};

const Generator* DomainLinter::Domain::ForChild(Scramble scramble, unsigned split) const {
    const Generator* const inner = inner_ ? inner_->ForChild(scramble, split) : nullptr;
    return &state_.child(derivation_, scramble, split, inner);
}

void DomainLinter::Domain::record(unsigned n, const SampleCtx& first,
                                  detail::DrawCounts counts) const {
    state_.add(derivation_, n, &first, counts);
}

DomainLinter::DomainLinter(const Generator* inner) : state_(std::make_unique<State>(inner)) {}

DomainLinter::~DomainLinter() = default;

float DomainLinter::Sample1D(const SampleCtx& sc, unsigned i) const {
    return state_->camera.Sample1D(sc, i);
}
Float2 DomainLinter::Sample2D(const SampleCtx& sc, unsigned i) const {
    return state_->camera.Sample2D(sc, i);
}
Float3 DomainLinter::Sample3D(const SampleCtx& sc, unsigned i) const {
    return state_->camera.Sample3D(sc, i);
}
void DomainLinter::MultiSample1D(unsigned n, const SampleCtx& sc, float* xis) const {
    state_->camera.MultiSample1D(n, sc, xis);
}
void DomainLinter::MultiSample2D(unsigned n, const SampleCtx& sc, Float2* xis) const {
    state_->camera.MultiSample2D(n, sc, xis);
}
void DomainLinter::MultiSample3D(unsigned n, const SampleCtx& sc, Float3* xis) const {
    state_->camera.MultiSample3D(n, sc, xis);
}
const Generator* DomainLinter::ForChild(Scramble scramble, unsigned split) const {
    return state_->camera.ForChild(scramble, split);
}

std::vector<DomainLinter::Finding> DomainLinter::findings() const { return state_->findings(); }

std::string DomainLinter::report() const {
    const std::vector<Finding> all = findings();
    if (all.empty()) return "no faults in " + state_->summary() + "\n";
    std::string lines;
    for (const Finding& finding : all) {
        char place[64];
        std::snprintf(place, sizeof place, " times, as at pattern 0x%08x, sampleid %u)\n",
                      finding.path.patternid, finding.path.sampleid);
        lines += finding.message + " (" + std::to_string(finding.count) + place;
    }
    return lines;
}

void DomainLinter::clear() { state_->clear(); }

} // namespace stream1
} // namespace wellstrat
