// SPDX-License-Identifier: Apache-2.0
//
// What passes samples on and records them. The judge is in domain_faults.cpp.

#include "wellstrat/domain_linter.h"

#include "debug/domain_faults.h"
#include "debug/draw_record.h"
#include "wellstrat/batch.h"
#include "wellstrat/lookup.h"

#include <cstdio>
#include <map>
#include <mutex>
#include <tuple>

namespace wellstrat {
inline namespace stream1 {

namespace {

/// Draws as a RixRNG does that has no generator.
class TableGenerator final : public Generator {
public:
    float Sample1D(const SampleCtx& sc, unsigned /*i*/) const override {
        return sample1D(sc.patternid, sc.sampleid);
    }
    Float2 Sample2D(const SampleCtx& sc, unsigned /*i*/) const override {
        return sample2D(sc.patternid, sc.sampleid);
    }
    Float3 Sample3D(const SampleCtx& sc, unsigned /*i*/) const override {
        return sample3D(sc.patternid, sc.sampleid);
    }
    void MultiSample1D(unsigned n, const SampleCtx& sc, float* xis) const override {
        drawSamples1D(n, &sc, xis);
    }
    void MultiSample2D(unsigned n, const SampleCtx& sc, Float2* xis) const override {
        drawSamples2D(n, &sc, xis);
    }
    void MultiSample3D(unsigned n, const SampleCtx& sc, Float3* xis) const override {
        drawSamples3D(n, &sc, xis);
    }
};

/// Never destroyed: something may still draw while the program ends.
const Generator& tableGenerator() {
    static const Generator* const generator = new TableGenerator;
    return *generator;
}

/// Marks the tags that a linter gives, so that others', and none, are a camera's.
constexpr uint32_t kOwnTag = 0x80000000u;

} // namespace

class DomainLinter::State {
public:
    explicit State(const Generator* wrapped) : inner(wrapped ? *wrapped : tableGenerator()) {}

    const Generator& inner;

    /// The wrapped generator's order for one of the linter's.
    Order innerOrder(Order order) {
        const std::lock_guard<std::mutex> lock(mutex_);
        return domainOf(order).order;
    }

    Order child(Order parent, Scramble scramble, unsigned split) {
        const std::lock_guard<std::mutex> lock(mutex_);
        const Domain from = domainOf(parent);
        return tagged(derivations_.child(*from.derivation, scramble, split),
                      inner.ChildOrder(from.order, scramble, split));
    }

    Order view(Order parent) {
        const std::lock_guard<std::mutex> lock(mutex_);
        const Domain from = domainOf(parent);
        return tagged(derivations_.view(*from.derivation), inner.ViewOrder(from.order));
    }

    /// Records draws by a domain. Returns the wrapped generator's order.
    Order add(Order order, unsigned n, const SampleCtx& first, detail::DrawCounts counts) {
        const std::lock_guard<std::mutex> lock(mutex_);
        const Domain domain = domainOf(order);
        for (unsigned i = 0; i < n; ++i) record_.add(*domain.derivation, (&first)[i], counts);
        return domain.order;
    }

    std::vector<Finding> findings() {
        const std::lock_guard<std::mutex> lock(mutex_);
        return detail::findFaults(derivations_, record_, inner);
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
    /// What a tag means. A view of a domain is the same derivation, but for slots, and may have
    /// another order.
    struct Domain {
        const detail::Derivation* derivation;
        Order order;
    };

    /// An order without a tag of ours is a camera's, or was set by the user.
    Domain domainOf(Order order) const {
        const uint32_t number = order.tag ^ kOwnTag;
        return number < domains_.size() ? domains_[number] : Domain{&derivations_.camera(), order};
    }

    Order tagged(const detail::Derivation& derivation, Order order) {
        const auto [found, isNew] = tags_.try_emplace(
            {derivation.number, order.slot, order.splits, order.tag}, domains_.size());
        if (isNew) domains_.push_back({&derivation, order});
        order.tag = kOwnTag | static_cast<uint32_t>(found->second);
        return order;
    }

    std::mutex mutex_;
    detail::Derivations derivations_;
    detail::DrawRecord record_;
    std::vector<Domain> domains_;
    std::map<std::tuple<std::size_t, uint16_t, uint16_t, uint32_t>, std::size_t> tags_;
};

DomainLinter::DomainLinter(const Generator* inner) : state_(std::make_unique<State>(inner)) {}

DomainLinter::~DomainLinter() = default;

float DomainLinter::OrderedSample1D(const SampleCtx& sc, unsigned i, Order order) const {
    return state_->inner.OrderedSample1D(sc, i, state_->add(order, 1, sc, {0, 1}));
}
Float2 DomainLinter::OrderedSample2D(const SampleCtx& sc, unsigned i, Order order) const {
    return state_->inner.OrderedSample2D(sc, i, state_->add(order, 1, sc, {1, 0}));
}
Float3 DomainLinter::OrderedSample3D(const SampleCtx& sc, unsigned i, Order order) const {
    return state_->inner.OrderedSample3D(sc, i, state_->add(order, 1, sc, {1, 1}));
}
void DomainLinter::MultiOrderedSample1D(unsigned n, const SampleCtx& sc, Order order,
                                        float* xis) const {
    state_->inner.MultiOrderedSample1D(n, sc, state_->add(order, n, sc, {0, 1}), xis);
}
void DomainLinter::MultiOrderedSample2D(unsigned n, const SampleCtx& sc, Order order,
                                        Float2* xis) const {
    state_->inner.MultiOrderedSample2D(n, sc, state_->add(order, n, sc, {1, 0}), xis);
}
void DomainLinter::MultiOrderedSample3D(unsigned n, const SampleCtx& sc, Order order,
                                        Float3* xis) const {
    state_->inner.MultiOrderedSample3D(n, sc, state_->add(order, n, sc, {1, 1}), xis);
}

SampleCtx DomainLinter::CameraContext(int x, int y, unsigned seed, unsigned sampleid) const {
    return state_->inner.CameraContext(x, y, seed, sampleid);
}
unsigned DomainLinter::ParentPattern(unsigned patternid, Scramble scramble) const {
    return state_->inner.ParentPattern(patternid, scramble);
}
unsigned DomainLinter::PlaceBits() const { return state_->inner.PlaceBits(); }

Order DomainLinter::ChildOrder(Order parent, Scramble scramble, unsigned split) const {
    return state_->child(parent, scramble, split);
}
Order DomainLinter::ViewOrder(Order parent) const { return state_->view(parent); }

void DomainLinter::MultiNewDomainSplit(unsigned n, const SampleCtx& parents, Order order,
                                       Scramble scramble, unsigned newnumsamples,
                                       SampleCtx* children) const {
    state_->inner.MultiNewDomainSplit(n, parents, state_->innerOrder(order), scramble,
                                      newnumsamples, children);
}
void DomainLinter::MultiNewDomainDistrib(unsigned n, const SampleCtx& parents, Order order,
                                         Scramble scramble, unsigned newsampleid,
                                         SampleCtx* children) const {
    state_->inner.MultiNewDomainDistrib(n, parents, state_->innerOrder(order), scramble,
                                        newsampleid, children);
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
