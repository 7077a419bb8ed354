// SPDX-License-Identifier: Apache-2.0
//
// The golden files as questions (question.h), and what their answers must make up.

#pragma once

#include "question.h"

#include <cstddef>
#include <string>
#include <vector>

namespace gpu_check {

/// A line of a golden file.
struct GoldenRecord {
    std::string line;
    std::vector<uint32_t> expected;
    std::size_t firstQuestion, questions; ///< its part of GoldenFile::questions; none: `stream`
    bool digested;                        ///< expected is the digest of all answers
};

struct GoldenFile {
    std::vector<GoldenRecord> records;
    std::vector<Question> questions;
};

/// Adds the records of a file. Throws std::runtime_error, with a line that says what is wrong, if
/// it cannot be read or is none.
void readGolden(const std::string& path, GoldenFile& golden);

/// Whether the answers to golden.questions make up what the record says.
bool agrees(const GoldenRecord& record, const std::vector<Answer>& answers);

} // namespace gpu_check
