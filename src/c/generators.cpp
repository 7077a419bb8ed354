// SPDX-License-Identifier: Apache-2.0

#include "c/generators.h"

#include "wellstrat/blue.h"
#include "wellstrat/joint.h"
#include "wellstrat/long.h"
#include "wellstrat/random_generator.h"

#include <stdexcept>
#include <string>

namespace wellstrat {
inline namespace stream1 {
namespace {

static_assert(WELLSTRAT_SLOTS == kJointSlots && WELLSTRAT_MAX_SPLITS == kMaxJointSplit,
              "C has the numbers of order.h");

/// An object that is never destroyed: other threads may draw while the process ends.
template <class T>
union Immortal {
    constexpr Immortal() : object() {}
    ~Immortal() {} // NOLINT(modernize-use-equals-default): a default one would be deleted

    T object;
};

const Immortal<JointProgressive> kTables;
const Immortal<LongProgressive> kLong;
const Immortal<BlueProgressive> kBlue;
const Immortal<RandomGenerator> kRandom;

} // namespace

const Generator& c::generatorOf(wellstrat_domain domain) {
    switch (domain.generator) {
    case WELLSTRAT_PMJ:
    case WELLSTRAT_JOINT: return kTables.object;
    case WELLSTRAT_LONG: return kLong.object;
    case WELLSTRAT_BLUE: return kBlue.object;
    case WELLSTRAT_RANDOM: return kRandom.object;
    default:
        throw std::invalid_argument("generator " + std::to_string(domain.generator) +
                                    " does not exist; accepted are 0 (pmj) to 4 (random)");
    }
}

Order c::orderOf(wellstrat_domain domain) {
    const unsigned slot = domain.slot, splits = domain.splits;
    if (slot > kJointSlots) {
        throw std::invalid_argument("slot " + std::to_string(slot) +
                                    " does not exist; accepted are 0 to 15, and 16 for none");
    }
    const unsigned fewest = slot == kJointSlots ? 0 : 1;
    if (splits < fewest || splits > kMaxJointSplit) {
        throw std::invalid_argument("the splits of the domain are " + std::to_string(splits) +
                                    "; accepted are " + std::to_string(fewest) + " to 256" +
                                    (fewest == 1 ? " in a slot" : " without a slot"));
    }
    Order order;
    order.slot = domain.slot;
    order.splits = domain.splits;
    return order;
}

Order c::drawnOrderOf(wellstrat_domain domain) {
    const Order order = orderOf(domain);
    return domain.generator == WELLSTRAT_PMJ ? viewOrder(order) : order;
}

} // namespace stream1
} // namespace wellstrat
