// SPDX-License-Identifier: Apache-2.0

#include "map.h"

#include "wellstrat/warp.h"

#include <cstring>
#include <tuple>

namespace python {
namespace {

using namespace wellstrat;

template <typename T>
constexpr unsigned kSize = sizeof(T) / sizeof(float);

template <typename T>
T read(const float*& in) {
    T value;
    std::memcpy(static_cast<void*>(&value), in, sizeof value);
    in += kSize<T>;
    return value;
}

template <auto kFunction, typename Result, typename... Arguments>
void applyRow(const float* in, float* out) {
    // Braces, so that arguments are read from the first to the last.
    const std::tuple<Arguments...> arguments{read<Arguments>(in)...};
    const Result result = std::apply(kFunction, arguments);
    std::memcpy(out, &result, sizeof result);
}

template <auto kFunction, typename Result, typename... Arguments>
constexpr Map makeMap(const char* name, Result (*)(Arguments...)) {
    return {name, (kSize<Arguments> + ...), kSize<Result>,
            applyRow<kFunction, Result, Arguments...>};
}

template <auto kFunction>
constexpr Map map(const char* name) {
    return makeMap<kFunction>(name, kFunction);
}

constexpr auto kSquareToTriangle = static_cast<Float2 (*)(Float2)>(squareToTriangle);

constexpr Map kMaps[] = {
    map<squareToDiskPolar>("square_to_disk_polar"),
    map<diskToSquarePolar>("disk_to_square_polar"),
    map<squareToDiskConcentric>("square_to_disk_concentric"),
    map<diskToSquareConcentric>("disk_to_square_concentric"),
    map<kSquareToTriangle>("square_to_triangle"),
    map<triangleToSquare>("triangle_to_square"),
    map<squareToCylinder>("square_to_cylinder"),
    map<cylinderToSquare>("cylinder_to_square"),
    map<squareToSphere>("square_to_sphere"),
    map<sphereToSquare>("sphere_to_square"),
    map<squareToHemisphere>("square_to_hemisphere"),
    map<hemisphereToSquare>("hemisphere_to_square"),
    map<squareToCone>("square_to_cone"),
    map<coneToSquare>("cone_to_square"),
    map<squareToHemisphereCosine>("square_to_hemisphere_cosine"),
    map<hemisphereCosineToSquare>("hemisphere_cosine_to_square"),
    map<hemisphereCosinePdf>("hemisphere_cosine_pdf"),
    map<squareToPowerCosine>("square_to_power_cosine"),
    map<powerCosineToSquare>("power_cosine_to_square"),
    map<powerCosinePdf>("power_cosine_pdf"),
    map<squareToGgxVisibleNormal>("square_to_ggx_visible_normal"),
    map<ggxVisibleNormalToSquare>("ggx_visible_normal_to_square"),
    map<ggxVisibleNormalPdf>("ggx_visible_normal_pdf"),
};

} // namespace

const Map* findMap(const char* name) {
    for (const Map& map : kMaps) {
        if (std::strcmp(map.name, name) == 0) return &map;
    }
    return nullptr;
}

} // namespace python
