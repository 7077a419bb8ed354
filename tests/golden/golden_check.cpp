// SPDX-License-Identifier: Apache-2.0
//
// golden_check FILE: recomputes every record of a file of golden values and compares, once with
// each batch target of this processor. Exit code 0 if all agree, 1 if one does not, 2 if the file
// cannot be read or is none.

#include "golden.h"
#include "wellstrat/batch_target.h"

#include <algorithm>
#include <cstdio>
#include <exception>
#include <fstream>

namespace {

/// The record that the library gives for the arguments of this one.
std::string recomputed(const std::string& line) {
    std::istringstream in(line);
    std::string kind, word;
    golden::Words arguments;
    in >> kind;
    while (in >> word && word != "=") {
        std::size_t used = 0;
        arguments.push_back(static_cast<uint32_t>(std::stoul(word, &used, 16)));
        if (used != word.size()) throw std::invalid_argument("\"" + word + "\" is no number");
    }
    return golden::record(kind, arguments);
}

/// Checks all records with the batch target in use. The exit code.
int check(const char* path) {
    const char* target = wellstrat::chosenBatchTarget();
    std::ifstream file(path);
    if (!file) {
        std::fprintf(stderr, "golden_check: cannot read %s\n", path);
        return 2;
    }
    unsigned records = 0, failures = 0;
    std::string line;
    for (unsigned number = 1; std::getline(file, line); ++number) {
        if (line.empty() || line[0] == '#') continue;
        ++records;
        std::string got;
        try {
            got = recomputed(line);
        } catch (const std::invalid_argument& error) {
            std::fprintf(stderr, "%s:%u: %s\n", path, number, error.what());
            return 2;
        } catch (const std::exception& error) {
            got = error.what();
        }
        if (got == line) continue;
        ++failures;
        std::fprintf(stderr, "%s:%u: expected %s\n  %s gives %s\n", path, number, line.c_str(),
                     target, got.c_str());
    }
    if (records == 0) {
        std::fprintf(stderr, "golden_check: no records in %s\n", path);
        return 2;
    }
    std::printf("%-8s %u of %u golden records agree\n", target, records - failures, records);
    return failures == 0 ? 0 : 1;
}

} // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fprintf(stderr, "usage: golden_check FILE\n");
        return 2;
    }
    int worst = 0;
    for (unsigned i = 0; const char* target = wellstrat::batchTarget(i); ++i) {
        wellstrat::forceBatchTarget(target);
        worst = std::max(worst, check(argv[1]));
        if (worst == 2) break;
    }
    return worst;
}
