// SPDX-License-Identifier: Apache-2.0
//
// gpu_check [--rates] CONTEXTS FILE...: draws on the first GPU, and compares with files
// of golden values and, for so many contexts in all, with this processor. --rates: then says how
// fast samples are written to memory. scripts/gpu-check builds and runs it.
//
// Exit code 0 if all agree, 1 if anything differs, 2 if it cannot be tried, 77 if there is no
// device.

#include "device.h"
#include "golden_questions.h"

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <stdexcept>

namespace gpu_check {
namespace {

constexpr const char* kKindNames[kKinds] = {
    "sample",   "random",     "joint",        "long",        "long slot", "blue",   "blue slot",
    "sequence", "table",      "hash",         "domain",      "distrib",   "split",  "camera",
    "seeded",   "blue split", "blue distrib", "blue camera", "order",     "no slot"};

double secondsSince(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

bool checkGolden(const Device& device, int files, char** paths) {
    GoldenFile golden;
    for (int i = 0; i < files; ++i) readGolden(paths[i], golden);
    const std::vector<Answer> answers = device.answers(golden.questions);
    std::size_t agreeing = 0;
    for (const GoldenRecord& record : golden.records) {
        if (agrees(record, answers)) {
            ++agreeing;
        } else {
            std::printf("differs: %s\n", record.line.c_str());
        }
    }
    std::printf("%zu of %zu golden records agree\n", agreeing, golden.records.size());
    return agreeing == golden.records.size();
}

/// Shows a question of a kind to which the answers differ, if one of the first ones is such.
void showDifference(const Device& device, const Device& host, Kind kind, uint32_t count) {
    std::vector<Question> questions;
    for (uint32_t i = 0; i < count && i < 1u << 20; ++i) {
        questions.push_back(randomQuestion(kind, i));
    }
    const std::vector<Answer> got = device.answers(questions);
    const std::vector<Answer> expected = host.answers(questions);
    for (std::size_t i = 0; i < questions.size(); ++i) {
        if (got[i] == expected[i]) continue;
        const uint32_t* const a = questions[i].arguments;
        const uint32_t *const g = got[i].words, *const e = expected[i].words;
        std::printf("  %x %x %x %x %x: %x %x %x, not %x %x %x\n", a[0], a[1], a[2], a[3], a[4],
                    g[0], g[1], g[2], e[0], e[1], e[2]);
        return;
    }
}

bool checkSums(const Device& device, const Device& host, uint64_t contexts) {
    const auto count = static_cast<uint32_t>((contexts + kKinds - 1) / kKinds);
    double deviceSeconds = 0.0, hostSeconds = 0.0;
    bool allAgree = true;
    for (uint32_t i = 0; i < kKinds; ++i) {
        const auto kind = static_cast<Kind>(i);
        auto start = std::chrono::steady_clock::now();
        const uint64_t got = device.sum(kind, count);
        deviceSeconds += secondsSince(start);
        start = std::chrono::steady_clock::now();
        const uint64_t expected = host.sum(kind, count);
        hostSeconds += secondsSince(start);
        std::printf("%-12s %016llx %s\n", kKindNames[i], static_cast<unsigned long long>(got),
                    got == expected ? "agrees" : "DIFFERS");
        std::fflush(stdout);
        if (got == expected) continue;
        showDifference(device, host, kind, count);
        allAgree = false;
    }
    std::printf("%llu contexts: %.1f s, and %.1f s on %s\n",
                static_cast<unsigned long long>(uint64_t{count} * kKinds), deviceSeconds,
                hostSeconds, host.name().c_str());
    return allAgree;
}

void printRates(const std::vector<Rate>& rates) {
    for (const Rate& rate : rates) {
        std::printf("%-28s %7.1f GB/s  %7.1f G samples/s  %.2f of a fill\n", rate.what.c_str(),
                    rate.bytesPerSecond / 1e9, rate.bytesPerSecond / 8e9,
                    rate.bytesPerSecond / rates.front().bytesPerSecond);
    }
}

uint64_t contextCount(const char* text) {
    char* end = nullptr;
    const unsigned long long count = std::strtoull(text, &end, 10);
    const unsigned long long most = uint64_t{kKinds} << 32;
    if (*end != '\0' || text[0] < '0' || text[0] > '9' || count == 0 || count >= most) {
        throw std::runtime_error("contexts are a number from 1 to " + std::to_string(most - 1) +
                                 ", not '" + text + "'");
    }
    return count;
}

bool run(int argc, char** argv) {
    const bool rates = argc > 1 && std::string(argv[1]) == "--rates";
    const int first = rates ? 2 : 1;
    if (argc < first + 2) throw std::runtime_error("usage: gpu_check [--rates] CONTEXTS FILE...");
    const uint64_t contexts = contextCount(argv[first]);
    const std::unique_ptr<Device> device = makeChecked(), host = makeHost();
    std::printf("%s\n", device->name().c_str());
    bool agree = checkGolden(*device, argc - first - 1, argv + first + 1);
    agree = checkSums(*device, *host, contexts) && agree;
    if (rates) printRates(device->rates());
    std::printf("%s\n", agree ? "all agree" : "NOT all agree");
    return agree;
}

} // namespace
} // namespace gpu_check

int main(int argc, char** argv) {
    try {
        return gpu_check::run(argc, argv) ? 0 : 1;
    } catch (const gpu_check::NoDevice& nothing) {
        std::printf("skipped: %s\n", nothing.what());
        return 77;
    } catch (const std::exception& error) {
        std::fflush(stdout);
        std::fprintf(stderr, "gpu_check: %s\n", error.what());
        return 2;
    }
}
