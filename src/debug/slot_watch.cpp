// SPDX-License-Identifier: Apache-2.0

#include "debug/slot_watch.h"

#ifndef NDEBUG

#include "debug/derivation.h"

#include <cstdio>
#include <cstdlib>
#include <memory>
#include <mutex>
#include <unordered_map>
#include <vector>

namespace wellstrat::stream1::detail {

namespace {

/// Which domains took the slots of one path. A domain is known by its pattern, as it may be split
/// in one picture and not in another.
struct SlottedPath {
    SampleCtx start;
    struct {
        unsigned patternid;
        const Derivation* domain; ///< null: not taken
    } slots[kJointSlots];
};

/// What one camera's generator and its children are used for.
class Camera {
public:
    Derivations derivations;

    const JointProgressive*& child(const Derivation& derivation) {
        return children_[derivation.number];
    }

    void draw(const Derivation& domain, unsigned slot, SampleCtx context) {
        const SampleCtx start = pathOf(domain, context).start;
        if (paths_.empty()) paths_.resize(kPaths);
        SlottedPath& path = paths_[hashPair(start.patternid, start.sampleid) % kPaths];
        if (path.start.patternid != start.patternid || path.start.sampleid != start.sampleid) {
            path = {start, {}};
        }
        auto& taken = path.slots[slot];
        if (taken.domain && taken.patternid != context.patternid) {
            std::fprintf(stderr, "wellstrat: slot %u is drawn twice on a path: by %s and by %s\n",
                         slot, nameOf(*taken.domain).c_str(), nameOf(domain).c_str());
            std::abort();
        }
        taken = {context.patternid, &domain};
    }

    void forgetPaths() { paths_ = {}; }

private:
    /// Some threads' batches of paths.
    static constexpr std::size_t kPaths = 4096;

    std::unordered_map<std::size_t, const JointProgressive*> children_;
    std::vector<SlottedPath> paths_;
};

/// All cameras of the process.
class Watch {
public:
    static Watch& get() {
        static Watch* const watch = new Watch; // never freed, as the generators it makes
        return *watch;
    }

    const JointProgressive* child(const JointProgressive& parent, const JointProgressive* unwatched,
                                  Scramble scramble, unsigned split) {
        const std::lock_guard<std::mutex> lock(mutex_);
        const Domain from = domainOf(parent);
        const Derivation& derivation =
            from.camera->derivations.child(*from.derivation, scramble, split);
        const JointProgressive*& made = from.camera->child(derivation);
        if (!made) {
            made = new JointProgressive(*unwatched);
            domains_[made] = {from.camera, &derivation};
        }
        return made;
    }

    void draw(const JointProgressive& generator, unsigned n, const SampleCtx* contexts) {
        const std::lock_guard<std::mutex> lock(mutex_);
        const auto found = domains_.find(&generator);
        if (found == domains_.end()) return; // a copy of a child
        const Domain domain = found->second;
        for (unsigned i = 0; i < n; ++i) {
            domain.camera->draw(*domain.derivation, generator.slot(), contexts[i]);
        }
    }

    void end(const JointProgressive& generator) {
        const std::lock_guard<std::mutex> lock(mutex_);
        const auto found = domains_.find(&generator);
        if (found == domains_.end()) return;
        found->second.camera->forgetPaths();
        domains_.erase(found);
    }

private:
    struct Domain {
        Camera* camera;
        const Derivation* derivation;
    };

    /// What is no child is a camera's.
    Domain domainOf(const JointProgressive& generator) {
        const auto [found, isNew] = domains_.try_emplace(&generator);
        if (isNew) {
            cameras_.push_back(std::make_unique<Camera>());
            found->second = {cameras_.back().get(), &cameras_.back()->derivations.camera()};
        }
        return found->second;
    }

    std::mutex mutex_;
    std::unordered_map<const JointProgressive*, Domain> domains_;
    std::vector<std::unique_ptr<Camera>> cameras_; ///< outlive their generators: children do
};

} // namespace

const JointProgressive* watchedChild(const JointProgressive& parent, const JointProgressive* child,
                                     Scramble scramble, unsigned split) {
    return Watch::get().child(parent, child, scramble, split);
}

void watchDraws(const JointProgressive& generator, unsigned n, const SampleCtx& first) {
    if (generator.slot() < kJointSlots) Watch::get().draw(generator, n, &first);
}

void endWatch(const JointProgressive& generator) { Watch::get().end(generator); }

} // namespace wellstrat::stream1::detail

#endif
