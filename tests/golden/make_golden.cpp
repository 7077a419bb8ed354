// SPDX-License-Identifier: Apache-2.0
//
// make_golden FILE: writes the golden values anew, but for those of slots (joint.h), which
// make_golden --joint FILE writes, and for those of long.h and blue.h: --long, --blue. Only for a
// new stream version: as long as the version is the same, a file that changes is a bug.

#include "golden.h"

#include <filesystem>
#include <fstream>
#include <iostream>

namespace {

using golden::Words;

/// Around all edges: of groups, of blocks, of what is stratified, of 32 bits.
const Words kSampleids = {
    0,      1,      2,       3,           5,           63,          255,        256,
    257,    1023,   4095,    4096,        4097,        8191,        8192,       12288,
    65535,  65536,  98304,   99999,       131071,      192511,      192512,     196607,
    196608, 196609, 1000000, 0x7fffffffu, 0x80000000u, 0xfffffffeu, 0xffffffffu};
const Words kPatterns = {0,           1,           2,           255,         256,
                         0x12345678u, 0x2d96c92bu, 0x3917fe2eu, 0xdeb189cfu, 0x7fffffffu,
                         0x80000000u, 0xfffffffeu, 0xffffffffu};
const Words kScrambles = {0, 1, 0x2d96c92bu, 0x85a308d3u, 0xffffffffu};
const Words kCounts = {0, 1, 2, 4, 7, 0xffffffffu};

class Writer {
public:
    explicit Writer(std::ostream& out) : out_(out) {}
    void operator()(const char* kind, const Words& arguments = {}) {
        out_ << golden::record(kind, arguments) << '\n';
    }

private:
    std::ostream& out_;
};

void writeSamples(Writer& write) {
    for (const uint32_t pattern : kPatterns) {
        for (const uint32_t sampleid : kSampleids) write("sample", {pattern, sampleid});
    }
    for (const uint32_t pattern : kPatterns) {
        for (const uint32_t first : {0u, 4096u, 96u * 1024u, 47u * 4096u, 0xfffffff0u}) {
            write("run", {pattern, first, 4096 + 16});
        }
        for (const uint32_t sampleid : {0u, 1u, 0xffffffffu}) write("random", {pattern, sampleid});
    }
    for (uint32_t table = 0; table < wellstrat::kTableCount; ++table) write("table", {table});
}

void writeContexts(Writer& write) {
    for (const uint32_t pattern : {0u, 1u, 0x12345678u, 0xffffffffu}) {
        for (const uint32_t scramble : kScrambles) {
            write("domain", {pattern, 7, scramble});
            for (const uint32_t sampleid : {0u, 1u, 0xffffffffu}) {
                write("distrib", {pattern, sampleid, scramble, sampleid / 2});
            }
        }
        for (const uint32_t count : kCounts) write("split", {pattern, 0x40000003u, 5, count});
        for (const uint32_t b : kSampleids) write("hash", {pattern, b});
    }
    for (const uint32_t x : {0u, 1u, 0xffffu, 0x10000u, 0xffffffffu}) {
        for (const uint32_t y : {0u, 1u, 1079u, 0xffffffffu}) {
            for (const uint32_t frame : {0u, 1u, 0xffffffffu}) write("camera", {x, y, frame, 9});
            for (const uint32_t seed : {1u, 0xffffffffu}) write("seeded", {x, y, 1, 9, seed});
        }
    }
}

constexpr const char* kHead =
    "# Golden values of wellstrat; golden.h explains the lines. Made by make_golden";

void writeAll(std::ostream& out) {
    out << kHead << ".\n";
    Writer write(out);
    write("stream");
    writeSamples(write);
    writeContexts(write);
}

/// All slots, both orders of each, and splits of all kinds.
void writeSlots(Writer& write, const char* kind) {
    for (uint32_t slot = 0; slot < wellstrat::kJointSlots; ++slot) {
        for (const uint32_t pattern : {0u, 1u, 2u, 0x2d96c92bu}) {
            for (const uint32_t sampleid : {1u, 0xfffu, 0x1234u, 196608u}) {
                write(kind, {pattern, sampleid, slot, 1});
            }
            for (const uint32_t split : {3u, 12u, 256u}) {
                for (const uint32_t sampleid : {7u, 131077u}) {
                    write(kind, {pattern, sampleid, slot, split});
                }
            }
        }
    }
}

void writeJoint(std::ostream& out) {
    out << kHead << " --joint.\n";
    Writer write(out);
    write("stream");
    writeSlots(write, "joint");
}

void writeLong(std::ostream& out) {
    out << kHead << " --long.\n";
    Writer write(out);
    write("stream");
    for (const uint32_t pattern : kPatterns) {
        for (const uint32_t sampleid : kSampleids) write("long", {pattern, sampleid});
        for (const uint32_t sampleid : {0u, 65535u, 65536u, 0xffffffffu}) {
            write("sequence", {pattern, sampleid});
        }
    }
    writeSlots(write, "longslot");
    for (const uint32_t split : {1u, 2u, 3u, 255u}) {
        write("longslot", {5, 0xffffffffu, 7, split});
        write("longslot", {5, 0x80000000u, 7, split});
    }
}

void writeBlue(std::ostream& out) {
    out << kHead << " --blue.\n";
    Writer write(out);
    write("stream");
    for (const uint32_t pattern : kPatterns) {
        for (const uint32_t sampleid : kSampleids) write("blue", {pattern, sampleid});
        for (const uint32_t scramble : kScrambles) {
            for (const uint32_t count : kCounts) write("bluesplit", {pattern, 7, scramble, count});
            for (const uint32_t sampleid : {0u, 1u, 0xfffffu, 0x100000u, 0xffffffffu}) {
                write("bluedistrib", {pattern, sampleid, scramble, sampleid / 2});
            }
        }
    }
    writeSlots(write, "blueslot");
    for (const uint32_t x : {0u, 1u, 63u, 64u, 0xffffu, 0x10000u, 0xffffffffu}) {
        for (const uint32_t y : {0u, 1u, 1079u, 0xffffffffu}) {
            for (const uint32_t seed : {0u, 1u, 0xffffffffu}) write("bluecamera", {x, y, seed, 9});
        }
    }
}

} // namespace

int main(int argc, char** argv) {
    const std::string option = argc == 3 ? argv[1] : "";
    const bool isKnown = option == "--joint" || option == "--long" || option == "--blue";
    if (argc < 2 || argc > 3 || (argc == 3 && !isKnown)) {
        std::cerr << "usage: make_golden [--joint | --long | --blue] FILE\n";
        return 2;
    }
    const std::string path = argv[argc - 1], unfinished = path + ".part";
    {
        std::ofstream out(unfinished, std::ios::binary);
        if (option == "--joint") writeJoint(out);
        if (option == "--long") writeLong(out);
        if (option == "--blue") writeBlue(out);
        if (option.empty()) writeAll(out);
        if (!out.flush()) {
            std::cerr << "make_golden: cannot write " << unfinished << '\n';
            return 2;
        }
    }
    std::error_code error;
    std::filesystem::rename(unfinished, path, error);
    if (error) {
        std::cerr << "make_golden: cannot write " << path << ": " << error.message() << '\n';
        return 2;
    }
    return 0;
}
