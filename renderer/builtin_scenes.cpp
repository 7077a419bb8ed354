// SPDX-License-Identifier: Apache-2.0
//
// The built-in scenes by name.

#include "builtin_scenes.h"
#include "scenes/makers.h"

#include <stdexcept>

namespace wellstrat::render {
namespace {

struct Maker {
    BuiltinSceneInfo info;
    Scene (*make)();
};

constexpr Maker kMakers[] = {
    {{"cornell", "the Cornell box, as measured: diffuse light between walls"}, cornellScene},
    {{"veach", "glossy plates of four roughnesses under lights of four sizes"}, veachScene},
    {{"lens", "depth of field and motion blur"}, lensScene},
    {{"manylights", "144 small lights of very different power"}, manyLightsScene},
    {{"spherelight", "a diffuse plane lit by a sphere, known in closed form"}, sphereLightScene},
};

const Maker* find(const std::string& name) {
    for (const Maker& maker : kMakers)
        if (name == maker.info.name) return &maker;
    return nullptr;
}

} // namespace

const std::vector<BuiltinSceneInfo>& builtinScenes() {
    static const auto all = [] {
        std::vector<BuiltinSceneInfo> infos;
        for (const Maker& maker : kMakers) infos.push_back(maker.info);
        return infos;
    }();
    return all;
}

bool isBuiltinScene(const std::string& name) { return find(name) != nullptr; }

Scene builtinScene(const std::string& name) {
    if (const Maker* maker = find(name)) return maker->make();
    std::string names;
    for (const Maker& maker : kMakers)
        names.append(names.empty() ? "" : ", ").append(maker.info.name);
    throw std::invalid_argument("no built-in scene '" + name + "'; there are: " + names);
}

} // namespace wellstrat::render
