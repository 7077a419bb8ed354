// SPDX-License-Identifier: Apache-2.0

#include "display.h"

#include "common/command_line/messages.h"
#include "common/command_line/options.h"

#include "renderer/color.h"

#include <CLI/Validators.hpp>

namespace wellstrat::cli {
namespace {

/// Of the mean luminance of the screen, beyond which little can be told apart.
constexpr double kAlmostBlack = 0.01, kAlmostWhite = 0.95;

/// The mean luminance of what is there of the picture.
double meanLuminance(const render::Film& film, const render::Display& display) {
    double sum = 0, area = 0;
    for (unsigned y = 0; y < film.height(); ++y) {
        for (unsigned x = 0; x < film.width(); ++x) {
            sum += double{render::luminance(render::displayed(film.mean(x, y), display))};
            area += double{film.alpha(x, y)};
        }
    }
    return area > 0 ? sum / area : 0;
}

} // namespace

void addDisplayOptions(CLI::App& command, DisplayOptions& options) {
    addReal(command, "--exposure", options.exposure, {-32, 32},
            "Stops by which .png and .jpg are brighter, not .exr and .hdr [0]");
    command
        .add_option("--tonemap", options.tonemap,
                    "Bright light in .png and .jpg: none cuts it off, filmic bends it [none]")
        ->check(CLI::IsMember({"none", "filmic"}))
        ->type_name("CURVE");
}

render::Display displayOf(const DisplayOptions& options) {
    return {static_cast<float>(options.exposure.value_or(0)), options.tonemap == "filmic"};
}

void sayIfInvisible(const render::Film& film, const render::Display& display) {
    const double mean = meanLuminance(film, display);
    if (mean < kAlmostBlack)
        say("the picture is almost black: its mean luminance is {:.2g}; more light or --exposure "
            "shows more",
            mean);
    if (mean > kAlmostWhite)
        say("the picture is almost white: its mean luminance is {:.2g}; less light or a negative "
            "--exposure shows more",
            mean);
}

} // namespace wellstrat::cli
