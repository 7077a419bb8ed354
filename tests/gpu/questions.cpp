// SPDX-License-Identifier: Apache-2.0
//
// questions COUNT OUT FILE...: writes what shaders in a browser are asked to OUT, words of 32 bits:
// the questions of files of golden values and COUNT random ones of each kind, 8 words each (the
// kind, 5 arguments and zeros), and behind all of them their answers, 4 words each (the last 0).
// The golden test of gpu_check says that these are right.

#include "device.h"
#include "golden_questions.h"

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <fstream>

namespace gpu_check {
namespace {

void writeQuestions(int argc, char** argv) {
    if (argc < 4) throw std::runtime_error("usage: questions COUNT OUT FILE...");
    GoldenFile golden;
    for (int i = 3; i < argc; ++i) readGolden(argv[i], golden);
    std::vector<Question> questions;
    for (const Question& question : golden.questions) {
        if (question.kind != Kind::tablePoint) questions.push_back(question); // no draws
    }
    const auto count = static_cast<uint32_t>(std::strtoul(argv[1], nullptr, 10));
    for (uint32_t kind = 0; kind < kKinds; ++kind) {
        for (uint32_t i = 0; i < count; ++i) {
            questions.push_back(randomQuestion(static_cast<Kind>(kind), i));
        }
    }
    std::vector<uint32_t> words;
    for (const Question& question : questions) {
        words.push_back(static_cast<uint32_t>(question.kind));
        words.insert(words.end(), question.arguments, question.arguments + 5);
        words.insert(words.end(), 2, 0);
    }
    for (const Answer& answer : makeHost()->answers(questions)) {
        words.insert(words.end(), answer.words, answer.words + 3);
        words.push_back(0);
    }
    std::ofstream out(argv[2], std::ios::binary);
    out.write(reinterpret_cast<const char*>(words.data()),
              static_cast<std::streamsize>(words.size() * sizeof words[0]));
    if (!out.flush()) throw std::runtime_error(std::string("cannot write ") + argv[2]);
}

} // namespace
} // namespace gpu_check

int main(int argc, char** argv) {
    try {
        gpu_check::writeQuestions(argc, argv);
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "questions: %s\n", error.what());
        return 2;
    }
}
