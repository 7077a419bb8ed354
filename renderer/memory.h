// SPDX-License-Identifier: Apache-2.0
//
// Whether there is memory enough, asked before it is taken: a process that takes too much is
// killed without a word.

#pragma once

#include <cstdint>
#include <string>

namespace wellstrat::render {

/// The memory in bytes that a film takes while it is rendered and written.
constexpr uint64_t filmMemory(uint64_t width, uint64_t height) { return width * height * 256; }

/// The bytes that the machine has to give; UINT64_MAX where the system does not tell.
uint64_t availableMemory();

/// Throws std::runtime_error, which says what `what` needs and what there is, if the machine has
/// fewer bytes to give. Does nothing where the system does not tell.
void requireMemory(uint64_t bytes, const std::string& what);

} // namespace wellstrat::render
