// SPDX-License-Identifier: Apache-2.0
//
// wellstrat merge: puts together images with different samples.

#include "commands.h"
#include "common/command_line/errors.h"
#include "common/command_line/messages.h"
#include "common/command_line/render_commands.h"
#include "image/display.h"
#include "image/files.h"

#include <fmt/format.h>

#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace wellstrat::cli {
namespace {

constexpr auto kExamples =
    R"(The inputs are .exr files of `wellstrat render` with the same scene, size and options, and each
with other samples. The order does not matter: the result is the same bits as if all samples had
been rendered at once. If samples are missing, it says which. A single image may be merged alone, to
show it with another --exposure.

Examples:
  wellstrat render veach -o a.exr --samples 0:512
  wellstrat render veach -o b.exr --samples 512:1024
  wellstrat merge a.exr b.exr -o veach.exr -o veach.png
  wellstrat merge veach.exr -o brighter.jpg --exposure 1.5 --tonemap filmic
)";

struct MergeOptions {
    DisplayOptions display;
    std::vector<std::string> inputs, outputs;
};

void merge(const MergeOptions& options) {
    for (const std::string& path : options.inputs) declareInput(path);
    ImageFiles files("--output", options.outputs, displayOf(options.display));
    render::FilmPart sum = readImage(options.inputs.front());
    for (std::size_t i = 1; i < options.inputs.size(); ++i) {
        const std::string& path = options.inputs[i];
        try {
            render::addPart(sum, readImage(path));
        } catch (const std::logic_error& error) {
            throw CliError(
                fmt::format("'{}' cannot be added to those before it: {}", path, error.what()));
        }
    }
    files.write(sum);
    const std::string missing = render::missingSamples(sum);
    if (!missing.empty()) say("missing: {}", missing);
}

} // namespace

void addMerge(CLI::App& app, int& /*exitCode*/) {
    CLI::App* const command = app.add_subcommand(kMerge.name, kMerge.description);
    const auto options = std::make_shared<MergeOptions>();
    command->add_option("images", options->inputs, "Images with sums: .exr")
        ->required()
        ->type_name("FILE...");
    command
        ->add_option("-o,--output", options->outputs,
                     "The image: FILE.exr, .png, .jpg or .hdr; may be given several times")
        ->required()
        ->allow_extra_args(false)
        ->type_name("FILE");
    addDisplayOptions(*command, options->display);
    command->footer(kExamples);
    command->callback([options] { merge(*options); });
}

} // namespace wellstrat::cli
