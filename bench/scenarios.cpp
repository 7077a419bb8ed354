// SPDX-License-Identifier: Apache-2.0

#include "scenarios.h"

namespace wellstrat {
namespace {

std::vector<void (*)()>& suites() {
    static std::vector<void (*)()> all;
    return all;
}

} // namespace

Suite::Suite(void (*add)()) { suites().push_back(add); }

void Suite::addAll() {
    for (void (*add)() : suites()) add();
}

} // namespace wellstrat
