// SPDX-License-Identifier: Apache-2.0
//
// What the built-in scenes are made of.

#include "parts.h"

#include <memory>
#include <utility>

namespace wellstrat::render {

uint32_t addMaterial(Scene& scene, const Material& material) {
    scene.materials.push_back(material);
    return static_cast<uint32_t>(scene.materials.size() - 1);
}

Material lambertian(Float3 color) {
    Material material;
    material.baseColor = color;
    material.specularF0 = 0;
    return material;
}

Material emitter(Float3 radiance) {
    Material material = lambertian(Float3(0.0f));
    material.emission = radiance;
    return material;
}

void addQuads(Scene& scene, const std::vector<Quad>& quads, uint32_t material) {
    Mesh mesh;
    mesh.material = material;
    for (const Quad& quad : quads) {
        const auto first = static_cast<uint32_t>(mesh.positions.size());
        mesh.positions.insert(mesh.positions.end(), quad.begin(), quad.end());
        mesh.uvs.insert(mesh.uvs.end(), {{0, 0}, {1, 0}, {1, 1}, {0, 1}});
        mesh.triangles.push_back({first, first + 1, first + 2});
        mesh.triangles.push_back({first, first + 2, first + 3});
    }
    scene.meshes.push_back(std::move(mesh));
}

Quad rectangle(Float3 center, Float3 u, Float3 v) {
    return {center - u - v, center + u - v, center + u + v, center - u + v};
}

std::vector<Quad> box(Float3 center, Float3 u, Float3 v, Float3 w) {
    return {rectangle(center + u, v, w), rectangle(center - u, w, v), rectangle(center + v, w, u),
            rectangle(center - v, u, w), rectangle(center + w, u, v), rectangle(center - w, v, u)};
}

TexturePtr checkerboard(unsigned cells, unsigned size, Float3 even, Float3 odd) {
    const unsigned width = cells * size;
    std::vector<Float3> pixels;
    pixels.reserve(std::size_t{width} * width);
    for (unsigned y = 0; y < width; ++y)
        for (unsigned x = 0; x < width; ++x)
            pixels.push_back((x / size + y / size) % 2 == 0 ? even : odd);
    return std::make_shared<const Texture>(width, width, std::move(pixels));
}

} // namespace wellstrat::render
