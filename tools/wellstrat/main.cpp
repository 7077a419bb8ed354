// SPDX-License-Identifier: Apache-2.0
//
// The command line tool: wellstrat SUBCOMMAND [OPTIONS].

#include "commands.h"
#include "common/command_line/errors.h"
#include "common/command_line/process_start.h"
#include "common/command_line/program.h"
#include "render_program.h"

namespace {

using namespace wellstrat::cli;

constexpr auto kExamples = R"(Examples:
  wellstrat sample --dims 2 --count 16
  wellstrat sample --compare random,pmj --count 256 --plot compare.png
  wellstrat verify
  wellstrat tables --export tables.npy
  wellstrat report --quick -o report.html
  wellstrat SUBCOMMAND --help

Exit codes: 0 done, 1 a promise does not hold (verify), 2 error.
)";

} // namespace

int main(int argc, char** argv) {
    startProcess();
    return exitCodeOf([&] {
        if (namesRenderCommand(argc, argv)) becomeRenderProgram(argv);
        return runProgram({"wellstrat",
                           "Well-stratified samples for renderers.",
                           kExamples,
                           {{addSample},
                            {addVerify},
                            {addTables},
                            {addAnalyze},
                            {addInfo},
                            {addStudy, kShared},
                            {addReport, kShared},
                            {addBank},
                            {addRanks},
                            {addRenderCommands}}},
                          argc, argv);
    });
}
