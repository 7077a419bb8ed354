// SPDX-License-Identifier: Apache-2.0
//
// Debug builds end the program when a path draws from one slot of JointProgressive through two
// domains. With NDEBUG there is nothing of it.

#pragma once

#include "wellstrat/joint.h"

namespace wellstrat::stream1::detail {

#ifdef NDEBUG

inline const JointProgressive* watchedChild(const JointProgressive& /*parent*/,
                                            const JointProgressive* child, Scramble /*scramble*/,
                                            unsigned /*split*/) {
    return child;
}
inline void watchDraws(const JointProgressive& /*generator*/, unsigned /*n*/,
                       const SampleCtx& /*first*/) {}
inline void endWatch(const JointProgressive& /*generator*/) {}

#else

/// An object like `child` that knows how its domain is derived from the camera's. One is made for
/// each derivation from each camera's generator, and never freed.
const JointProgressive* watchedChild(const JointProgressive& parent, const JointProgressive* child,
                                     Scramble scramble, unsigned split);

/// To be called with the n >= 1 contexts that are drawn. If the path of one of them drew the same
/// slot in another domain, by the children of the same camera's generator, prints a line with both
/// and aborts. Only recent paths are known.
void watchDraws(const JointProgressive& generator, unsigned n, const SampleCtx& first);

/// Forgets the paths of a camera's generator, that another one may take its address.
void endWatch(const JointProgressive& generator);

#endif

} // namespace wellstrat::stream1::detail
