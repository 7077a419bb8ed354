// SPDX-License-Identifier: Apache-2.0
//
// The sub-commands of the command line tool that render: wellstrat-render SUBCOMMAND [OPTIONS], or
// the same as a part of `wellstrat`.

#include "commands.h"
#include "common/command_line/errors.h"
#include "common/command_line/process_start.h"
#include "common/command_line/program.h"
#include "common/command_line/render_commands.h"

#include <filesystem>

namespace {

using namespace wellstrat::cli;

constexpr auto kExamples = R"(Examples:
  wellstrat render cornell -o cornell.png
  wellstrat compare veach --spp 1,4,16,64 -o veach.html
  wellstrat-render SUBCOMMAND --help

Exit codes: 0 done, 2 error, 130 interrupted.
)";

} // namespace

int main(int argc, char** argv) {
    startProcess();
    endProcess(exitCodeOf([&] {
        const bool isPart = argc > 0 && std::filesystem::path(argv[0]).filename() == "wellstrat";
        return runProgram(
            {isPart ? "wellstrat" : kRenderProgram,
             "The part of wellstrat that renders.",
             kExamples,
             {{addRender, kShared}, {addMerge}, {addCompare, kShared}, {addDomains, kShared}}},
            argc, argv);
    }));
}
