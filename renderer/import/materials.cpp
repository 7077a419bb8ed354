// SPDX-License-Identifier: Apache-2.0
//
// From Assimp's materials to ours.

#include "materials.h"
#include "material_numbers.h"

#include <initializer_list>
#include <optional>
#include <string>

namespace wellstrat::render {
namespace {

class MaterialReader {
public:
    MaterialReader(const aiMaterial& source, SceneTextures& textures, Notes& notes)
        : source_(source), textures_(textures), notes_(notes) {}

    ImportedMaterial read() {
        readSurface();
        readEmission();
        int twoSided = 1; // for formats that do not say
        source_.Get(AI_MATKEY_TWOSIDED, twoSided);
        result_.material.doubleSided = twoSided != 0;
        readTextures();
        noteWhatIsLeftOut();
        return result_;
    }

private:
    using Key = const char*;

    std::optional<float> number(Key key, unsigned type, unsigned index) const {
        ai_real value = 0;
        if (source_.Get(key, type, index, value) != aiReturn_SUCCESS) return {};
        return value;
    }

    std::optional<Float3> color(Key key, unsigned type, unsigned index) const {
        aiColor3D value;
        if (source_.Get(key, type, index, value) != aiReturn_SUCCESS) return {};
        return Float3(value.r, value.g, value.b);
    }

    template <typename T>
    T inUnitRange(T value) {
        return render::inUnitRange(value, notes_);
    }

    void readSurface() {
        Material& material = result_.material;
        const auto base = color(AI_MATKEY_BASE_COLOR);
        const auto diffuse = color(AI_MATKEY_COLOR_DIFFUSE);
        material.baseColor = inUnitRange(base.value_or(diffuse.value_or(material.baseColor)));
        const auto metallic = number(AI_MATKEY_METALLIC_FACTOR);
        const auto roughness = number(AI_MATKEY_ROUGHNESS_FACTOR);
        if (metallic || roughness) {
            material.metallic = inUnitRange(metallic.value_or(0.0f));
            material.roughness = inUnitRange(roughness.value_or(1.0f));
            readIndexOfRefraction();
        } else {
            readPhong();
        }
    }

    void readIndexOfRefraction() {
        const auto ior = number(AI_MATKEY_REFRACTI);
        if (ior && *ior > 0.0f) result_.material.specularF0 = reflectanceOf(*ior);
    }

    void readPhong() {
        const Float3 specular = inUnitRange(color(AI_MATKEY_COLOR_SPECULAR).value_or(Float3(0.0f)));
        makePhong(result_.material, specular, number(AI_MATKEY_SHININESS).value_or(0.0f),
                  hasTexture(aiTextureType_DIFFUSE));
    }

    void readEmission() {
        result_.material.emission =
            notNegative(color(AI_MATKEY_COLOR_EMISSIVE).value_or(Float3(0.0f)), notes_);
    }

    bool hasTexture(aiTextureType type) const { return source_.GetTextureCount(type) > 0; }

    /// The first texture of these types. All textures of a material share one set of coordinates.
    TexturePtr texture(std::initializer_list<aiTextureType> types, TextureUse use) {
        for (const aiTextureType type : types) {
            aiString name;
            unsigned uvSet = 0;
            if (source_.GetTexture(type, 0, &name, nullptr, &uvSet) != aiReturn_SUCCESS) continue;
            TexturePtr result = textures_.get(name.C_Str(), use);
            if (result && uvSet_ && *uvSet_ != uvSet)
                notes_.add(
                    "Textures of one material use different texture coordinates: all of "
                    "them get those of the first.");
            if (result && !uvSet_) uvSet_ = uvSet;
            return result;
        }
        return nullptr;
    }

    void readTextures() {
        Material& material = result_.material;
        material.baseColorTexture =
            texture({aiTextureType_BASE_COLOR, aiTextureType_DIFFUSE}, TextureUse::reflectance);
        material.metallicRoughnessTexture = texture(
            {aiTextureType_UNKNOWN, aiTextureType_METALNESS, aiTextureType_DIFFUSE_ROUGHNESS},
            TextureUse::data);
        material.emissionTexture =
            texture({aiTextureType_EMISSION_COLOR, aiTextureType_EMISSIVE}, TextureUse::emission);
        result_.uvSet = uvSet_.value_or(0);
    }

    void noteWhatIsLeftOut() {
        if (hasTexture(aiTextureType_NORMALS) || hasTexture(aiTextureType_HEIGHT))
            notes_.add("Normal and bump maps are left out.");
        if (number(AI_MATKEY_OPACITY).value_or(1.0f) < 1.0f ||
            number(AI_MATKEY_TRANSMISSION_FACTOR).value_or(0.0f) > 0.0f)
            notes_.add("Transparency is left out: all surfaces are opaque.");
    }

    const aiMaterial& source_;
    SceneTextures& textures_;
    Notes& notes_;
    ImportedMaterial result_;
    std::optional<unsigned> uvSet_;
};

} // namespace

ImportedMaterial importMaterial(const aiMaterial& source, SceneTextures& textures, Notes& notes) {
    return MaterialReader(source, textures, notes).read();
}

} // namespace wellstrat::render
