// SPDX-License-Identifier: Apache-2.0

#include "materials.h"
#include "../material_numbers.h"

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

namespace wellstrat::render {
namespace {

/// Where MTL looks a texture up, in coordinates whose v goes down: v' = 1 - (scale (1 - v) +
/// offset).
UvTransform transformOf(const MtlMap& map) {
    return {{map.scale.x, 0}, {0, map.scale.y}, {map.offset.x, 1 - map.scale.y - map.offset.y}};
}

bool isFinite(const MtlMap& map) {
    return std::isfinite(map.scale.x + map.scale.y + map.offset.x + map.offset.y);
}

/// One picture of two grays: the first in green, the second in blue, the larger size of both.
TexturePtr combined(const Texture& green, const Texture& blue) {
    const unsigned width = std::max(green.width(), blue.width());
    const unsigned height = std::max(green.height(), blue.height());
    std::vector<Float3> pixels;
    for (unsigned y = 0; y < height; ++y) {
        for (unsigned x = 0; x < width; ++x) {
            const Float2 middle((static_cast<float>(x) + 0.5f) / static_cast<float>(width),
                                (static_cast<float>(y) + 0.5f) / static_cast<float>(height));
            const TextureSampling sampling{Wrap::clamp, Wrap::clamp};
            pixels.emplace_back(1.0f, green.lookup(middle, sampling).x,
                                blue.lookup(middle, sampling).x);
        }
    }
    return std::make_shared<const Texture>(width, height, std::move(pixels));
}

class MaterialReader {
public:
    MaterialReader(const MtlMaterial& source, FileTextures& textures, Notes& notes)
        : source_(source), textures_(textures), notes_(notes) {}

    Material read() {
        const bool hasMap = !source_.diffuseMap.file.empty();
        material_.baseColor = inUnitRange(
            source_.diffuse.value_or(hasMap ? Float3(1.0f) : material_.baseColor), notes_);
        material_.baseColorTexture = texture(source_.diffuseMap, TextureUse::reflectance);
        const float passing = passingPart();
        if (source_.roughness || source_.metallic || !source_.roughnessMap.file.empty() ||
            !source_.metallicMap.file.empty())
            readMetallicRoughness();
        else if (passing > 0.0f)
            material_.roughness = 0;
        else
            makePhong(material_, inUnitRange(source_.specular.value_or(Float3(0.0f)), notes_),
                      source_.phongExponent.value_or(0.0f), hasMap);
        readEmission();
        if (passing > 0.0f)
            readPassing(passing);
        else
            readOpacity();
        material_.normalTexture = texture(source_.normalMap, TextureUse::data);
        material_.normalScale = source_.normalMap.bumpFactor;
        material_.doubleSided = true;
        return std::move(material_);
    }

private:
    /// "Refraction on", in the names of the models.
    bool refracts() const { return source_.illumination == 6 || source_.illumination == 7; }

    /// Which part of the light passes, by the models of glass (4, 9) and of refraction, whose
    /// equations do not know "d".
    float passingPart() {
        const bool isGlass = source_.illumination == 4 || source_.illumination == 9;
        const Float3 filter = source_.filter.value_or(Float3(1.0f));
        const float passing = 1.0f - clamp01(source_.opacity.value_or(1.0f));
        if (source_.opacityMap.file.empty() && !isBlack(filter)) {
            if (refracts()) return passing > 0.0f ? passing : 1.0f;
            if (isGlass && passing > 0.0f) return passing;
        }
        if (!isBlack(filter) && !(filter == Float3(1.0f)))
            notes_.add(
                "'Tf' of materials that let no light pass, by 'illum' and 'd', is left out.");
        return 0;
    }

    /// The rest of the light meets the color of the surface. Ours have one color: that of both
    /// parts together, divided by their luminance, which is exact for grays and for parts of 1.
    void readPassing(float part) {
        const Float3 passing = inUnitRange(source_.filter.value_or(Float3(1.0f)), notes_) * part;
        const Float3 all = passing + material_.baseColor * (1.0f - part);
        material_.baseColor = all;
        material_.transmission = luminance(passing) / luminance(all);
        material_.isSolid = refracts();
        const float ior = source_.indexOfRefraction.value_or(material_.ior);
        material_.ior = std::max(ior, 1.0f);
        if (!(ior >= 1.0f)) notes_.add("Indices of refraction below 1 count as 1.");
    }

    /// A factor that was not said is 1 where there is a picture.
    void readMetallicRoughness() {
        TextureMap roughness = texture(source_.roughnessMap, TextureUse::data);
        TextureMap metallic = texture(source_.metallicMap, TextureUse::data);
        material_.roughness = inUnitRange(source_.roughness.value_or(1.0f), notes_);
        material_.metallic = inUnitRange(source_.metallic.value_or(metallic ? 1.0f : 0.0f), notes_);
        if (source_.indexOfRefraction.value_or(0.0f) > 0.0f)
            material_.specularF0 = reflectanceOf(*source_.indexOfRefraction);
        if (!roughness && !metallic) return;
        const Texture white(1, 1, {Float3(1.0f)});
        TextureMap map = roughness ? roughness : metallic;
        map.texture =
            combined(roughness ? *roughness.texture : white, metallic ? *metallic.texture : white);
        if (roughness && metallic && !isSame(source_.roughnessMap, source_.metallicMap))
            notes_.add("Options of 'map_Pm' that are not those of 'map_Pr' are left out.");
        material_.metallicRoughnessTexture = std::move(map);
    }

    static bool isSame(const MtlMap& a, const MtlMap& b) {
        return a.scale == b.scale && a.offset == b.offset && a.isClamped == b.isClamped;
    }

    void readEmission() {
        const bool hasMap = !source_.emissionMap.file.empty();
        material_.emission =
            notNegative(source_.emission.value_or(Float3(hasMap ? 1.0f : 0.0f)), notes_);
        material_.emissionTexture = texture(source_.emissionMap, TextureUse::emission);
    }

    void readOpacity() {
        material_.opacity = inUnitRange(source_.opacity.value_or(1.0f), notes_);
        material_.opacityTexture = texture(source_.opacityMap, TextureUse::coverage);
        if (material_.opacity < 1.0f || material_.opacityTexture)
            material_.alpha = Material::Alpha::blend;
    }

    /// Empty if there is none, or none that can be read.
    TextureMap texture(const MtlMap& source, TextureUse use) {
        if (source.file.empty()) return {};
        TextureMap map = textures_.get(source.file, use);
        if (!map) return map;
        const Wrap wrap = source.isClamped ? Wrap::clamp : Wrap::repeat;
        map.sampling = {wrap, wrap};
        if (isFinite(source))
            map.transform = transformOf(source);
        else
            notes_.add("Texture transforms that are no numbers are left out.");
        return map;
    }

    const MtlMaterial& source_;
    FileTextures& textures_;
    Notes& notes_;
    Material material_;
};

} // namespace

Material importMaterial(const MtlMaterial& source, FileTextures& textures, Notes& notes) {
    return MaterialReader(source, textures, notes).read();
}

} // namespace wellstrat::render
