// SPDX-License-Identifier: Apache-2.0
//
// What is rendered: plain data, filled by the built-in scenes and by scene files. World space is
// right-handed, y points up unless a scene says otherwise; colors are linear Rec. 709; lengths are
// in the scene's own unit, radiance in W / (m^2 sr).

#pragma once

#include "texture_map.h"

#include "wellstrat/vector.h"

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace wellstrat::render {

/// The metallic-roughness material of glTF 2.0. A texture multiplies the factor beside it.
/// Surfaces scatter on both sides; they emit on the side of the geometric normal, or on both if
/// `doubleSided`. Those that light passes are thin sheets, or the boundaries of solid bodies, on
/// whose outside the geometric normal is.
struct Material {
    /// What the opacity means: nothing; that there is a surface where it is not below the cutoff;
    /// or which part of the surface there is, the rest of which lets light pass straight on.
    /// Spheres are opaque.
    enum class Alpha : uint8_t { opaque, mask, blend };

    Float3 baseColor = Float3(0.8f);
    float metallic = 0;
    float roughness = 1; ///< of glTF: the alpha of GGX is its square
    Float3 emission = Float3(0.0f);
    bool doubleSided = false;
    /// 0.04 is a dielectric of index of refraction 1.5; 0 makes a non-metal an ideal Lambertian.
    float specularF0 = 0.04f;
    Float3 specularColor = Float3(1.0f); ///< multiplies `specularF0`
    TextureMap baseColorTexture;         ///< decoded from sRGB
    TextureMap metallicRoughnessTexture; ///< y (green) is roughness, z (blue) is metallic
    TextureMap emissionTexture;          ///< decoded from sRGB
    TextureMap specularColorTexture;     ///< decoded from sRGB
    TextureMap specularTexture;          ///< a gray that multiplies `specularF0`
    /// Directions (2 color - 1) whose x goes with u, y against v and z with the normal; not of
    /// spheres.
    TextureMap normalTexture;
    float normalScale = 1;     ///< multiplies its x and y
    TextureMap opacityTexture; ///< a gray that multiplies `opacity`
    float opacity = 1, opacityCutoff = 0.5f;
    Alpha alpha = Alpha::opaque;
    bool colorIsEmission = false; ///< the colors of vertices multiply the emission, too
    /// Which part of the light that a non-metal does not reflect passes through, tinted by the base
    /// color; the rest is scattered.
    float transmission = 0;
    TextureMap transmissionTexture;   ///< x (red) multiplies `transmission`
    float ior = 1.5f;                 ///< of what light passes: index of refraction, from 1 on
    bool isSolid = false;             ///< light is refracted; else it goes straight on
    Float3 absorption = Float3(0.0f); ///< in a solid body, per unit of length
};

inline bool isTextured(const Material& m) {
    return m.baseColorTexture || m.metallicRoughnessTexture || m.emissionTexture ||
           m.specularColorTexture || m.specularTexture || m.normalTexture || m.opacityTexture ||
           m.transmissionTexture;
}

/// Of a vertex: what multiplies the color and the opacity of the material.
struct VertexColor {
    Float3 color;
    float opacity;

    VertexColor operator*(float s) const { return {color * s, opacity * s}; }
    VertexColor operator+(const VertexColor& other) const {
        return {color + other.color, opacity + other.opacity};
    }
};

/// Triangles of one material. Indices are below positions.size(); the optional arrays are empty or
/// as long as `positions`.
struct Mesh {
    std::vector<Float3> positions;      ///< at the opening of the shutter
    std::vector<Float3> positionsAtEnd; ///< at its closing; empty: the mesh stands still
    std::vector<Float3> normals;        ///< for shading; empty: flat
    std::vector<Float2> uvs;
    std::vector<Float2> secondUvs;
    std::vector<VertexColor> colors;
    std::vector<std::array<uint32_t, 3>> triangles;
    uint32_t material = 0;
};

/// An exact sphere.
struct Sphere {
    Float3 center;
    float radius;
    uint32_t material;
    std::optional<Float3> centerAtEnd; ///< at the closing of the shutter
};

/// A light without extent.
struct PunctualLight {
    enum class Kind { point, spot, directional };
    Kind kind;
    Float3 position;    ///< not of directional lights
    Float3 direction;   ///< unit length, the way light goes; not of point lights
    Float3 intensity;   ///< W / sr; directional: irradiance on a plane across it, W / m^2
    float cosInner = 1; ///< of spots: full intensity inside the inner cone, none outside the
    float cosOuter = 0; ///< outer one, between them as glTF's KHR_lights_punctual says
    /// At this distance and beyond there is no light, and less than by the square of the distance
    /// before it, as glTF's KHR_lights_punctual says; not of directional lights.
    float range = std::numeric_limits<float>::infinity();
};

/// Light from infinitely far away.
struct Environment {
    Float3 radiance = Float3(1.0f); ///< multiplies the map
    /// Latitude-longitude: the first row is up (+y), the middle column -z, right of it +x.
    TexturePtr map; ///< null: constant
    /// Turns the map about +y, in radians, counterclockwise as seen from above.
    float rotation = 0;
};

/// A thin-lens camera, or one that sees along parallel lines.
struct Camera {
    Float3 position;
    Float3 forward;          ///< unit length
    Float3 up;               ///< unit length, across `forward`
    float verticalFov;       ///< radians, in (0, pi)
    float lensRadius = 0;    ///< 0: a pinhole
    float focusDistance = 1; ///< along `forward`
    /// Above 0: the camera is orthographic, and its picture so high; its field of view is unused.
    float orthographicHeight = 0;
};

/// A camera that a scene file brings.
struct NamedCamera {
    std::string name;      ///< of its place in the scene; may be empty
    std::string otherName; ///< of the camera itself, in formats where both have names
    Camera camera;
    float aspect = 1; ///< width / height that it was made for, if it says so
};

struct Scene {
    std::vector<Material> materials;
    std::vector<Mesh> meshes;
    std::vector<Sphere> spheres;
    std::vector<PunctualLight> lights;
    std::optional<Environment> environment;
    std::vector<NamedCamera> cameras; ///< all of the file
    std::optional<Camera> camera;     ///< the one that sees the picture
    bool cameraIsAutomatic = false;   ///< chosen by framing.h, for want of another
    float aspect = 1;                 ///< width / height that the scene was composed for
    /// Those that a scene file names and that were read: textures, material libraries, buffers.
    std::vector<std::string> files;
    /// What was replaced or left out of a scene file, one plain sentence each, for the user.
    std::vector<std::string> notes;
};

} // namespace wellstrat::render
