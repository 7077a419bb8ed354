// SPDX-License-Identifier: Apache-2.0

#include "materials.h"
#include "../../color.h"
#include "../material_numbers.h"
#include "values.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

namespace wellstrat::render {
namespace {

/// What the three kinds of references to textures of tinygltf have in common.
struct TextureReference {
    template <typename Info>
    explicit TextureReference(const Info& info)
        : index(info.index), texCoord(info.texCoord),
          transform(find(info.extensions, "KHR_texture_transform")) {}

    /// A member of an extension.
    TextureReference(const tinygltf::Value& extension, const char* name) {
        const tinygltf::Value* const info = find(extension, name);
        if (!info) return;
        index = indexOf(*info, "index");
        texCoord = std::max(indexOf(*info, "texCoord"), 0);
        const tinygltf::Value* const extensions = find(*info, "extensions");
        if (extensions) transform = find(*extensions, "KHR_texture_transform");
    }

    int index = -1, texCoord = 0;
    const tinygltf::Value* transform = nullptr;
};

UvTransform transformOf(const tinygltf::Value& extension) {
    const Float2 offset = float2Or(extension, "offset", {0, 0});
    const Float2 scale = float2Or(extension, "scale", {1, 1});
    const float rotation = numberOr(extension, "rotation", 0);
    const float cosine = std::cos(rotation), sine = std::sin(rotation);
    return {{scale.x * cosine, -scale.x * sine}, {scale.y * sine, scale.y * cosine}, offset};
}

bool isFinite(const UvTransform& t) {
    return std::isfinite(t.u.x + t.u.y + t.v.x + t.v.y + t.offset.x + t.offset.y);
}

/// Roughness in the green channel, from glossiness in all.
TexturePtr roughnessOf(const Texture& glossiness, float factor) {
    std::vector<Float3> pixels = glossiness.pixels();
    for (Float3& pixel : pixels) pixel = {0, 1 - factor * pixel.x, 0};
    return std::make_shared<const Texture>(glossiness.width(), glossiness.height(),
                                           std::move(pixels));
}

class MaterialReader {
public:
    MaterialReader(const tinygltf::Material& source, GltfTextures& textures, Notes& notes)
        : source_(source), textures_(textures), notes_(notes) {}

    GltfMaterial read() {
        material_.doubleSided = source_.doubleSided;
        if (const auto* glossy = extension("KHR_materials_pbrSpecularGlossiness"))
            readSpecularGlossiness(*glossy);
        else
            readMetallicRoughness();
        readEmission();
        readNormals();
        if (extension("KHR_materials_unlit")) makeUnlit();
        if (result_.uvSets[0] < 0) result_.uvSets[0] = 0; // the usual one
        return result_;
    }

private:
    const tinygltf::Value* extension(const char* name) const {
        return find(source_.extensions, name);
    }

    template <typename T>
    T inUnitRange(T value) {
        return render::inUnitRange(value, notes_);
    }

    void readMetallicRoughness() {
        const tinygltf::PbrMetallicRoughness& pbr = source_.pbrMetallicRoughness;
        const auto& color = pbr.baseColorFactor;
        material_.baseColor =
            inUnitRange(Float3(static_cast<float>(color[0]), static_cast<float>(color[1]),
                               static_cast<float>(color[2])));
        material_.metallic = inUnitRange(static_cast<float>(pbr.metallicFactor));
        material_.roughness = inUnitRange(static_cast<float>(pbr.roughnessFactor));
        material_.baseColorTexture =
            texture(TextureReference(pbr.baseColorTexture), TextureUse::reflectance);
        material_.metallicRoughnessTexture =
            texture(TextureReference(pbr.metallicRoughnessTexture), TextureUse::data);
        readOpacity(color[3], TextureReference(pbr.baseColorTexture));
        if (const auto* ior = extension("KHR_materials_ior")) {
            material_.ior = numberOr(*ior, "ior", 1.5f);
            const float root = (material_.ior - 1) / (material_.ior + 1); // at normal incidence
            material_.specularF0 = clamp01(root * root);
        }
        if (const auto* specular = extension("KHR_materials_specular")) readSpecular(*specular);
        if (const auto* passing = extension("KHR_materials_transmission")) readPassing(*passing);
    }

    void readPassing(const tinygltf::Value& passing) {
        if (material_.ior == 0.0f) return; // the extension's name for what reflects all light
        material_.transmission = inUnitRange(numberOr(passing, "transmissionFactor", 0));
        material_.transmissionTexture = texture({passing, "transmissionTexture"}, TextureUse::data);
        const auto* const volume = extension("KHR_materials_volume");
        material_.isSolid = volume && numberOr(*volume, "thicknessFactor", 0) > 0;
        if (material_.isSolid) readAbsorption(*volume);
    }

    /// From the color that white light has after a distance.
    void readAbsorption(const tinygltf::Value& volume) {
        constexpr float kDarkest = 1e-6f, kMostAbsorption = 1e9f; // instead of infinitely much
        const Float3 color = inUnitRange(float3Or(volume, "attenuationColor", Float3(1)));
        const float distance = numberOr(volume, "attenuationDistance", 0);
        if (!(distance > 0) || !std::isfinite(distance)) return;
        for (int c = 0; c < 3; ++c)
            material_.absorption[c] =
                std::min(-std::log(std::max(color[c], kDarkest)) / distance, kMostAbsorption);
    }

    void readSpecular(const tinygltf::Value& specular) {
        material_.specularF0 *= inUnitRange(numberOr(specular, "specularFactor", 1));
        material_.specularColor = notNegative(float3Or(specular, "specularColorFactor", Float3(1)));
        material_.specularTexture = texture({specular, "specularTexture"}, TextureUse::opacity);
        material_.specularColorTexture =
            texture({specular, "specularColorTexture"}, TextureUse::reflectance);
    }

    void readSpecularGlossiness(const tinygltf::Value& glossy) {
        material_.baseColor = inUnitRange(float3Or(glossy, "diffuseFactor", Float3(1)));
        material_.metallic = 0;
        material_.specularF0 = 1;
        material_.specularColor = inUnitRange(float3Or(glossy, "specularFactor", Float3(1)));
        const float glossiness = inUnitRange(numberOr(glossy, "glossinessFactor", 1));
        material_.roughness = 1 - glossiness;
        material_.baseColorTexture = texture({glossy, "diffuseTexture"}, TextureUse::reflectance);
        const tinygltf::Value* const diffuse = find(glossy, "diffuseFactor");
        const bool hasAlpha = diffuse && diffuse->ArrayLen() == 4 && diffuse->Get(3).IsNumber();
        readOpacity(hasAlpha ? diffuse->Get(3).GetNumberAsDouble() : 1, {glossy, "diffuseTexture"});
        const TextureReference both(glossy, "specularGlossinessTexture");
        material_.specularColorTexture = texture(both, TextureUse::reflectance);
        TextureMap map = texture(both, TextureUse::opacity);
        if (!map) return;
        material_.roughness = 1;
        map.texture = roughnessOf(*map.texture, glossiness);
        material_.metallicRoughnessTexture = std::move(map);
    }

    Float3 notNegative(Float3 color) { return render::notNegative(color, notes_); }

    void readEmission() {
        const auto& factor = source_.emissiveFactor;
        Float3 emission(0.0f);
        if (factor.size() == 3)
            emission = {static_cast<float>(factor[0]), static_cast<float>(factor[1]),
                        static_cast<float>(factor[2])};
        if (const auto* strength = extension("KHR_materials_emissive_strength"))
            emission *= numberOr(*strength, "emissiveStrength", 1);
        material_.emission = notNegative(emission);
        material_.emissionTexture =
            texture(TextureReference(source_.emissiveTexture), TextureUse::emission);
    }

    void makeUnlit() {
        notes_.add("Unlit surfaces give off their color as light.");
        material_.emission = material_.baseColor;
        material_.emissionTexture = std::exchange(material_.baseColorTexture, {});
        material_.colorIsEmission = true;
        material_.baseColor = Float3(0.0f);
        material_.metallic = material_.specularF0 = 0;
        material_.metallicRoughnessTexture = {};
        material_.transmission = 0;
    }

    /// Null if there is none, or none that can be read.
    TextureMap texture(const TextureReference& reference, TextureUse use) {
        if (reference.index < 0) return {};
        TextureMap map = textures_.get(reference.index, use);
        if (!map) return map;
        int texCoord = reference.texCoord;
        if (reference.transform) {
            const UvTransform transform = transformOf(*reference.transform);
            if (isFinite(transform))
                map.transform = transform;
            else
                notes_.add("Texture transforms that are no numbers are left out.");
            const int own = indexOf(*reference.transform, "texCoord");
            if (own >= 0) texCoord = own;
        }
        map.takesSecondUv = isSecond(texCoord);
        return map;
    }

    /// Makes a set of texture coordinates the first or second, unless it is.
    bool isSecond(int texCoord) {
        auto& sets = result_.uvSets;
        for (std::size_t i = 0; i < sets.size(); ++i) {
            if (sets[i] < 0) sets[i] = texCoord;
            if (sets[i] == texCoord) return i == 1;
        }
        notes_.add(
            "Textures of one material use more than two sets of texture coordinates: the "
            "others get the first.");
        return false;
    }

    void readNormals() {
        material_.normalTexture =
            texture(TextureReference(source_.normalTexture), TextureUse::data);
        const auto scale = static_cast<float>(source_.normalTexture.scale);
        if (std::isfinite(scale)) material_.normalScale = scale;
    }

    /// Of the factor and the texture of the color.
    void readOpacity(double factor, const TextureReference& color) {
        if (source_.alphaMode != "MASK" && source_.alphaMode != "BLEND") return;
        const bool isMask = source_.alphaMode == "MASK";
        material_.alpha = isMask ? Material::Alpha::mask : Material::Alpha::blend;
        material_.opacity = inUnitRange(static_cast<float>(factor));
        material_.opacityCutoff = static_cast<float>(source_.alphaCutoff);
        material_.opacityTexture = texture(color, TextureUse::opacity);
    }

    const tinygltf::Material& source_;
    GltfTextures& textures_;
    Notes& notes_;
    GltfMaterial result_;
    Material& material_ = result_.material;
};

} // namespace

GltfMaterial importMaterial(const tinygltf::Material& source, GltfTextures& textures,
                            Notes& notes) {
    return MaterialReader(source, textures, notes).read();
}

} // namespace wellstrat::render
