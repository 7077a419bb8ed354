// SPDX-License-Identifier: Apache-2.0
//
// Writes the bits of HashToRandom without end, as 32-bit words for programs that test random number
// generators, such as `dieharder -g 200`:
//
//     hash_words sampleid|patternid|scramble
//
// says what counts up from draw to draw; the rest stays until that has run through its 2^32 values.
// Four draws of 24 bits give three words: each of the first three draws the upper 24 bits of one,
// the fourth their lower 8, so no bit of a draw is left untested.

#include "RixRNG.h"

#include <cstdint>
#include <cstdio>
#include <cstring>
#include <vector>

namespace {

using Draw = float (*)(uint32_t fixed, uint32_t counter);

float alongSampleid(uint32_t fixed, uint32_t counter) { return HashToRandom(fixed, counter); }
float alongPatternid(uint32_t fixed, uint32_t counter) { return HashToRandom(counter, fixed); }
float alongScramble(uint32_t fixed, uint32_t counter) {
    const RixRNG::SampleCtx domain =
        RixRNG::SampleCtx{fixed, 0}.NewDomain(static_cast<RixRNG::Scramble>(counter));
    return HashToRandom(domain.patternid, domain.sampleid);
}

Draw drawCalled(const char* name) {
    if (std::strcmp(name, "sampleid") == 0) return alongSampleid;
    if (std::strcmp(name, "patternid") == 0) return alongPatternid;
    if (std::strcmp(name, "scramble") == 0) return alongScramble;
    return nullptr;
}

uint32_t bitsOf(float value) { return static_cast<uint32_t>(value * 0x1p24f); }

/// Until nobody reads any more.
void writeWords(Draw draw) {
    constexpr uint32_t kDraws = 1u << 16;
    std::vector<uint32_t> words;
    for (uint64_t next = 0;; next += kDraws) {
        const auto fixed = static_cast<uint32_t>(next >> 32), first = static_cast<uint32_t>(next);
        words.clear();
        for (uint32_t i = first; i != first + kDraws; i += 4) {
            const uint32_t last = bitsOf(draw(fixed, i + 3));
            for (uint32_t k = 0; k < 3; ++k) {
                words.push_back(bitsOf(draw(fixed, i + k)) << 8 | (last >> 8 * k & 0xffu));
            }
        }
        if (std::fwrite(words.data(), sizeof words[0], words.size(), stdout) < words.size()) return;
    }
}

} // namespace

int main(int argc, char** argv) {
    const Draw draw = argc == 2 ? drawCalled(argv[1]) : nullptr;
    if (draw == nullptr) {
        std::fputs("hash_words: say what counts up: sampleid, patternid or scramble\n", stderr);
        return 2;
    }
    writeWords(draw);
}
