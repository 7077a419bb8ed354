// SPDX-License-Identifier: Apache-2.0
//
// Scenes and environment maps from files.

#include "scene_file.h"
#include "framing.h"
#include "import/import_scene.h"
#include "import/scene_child.h"
#include "memory.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <exception>
#include <filesystem>
#include <fstream>
#include <memory>
#include <stdexcept>
#include <utility>

namespace wellstrat::render {
namespace {

namespace fs = std::filesystem;

/// Of the process that reads a file: ten minutes, and the memory that there is.
ChildLimits limits() { return {600, availableMemory()}; }

/// "cannot read WHAT 'PATH': reason", the reason up to the end of its first line.
std::runtime_error readError(const char* what, const std::string& path, std::string reason) {
    reason.erase(
        std::find_if(reason.begin(), reason.end(), [](unsigned char c) { return std::iscntrl(c); }),
        reason.end());
    return std::runtime_error(fmt::format("cannot read {} '{}': {}", what, path,
                                          reason.empty() ? "not in a known format" : reason));
}

void requireFile(const std::string& path) {
    if (fs::is_directory(path)) throw std::runtime_error("it is a folder");
    if (!fs::exists(path)) throw std::runtime_error("no such file");
    if (!fs::is_regular_file(path)) throw std::runtime_error("it is no ordinary file");
    if (!std::ifstream(path)) throw std::runtime_error("it may not be read");
}

/// Calls `read` and turns what it throws into a `readError`.
template <typename Read>
auto readNamed(const char* what, const std::string& path, Read read) {
    try {
        requireFile(path);
        return read();
    } catch (const std::bad_alloc&) {
        throw readError(what, path, "there is not enough memory");
    } catch (const std::exception& error) {
        throw readError(what, path, error.what());
    }
}

/// A scene of nothing but an environment map.
Scene environmentScene(const std::string& path) {
    Scene scene;
    ReplacedPixels replaced;
    scene.environment.emplace().map = std::make_shared<const Texture>(
        readTexture(path, Encoding::sRgb, Channels::colors, &replaced));
    if (replaced.notFinite > 0)
        scene.notes.push_back(fmt::format(
            "{} pixels of the environment map are infinite or no numbers: they get the largest "
            "value that is neither, {:g}.",
            replaced.notFinite, replaced.largestFinite));
    if (replaced.outOfRange > 0)
        scene.notes.push_back(fmt::format(
            "{} pixels of the environment map are negative or above 1e9: they get the nearest "
            "value between.",
            replaced.outOfRange));
    return scene;
}

/// "'a', 'b'", at most the first ten.
std::string namesOf(const std::vector<NamedCamera>& cameras) {
    constexpr std::size_t kMost = 10;
    std::string names;
    for (std::size_t i = 0; i < std::min(cameras.size(), kMost); ++i)
        names += fmt::format("{}'{}'", i == 0 ? "" : ", ", cameras[i].name);
    return cameras.size() > kMost ? names + ", ..." : names;
}

void chooseCamera(const CameraChoice& choice, Scene& scene) {
    std::vector<NamedCamera> cameras = scene.cameras;
    if (choice.name) {
        const auto hasOtherName = [&](const NamedCamera& camera) {
            return camera.name != *choice.name && camera.otherName != *choice.name;
        };
        cameras.erase(std::remove_if(cameras.begin(), cameras.end(), hasOtherName), cameras.end());
    }
    const std::size_t number = choice.number.value_or(1);
    if (number >= 1 && number <= cameras.size()) {
        scene.camera = cameras[number - 1].camera;
        scene.aspect = cameras[number - 1].aspect;
    } else if (choice.name || choice.number) {
        throw std::runtime_error(scene.cameras.empty()
                                     ? "it has no cameras"
                                     : fmt::format("it has no such camera, only {}: {}",
                                                   scene.cameras.size(), namesOf(scene.cameras)));
    }
    if (cameras.size() > 1 && !choice.number)
        scene.notes.push_back(fmt::format("There are {} cameras, {}: the first is used.",
                                          cameras.size(), namesOf(cameras)));
}

} // namespace

Scene readScene(const std::string& path, const CameraChoice& camera) {
    return readNamed("scene", path, [&] {
        Scene scene = makeInChild([&] { return importScene(path); }, limits());
        chooseCamera(camera, scene);
        addMissingCamera(scene);
        return scene;
    });
}

Environment readEnvironment(const std::string& path, std::vector<std::string>* notes) {
    return readNamed("environment map", path, [&] {
        const Scene scene = makeInChild([&] { return environmentScene(path); }, limits());
        if (notes) notes->insert(notes->end(), scene.notes.begin(), scene.notes.end());
        return scene.environment.value();
    });
}

} // namespace wellstrat::render
