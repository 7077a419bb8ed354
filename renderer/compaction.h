// SPDX-License-Identifier: Apache-2.0
//
// Some paths of a batch end, and those that go on move to the front.

#pragma once

namespace wellstrat::render {

/// Calls goesOn(i) once for each i of [0, count), in order. The entries i of all `arrays` for which
/// it is true move to the front, in order and together; the others are lost. Returns how many are
/// left. `goesOn` may change the entries i before they move. Those of other i it must not use: some
/// have moved already.
template <class GoesOn, class... Entry>
unsigned compact(unsigned count, const GoesOn& goesOn, Entry*... arrays) {
    unsigned left = 0;
    for (unsigned i = 0; i < count; ++i) {
        if (!goesOn(i)) continue;
        if (left != i) ((arrays[left] = arrays[i]), ...);
        ++left;
    }
    return left;
}

} // namespace wellstrat::render
