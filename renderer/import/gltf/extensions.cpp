// SPDX-License-Identifier: Apache-2.0

#include "extensions.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <stdexcept>
#include <string_view>

namespace wellstrat::render {
namespace {

constexpr std::string_view kRead[] = {
    "EXT_mesh_gpu_instancing", "EXT_texture_webp",
    "KHR_lights_punctual",     "KHR_materials_emissive_strength",
    "KHR_materials_ior",       "KHR_materials_pbrSpecularGlossiness",
    "KHR_materials_specular",  "KHR_materials_transmission",
    "KHR_materials_unlit",     "KHR_materials_volume",
    "KHR_mesh_quantization",   "KHR_node_visibility",
    "KHR_texture_transform",
};

bool isRead(const std::string& name) {
    if (name == kDracoExtension) return kHasDraco;
    if (name == kMeshoptExtension) return kHasMeshopt;
    return std::find(std::begin(kRead), std::end(kRead), name) != std::end(kRead);
}

} // namespace

void checkExtensions(const std::vector<std::string>& used, const std::vector<std::string>& required,
                     Notes& notes) {
    std::vector<std::string> missing;
    std::copy_if(required.begin(), required.end(), std::back_inserter(missing),
                 [](const std::string& name) { return !isRead(name); });
    if (!missing.empty())
        throw std::runtime_error(
            fmt::format("it requires {}, which cannot be read", fmt::join(missing, " and ")));
    for (const std::string& name : used)
        if (!isRead(name)) notes.add(fmt::format("What {} says is left out.", name));
}

} // namespace wellstrat::render
