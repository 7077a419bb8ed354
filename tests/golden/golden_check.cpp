// SPDX-License-Identifier: Apache-2.0
//
// golden_check FILE...: recomputes every record of files of golden values and compares, once with
// each batch target of this processor. Exit code 0 if all agree, 1 if one does not, 2 if a file
// cannot be read or is none.

#include "golden.h"
#include "wellstrat/batch_target.h"

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

struct Tally {
    unsigned records = 0, failures = 0;
};

/// Checks all records of a file with the batch target in use. Whether the file is one.
bool check(const char* path, Tally& tally) {
    const char* target = wellstrat::chosenBatchTarget();
    std::ifstream file(path);
    if (!file) {
        std::fprintf(stderr, "golden_check: cannot read %s\n", path);
        return false;
    }
    const unsigned recordsBefore = tally.records;
    std::string line;
    for (unsigned number = 1; std::getline(file, line); ++number) {
        if (line.empty() || line[0] == '#') continue;
        ++tally.records;
        std::string got;
        try {
            got = recomputed(line);
        } catch (const std::invalid_argument& error) {
            std::fprintf(stderr, "%s:%u: %s\n", path, number, error.what());
            return false;
        } catch (const std::exception& error) {
            got = error.what();
        }
        if (got == line) continue;
        ++tally.failures;
        std::fprintf(stderr, "%s:%u: expected %s\n  %s gives %s\n", path, number, line.c_str(),
                     target, got.c_str());
    }
    if (tally.records == recordsBefore) {
        std::fprintf(stderr, "golden_check: no records in %s\n", path);
        return false;
    }
    return true;
}

} // namespace

int main(int argc, char** argv) {
    if (argc < 2) {
        std::fprintf(stderr, "usage: golden_check FILE...\n");
        return 2;
    }
    bool allAgree = true;
    for (unsigned i = 0; const char* target = wellstrat::batchTarget(i); ++i) {
        wellstrat::forceBatchTarget(target);
        Tally tally;
        for (int file = 1; file < argc; ++file) {
            if (!check(argv[file], tally)) return 2;
        }
        std::printf("%-8s %u of %u golden records agree\n", target, tally.records - tally.failures,
                    tally.records);
        allAgree = allAgree && tally.failures == 0;
    }
    return allAgree ? 0 : 1;
}
