// SPDX-License-Identifier: Apache-2.0

#pragma once

namespace wellstrat {

/// Draws `samples` samples in the way that is called `path`, for a program that counts
/// instructions; "nothing" only makes their contexts. False, after a line that says which there
/// are, if there is no such way.
bool drawForCounting(const char* path, unsigned samples);

} // namespace wellstrat
