// SPDX-License-Identifier: Apache-2.0

#include "options.h"

#include "common/command_line/options.h"
#include "common/command_line/shell_word.h"

#include "renderer/film.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <string_view>

namespace wellstrat::cli {
namespace {

/// As in scene files: farther out, squares of areas exceed the largest float.
constexpr double kMostUnits = 1e9;

/// Reads a coordinate in front of `text` and moves `text` behind it.
bool takeFloat(std::string_view& text, float& number) {
    const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    text.remove_prefix(static_cast<std::size_t>(stop - text.data()));
    return error == std::errc() && std::abs(double{number}) <= kMostUnits;
}

bool take(std::string_view& text, char c) {
    if (text.empty() || text[0] != c) return false;
    text.remove_prefix(1);
    return true;
}

void addPoint(CLI::App& command, const std::string& flag, std::optional<Float3>& point,
              const std::string& description) {
    const auto read = [&point, flag](const std::string& text) {
        std::string_view rest = text;
        Float3 p;
        if (!takeFloat(rest, p.x) || !take(rest, ',') || !takeFloat(rest, p.y) ||
            !take(rest, ',') || !takeFloat(rest, p.z) || !rest.empty()) {
            throw CLI::ValidationError(flag,
                                       fmt::format("not three numbers X,Y,Z from {} to {}: '{}'",
                                                   -kMostUnits, kMostUnits, text));
        }
        point = p;
    };
    command.add_option_function<std::string>(flag, read, description)->type_name("X,Y,Z");
}

void addSize(CLI::App& command, std::optional<ImageSize>& size) {
    const auto read = [&size](const std::string& text) {
        const std::size_t cross = text.find('x');
        uint64_t width = 0, height = 0;
        const NumberRange range{1, render::kMaxFilmSize};
        if (cross == std::string::npos ||
            !parseNumber(std::string_view(text).substr(0, cross), range, width) ||
            !parseNumber(std::string_view(text).substr(cross + 1), range, height)) {
            throw CLI::ValidationError("--size",
                                       fmt::format("not WIDTHxHEIGHT, both from 1 to {}: '{}'",
                                                   render::kMaxFilmSize, text));
        }
        size = ImageSize{static_cast<unsigned>(width), static_cast<unsigned>(height)};
    };
    command
        .add_option_function<std::string>("--size", read,
                                          "Pixels [256 rows in the shape of the scene]")
        ->type_name("WxH");
}

} // namespace

CLI::Option* addSceneOptions(CLI::App& command, SceneOptions& options) {
    CLI::Option* const scene =
        command
            .add_option("scene", options.scene,
                        "A built-in scene, or a file: glTF, OBJ, and what else Assimp reads")
            ->type_name("SCENE");
    addSize(command, options.size);
    addNumber(command, "--depth", options.depth, {0, 1000},
              "Bounces of indirect light; 0 is direct light only [5]");
    addNumber(command, "--split", options.split, {1, 4096}, "Light samples at the first hit [1]");
    command.add_flag("--distrib", options.distrib,
                     "At later hits, as many light samples as the path is worth");
    addNumber(command, "--seed", options.seed, {0, kMaxWord}, "Another one, other noise [0]");
    addNumber(command, "--threads", options.threads, {1, 1024}, "Threads [all]");
    command
        .add_option("--environment", options.environment,
                    "Light from around: a latitude-longitude picture, such as FILE.hdr")
        ->type_name("FILE");
    addReal(command, "--environment-rotation", options.environmentRotation, {-360, 360},
            "Degrees by which it is turned, counterclockwise from above [0]");
    addReal(command, "--environment-strength", options.environmentStrength, {0, 1e6},
            "Multiplies its light [1]");
    command
        .add_option("--studio", options.studio,
                    "Gray light from around: on, off, or auto, where a file is dark [auto]")
        ->check(CLI::IsMember({"auto", "on", "off"}))
        ->type_name("WHEN");
    command.add_option("--camera-name", options.cameraName, "The scene file's camera of this name")
        ->type_name("NAME");
    addNumber(command, "--camera-number", options.cameraNumber, {1, kMaxWord},
              "Which of the scene file's cameras, of this name if one is given [1]");
    addPoint(command, "--camera", options.position, "Where the camera is");
    addPoint(command, "--look-at", options.lookAt, "Where it looks, and is focused");
    addPoint(command, "--up", options.up, "What is up in the picture [0,1,0]");
    addReal(command, "--fov", options.fov, {0.001, 179}, "Vertical field of view in degrees");
    addReal(command, "--lens-radius", options.lensRadius, {0, kMostUnits},
            "In units of the scene; 0 is a pinhole");
    addReal(command, "--focus", options.focus, {1 / kMostUnits, kMostUnits},
            "Distance of what is sharp");
    return scene;
}

std::string sceneArguments(const SceneOptions& options, ImageSize size) {
    std::string text =
        fmt::format("{} --size {}x{} --depth {} --split {} --seed {}", shellWord(options.scene),
                    size.width, size.height, options.depth, options.split, options.seed);
    if (options.distrib) text += " --distrib";
    if (options.environment) text += " --environment " + shellWord(*options.environment);
    if (options.studio != "auto") text += " --studio " + options.studio;
    const auto addReal = [&text](const char* flag, const std::optional<double>& value) {
        if (value) text += fmt::format(" {} {}", flag, *value);
    };
    addReal("--environment-rotation", options.environmentRotation);
    addReal("--environment-strength", options.environmentStrength);
    const auto addPoint = [&text](const char* flag, const std::optional<Float3>& p) {
        if (p) text += fmt::format(" {} {},{},{}", flag, p->x, p->y, p->z);
    };
    if (options.cameraName) text += " --camera-name " + shellWord(*options.cameraName);
    if (options.cameraNumber) text += fmt::format(" --camera-number {}", *options.cameraNumber);
    addPoint("--camera", options.position);
    addPoint("--look-at", options.lookAt);
    addPoint("--up", options.up);
    addReal("--fov", options.fov);
    addReal("--lens-radius", options.lensRadius);
    addReal("--focus", options.focus);
    return text;
}

} // namespace wellstrat::cli
