// SPDX-License-Identifier: Apache-2.0

#include "scene_options.h"

#include "errors.h"
#include "options.h"

#include "renderer/builtin_scenes.h"
#include "renderer/film.h"
#include "renderer/framing.h"
#include "renderer/memory.h"
#include "renderer/scene_file.h"

#include "wellstrat/joint.h"
#include "wellstrat/version.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <stdexcept>
#include <string_view>

namespace wellstrat::cli {
namespace {

constexpr unsigned kDefaultRows = 256;
/// As in scene files: farther out, squares of areas exceed the largest float.
constexpr double kMostUnits = 1e9;
constexpr double kDegree = 3.14159265358979323846 / 180;

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

render::Scene sceneOf(const std::string& name) {
    if (render::isBuiltinScene(name)) return render::builtinScene(name);
    std::error_code ignored;
    if (!std::filesystem::exists(name, ignored)) {
        std::string names;
        for (const auto& scene : render::builtinScenes()) {
            names += fmt::format("{}{}", names.empty() ? "" : ", ", scene.name);
        }
        throw CliError(fmt::format("there is no file '{}'; built-in scenes are {}", name, names));
    }
    return render::readScene(name);
}

/// The point in front of a camera at which it is focused.
Float3 focusPoint(const render::Camera& camera) {
    return camera.position + camera.forward * camera.focusDistance;
}

/// A camera moved or turned, focused on what it looks at.
render::Camera placed(const SceneOptions& options, const render::Scene& scene,
                      const render::Camera& old) {
    const Float3 position = options.position.value_or(old.position);
    const Float3 target = options.lookAt.value_or(
        options.position ? render::sceneBounds(scene).center() : focusPoint(old));
    const Float3 up = options.up.value_or(Float3(0, 1, 0));
    render::Camera camera = render::lookAt(position, target, up, old.verticalFov);
    camera.lensRadius = old.lensRadius;
    camera.focusDistance = (target - position).Length();
    return camera;
}

void changeCamera(const SceneOptions& options, render::Scene& scene) {
    render::Camera& camera = *scene.camera;
    if (scene.cameraIsAutomatic && options.size) {
        const auto [width, height] = *options.size;
        camera = render::framingCamera(render::sceneBounds(scene),
                                       static_cast<float>(width) / static_cast<float>(height));
    }
    try {
        if (options.position || options.lookAt || options.up) {
            camera = placed(options, scene, camera);
        }
    } catch (const std::invalid_argument& error) {
        throw CliError(fmt::format("--camera: {}", error.what()));
    }
    if (options.fov) camera.verticalFov = static_cast<float>(*options.fov * kDegree);
    if (options.lensRadius) camera.lensRadius = static_cast<float>(*options.lensRadius);
    if (options.focus) camera.focusDistance = static_cast<float>(*options.focus);
}

/// Puts `text` in the place of a note that the options made untrue; nothing if that is empty.
void replaceNote(std::vector<std::string>& notes, std::string_view untrue,
                 const std::string& text) {
    const auto note = std::find(notes.begin(), notes.end(), untrue);
    if (note == notes.end()) return;
    if (text.empty()) {
        notes.erase(note);
    } else {
        *note = text;
    }
}

} // namespace

CLI::Option* addSceneOptions(CLI::App& command, SceneOptions& options) {
    CLI::Option* const scene =
        command.add_option("scene", options.scene, "A built-in scene, or a file that Assimp reads")
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

std::string sceneList() {
    std::string text;
    for (const auto& scene : render::builtinScenes()) {
        fmt::format_to(std::back_inserter(text), "{:<12} {}\n", scene.name, scene.description);
    }
    return text;
}

render::Scene loadScene(const SceneOptions& options) {
    render::Scene scene = sceneOf(options.scene);
    if (options.environment) {
        scene.environment = render::readEnvironment(*options.environment, &scene.notes);
        replaceNote(scene.notes, render::kNoLightNote, "");
    }
    changeCamera(options, scene);
    if (options.position) {
        replaceNote(scene.notes, render::kNoCameraNote, "");
    } else if (options.lookAt || options.up || options.fov) {
        replaceNote(scene.notes, render::kNoCameraNote,
                    "There is no camera: it stands in front of the scene.");
    }
    return scene;
}

ImageSize imageSize(const SceneOptions& options, const render::Scene& scene) {
    const double columns = std::round(double{kDefaultRows} * double{scene.aspect});
    const ImageSize size = options.size.value_or(
        ImageSize{static_cast<unsigned>(std::clamp(columns, 1.0, double{render::kMaxFilmSize})),
                  kDefaultRows});
    requireMemory("--size", render::filmMemory(size.width, size.height),
                  fmt::format("{}x{} pixels", size.width, size.height));
    return size;
}

void requireMemory(const std::string& option, uint64_t bytes, const std::string& what) {
    try {
        render::requireMemory(bytes, what);
    } catch (const std::runtime_error& error) {
        throw CliError(fmt::format("{}: {}", option, error.what()));
    }
}

const std::vector<NamedGenerator>& renderGenerators() {
    static const JointProgressive joint;
    static const std::vector<NamedGenerator> generators = [] {
        std::vector<NamedGenerator> all = namedGenerators();
        all.push_back({"joint", "the tables, with domains stratified together", &joint});
        return all;
    }();
    return generators;
}

CLI::Option* addRenderGenerators(CLI::App& command, std::vector<std::string>& names,
                                 const std::string& description) {
    return command.add_option("--generators", names, description)
        ->delimiter(',')
        ->allow_extra_args(false)
        ->type_name("NAME,NAME");
}

const Generator* renderGenerator(const std::string& name) {
    return findGenerator("--generators", name, renderGenerators()).generator;
}

std::unique_ptr<render::Renderer> makeRenderer(const SceneOptions& options,
                                               const render::Scene& scene, ImageSize size,
                                               const Generator* generator) {
    render::SamplingOptions sampling;
    sampling.generator = generator;
    sampling.seed = static_cast<unsigned>(options.seed);
    sampling.depth = static_cast<unsigned>(options.depth);
    sampling.split = static_cast<unsigned>(options.split);
    sampling.distrib = options.distrib;
    try {
        return std::make_unique<render::Renderer>(scene, size.width, size.height, sampling);
    } catch (const std::invalid_argument& error) {
        throw CliError(fmt::format("cannot render '{}': {}", options.scene, error.what()));
    }
}

std::unique_ptr<tbb::global_control> limitThreads(const SceneOptions& options) {
    if (!options.threads) return nullptr;
    return std::make_unique<tbb::global_control>(tbb::global_control::max_allowed_parallelism,
                                                 *options.threads);
}

std::string shellWord(const std::string& text) {
    std::string word = "'";
    for (const char c : text) word += c == '\'' ? "'\\''" : std::string(1, c);
    return word + "'";
}

std::string sceneArguments(const SceneOptions& options, ImageSize size) {
    std::string text =
        fmt::format("{} --size {}x{} --depth {} --split {} --seed {}", shellWord(options.scene),
                    size.width, size.height, options.depth, options.split, options.seed);
    if (options.distrib) text += " --distrib";
    if (options.environment) text += " --environment " + shellWord(*options.environment);
    const auto addPoint = [&text](const char* flag, const std::optional<Float3>& p) {
        if (p) text += fmt::format(" {} {},{},{}", flag, p->x, p->y, p->z);
    };
    addPoint("--camera", options.position);
    addPoint("--look-at", options.lookAt);
    addPoint("--up", options.up);
    const auto addReal = [&text](const char* flag, const std::optional<double>& value) {
        if (value) text += fmt::format(" {} {}", flag, *value);
    };
    addReal("--fov", options.fov);
    addReal("--lens-radius", options.lensRadius);
    addReal("--focus", options.focus);
    return text;
}

std::map<std::string, std::string> imageSettings(const SceneOptions& options,
                                                 const std::string& fingerprint,
                                                 const std::string& generator) {
    return {{"scene", fingerprint},
            {"generator", generator},
            {"stream_version", fmt::format("{}", kStreamVersion)},
            {"seed", fmt::format("{}", options.seed)},
            {"depth", fmt::format("{}", options.depth)},
            {"split", fmt::format("{}", options.split)},
            {"distrib", options.distrib ? "yes" : "no"}};
}

void checkSamples(const SceneOptions& options, const std::string& option, uint64_t samples) {
    const uint64_t most = kMaxWord / options.split;
    if (samples <= most) return;
    throw CliError(fmt::format("{}: a pixel has at most {} samples with --split {}, not {}", option,
                               most, options.split, samples));
}

void sayNotes(const render::Scene& scene) {
    for (const std::string& note : scene.notes) {
        fmt::print(stderr, "wellstrat: {}\n", oneLine(note));
    }
}

} // namespace wellstrat::cli
