// SPDX-License-Identifier: Apache-2.0

#include "load.h"

#include "common/command_line/errors.h"
#include "common/command_line/messages.h"
#include "common/output/output_file.h"

#include "renderer/builtin_scenes.h"
#include "renderer/film.h"
#include "renderer/framing.h"
#include "renderer/memory.h"
#include "renderer/scene_file.h"
#include "renderer/studio.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <vector>

namespace wellstrat::cli {
namespace {

constexpr unsigned kDefaultRows = 256;
constexpr double kDegree = 3.14159265358979323846 / 180;
constexpr Float3 kUp{0, 1, 0};

render::Scene sceneOf(const SceneOptions& options) {
    const std::string& name = options.scene;
    if (render::isBuiltinScene(name)) {
        if (options.cameraName || options.cameraNumber)
            throw CliError(
                "--camera-name and --camera-number are for scene files: built-in scenes "
                "have one camera each");
        return render::builtinScene(name);
    }
    std::error_code ignored;
    if (!std::filesystem::exists(name, ignored)) {
        std::string names;
        for (const auto& scene : render::builtinScenes()) {
            names += fmt::format("{}{}", names.empty() ? "" : ", ", scene.name);
        }
        throw CliError(fmt::format("there is no file '{}'; built-in scenes are {}", name, names));
    }
    declareInput(name);
    render::Scene scene = render::readScene(name, {options.cameraName, options.cameraNumber});
    for (const std::string& file : scene.files) declareInput(file);
    return scene;
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
    render::Camera camera =
        render::lookAt(position, target, options.up.value_or(kUp), old.verticalFov);
    camera.lensRadius = old.lensRadius;
    camera.orthographicHeight = old.orthographicHeight;
    camera.focusDistance = (target - position).Length();
    return camera;
}

/// Those of the options that place the camera which are given.
std::string placingOptions(const SceneOptions& options) {
    std::string names;
    const auto add = [&names](bool isGiven, const char* name) {
        if (isGiven) names += names.empty() ? name : fmt::format(", {}", name);
    };
    add(options.position.has_value(), "--camera");
    add(options.lookAt.has_value(), "--look-at");
    add(options.up.has_value(), "--up");
    return names;
}

float aspectOf(const SceneOptions& options, const render::Scene& scene) {
    if (!options.size) return scene.aspect;
    return static_cast<float>(options.size->width) / static_cast<float>(options.size->height);
}

void changeCamera(const SceneOptions& options, render::Scene& scene) {
    render::Camera& camera = *scene.camera;
    if (scene.cameraIsAutomatic) camera = render::framingCamera(scene, aspectOf(options, scene));
    try {
        if (options.position || options.lookAt || options.up) {
            camera = placed(options, scene, camera);
        }
    } catch (const std::invalid_argument& error) {
        throw CliError(fmt::format("{}: {}", placingOptions(options), error.what()));
    }
    if (options.fov) {
        camera.verticalFov = static_cast<float>(*options.fov * kDegree);
        camera.orthographicHeight = 0;
    }
    if (options.lensRadius) camera.lensRadius = static_cast<float>(*options.lensRadius);
    if (options.focus) camera.focusDistance = static_cast<float>(*options.focus);
}

/// Lights the scene if the options want it, or if it needs it, which a note says.
void addStudio(const SceneOptions& options, render::Scene& scene) {
    const bool isAuto = options.studio == "auto";
    if (options.studio == "off" ||
        (isAuto && (scene.environment || render::isBuiltinScene(options.scene))))
        return;
    if (options.environment)
        throw CliError("--studio on and --environment are two lights from around: choose one");
    if (isAuto) {
        const double lit = render::litShare(scene, aspectOf(options, scene));
        if (lit >= render::kLeastLit) return;
        scene.notes.push_back(fmt::format(
            "{}: a studio lights it; --studio off renders without.",
            lit == 0
                ? "There is no light"
                : fmt::format("The scene's own light shows {:.1f} % of what is seen", 100 * lit)));
    }
    scene.environment = render::studio(scene.camera->forward);
}

void changeEnvironment(const SceneOptions& options, render::Scene& scene) {
    if (!options.environmentRotation && !options.environmentStrength) return;
    if (!scene.environment)
        throw CliError(fmt::format(
            "{}: the scene has no light from around, which --environment and --studio on give",
            options.environmentRotation ? "--environment-rotation" : "--environment-strength"));
    scene.environment->rotation +=
        static_cast<float>(options.environmentRotation.value_or(0) * kDegree);
    scene.environment->radiance *= static_cast<float>(options.environmentStrength.value_or(1));
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

std::string sceneList() {
    std::string text;
    for (const auto& scene : render::builtinScenes()) {
        fmt::format_to(std::back_inserter(text), "{:<12} {}\n", scene.name, scene.description);
    }
    return text;
}

render::Scene loadScene(const SceneOptions& options) {
    render::Scene scene = sceneOf(options);
    if (options.environment) {
        declareInput(*options.environment);
        scene.environment = render::readEnvironment(*options.environment, &scene.notes);
    }
    changeCamera(options, scene);
    addStudio(options, scene);
    changeEnvironment(options, scene);
    if (options.position) {
        replaceNote(scene.notes, render::kNoCameraNote, "");
    } else if (options.lookAt || options.up || options.fov) {
        replaceNote(scene.notes, render::kNoCameraNote,
                    "There is no camera: it stands in front of the scene.");
    }
    return scene;
}

render::Camera orbitedCamera(const SceneOptions& options, const render::Scene& scene,
                             const render::Camera& camera, double degrees) {
    const Float3 center = options.lookAt.value_or(render::sceneBounds(scene).center());
    try {
        return render::turned(camera, center, options.up.value_or(kUp), degrees);
    } catch (const std::invalid_argument& error) {
        throw CliError(fmt::format("--up: {}", error.what()));
    }
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

void sayNotes(const render::Scene& scene) {
    for (const std::string& note : scene.notes) sayText(note);
}

} // namespace wellstrat::cli
