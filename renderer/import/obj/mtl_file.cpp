// SPDX-License-Identifier: Apache-2.0

#include "mtl_file.h"
#include "../text_lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <string_view>
#include <utility>

namespace wellstrat::render {
namespace {

/// Statements that say nothing about what is rendered.
constexpr std::string_view kWithoutEffect[] = {"ka", "map_aat", "map_ka", "sharpness"};

/// Of textures.
struct Option {
    std::string_view name;
    std::size_t words; ///< that follow it; if `isOfNumbers`, at most so many numbers
    bool isOfNumbers;
    bool isMissed; ///< it would change pictures, and is left out
};

constexpr Option kOptions[] = {
    {"-blendu", 1, false, false},    {"-blendv", 1, false, false}, {"-bm", 1, true, false},
    {"-boost", 1, true, false},      {"-cc", 1, false, false},     {"-clamp", 1, false, false},
    {"-colorspace", 1, false, true}, {"-imfchan", 1, false, true}, {"-mm", 2, true, true},
    {"-o", 3, true, false},          {"-s", 3, true, false},       {"-t", 3, true, true},
    {"-texres", 1, true, false},     {"-type", 1, false, true},
};

std::string lowerCase(std::string_view text) {
    std::string lower(text);
    for (char& c : lower) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return lower;
}

bool isNumber(std::string_view word) { return !std::isnan(numberOf(word)); }

std::string_view withoutQuotes(std::string_view name) {
    const bool isQuoted = name.size() > 2 && name.front() == '"' && name.back() == '"';
    return isQuoted ? name.substr(1, name.size() - 2) : name;
}

class MtlParser {
public:
    MtlParser(std::string text, Notes& notes) : lines_(std::move(text)), notes_(notes) {}

    std::vector<MtlMaterial> parse() {
        while (lines_.next()) {
            const std::string what = lowerCase(lines_.words()[0]);
            if (what == "newmtl") {
                materials_.emplace_back().name = lines_.from(1);
                saidOpacity_ = false;
            } else if (!materials_.empty() && lines_.words().size() > 1) {
                readStatement(what);
            }
        }
        return std::move(materials_);
    }

private:
    void readStatement(const std::string& what) {
        MtlMaterial& material = materials_.back();
        if (what == "kd")
            material.diffuse = color();
        else if (what == "ks")
            material.specular = color();
        else if (what == "ke")
            material.emission = color();
        else if (what == "tf")
            material.filter = color();
        else if (what == "illum")
            material.illumination = number().value_or(0.0f);
        else if (what == "ns")
            material.phongExponent = number();
        else if (what == "ni")
            material.indexOfRefraction = number();
        else if (what == "pr")
            material.roughness = number();
        else if (what == "pm")
            material.metallic = number();
        else if (what == "d" || what == "tr")
            readOpacity(what == "d");
        else if (MtlMap* const map = mapOf(what))
            *map = readMap();
        else
            noteOther(what);
    }

    MtlMap* mapOf(const std::string& what) {
        MtlMaterial& material = materials_.back();
        const std::pair<std::string_view, MtlMap&> maps[] = {
            {"map_kd", material.diffuseMap},  {"map_ke", material.emissionMap},
            {"map_d", material.opacityMap},   {"map_pr", material.roughnessMap},
            {"map_pm", material.metallicMap}, {"norm", material.normalMap}};
        for (const auto& [name, map] : maps)
            if (name == what) return &map;
        return nullptr;
    }

    std::optional<float> number() {
        const double value = numberOf(lines_.words()[1]);
        if (!std::isnan(value)) return static_cast<float>(value);
        notes_.add(fmt::format("'{}' in a material library is left out: it is no number.",
                               lines_.from(0)));
        return {};
    }

    /// One number is that of all three channels.
    std::optional<Float3> color() {
        const auto& words = lines_.words();
        float value[3];
        for (std::size_t c = 0; c < 3; ++c) {
            const double number = numberOf(words[words.size() > 3 ? c + 1 : 1]);
            if (std::isnan(number)) { // "spectral FILE", "xyz X Y Z"
                notes_.add(
                    fmt::format("'{}' in a material library is left out: it is no color in "
                                "red, green and blue.",
                                lines_.from(0)));
                return {};
            }
            value[c] = static_cast<float>(number);
        }
        return Float3(value[0], value[1], value[2]);
    }

    /// Where both are given, "d" counts: the specification does not know "Tr".
    void readOpacity(bool isOpacity) {
        if (lines_.words()[1] == "-halo")
            notes_.add("'d -halo' in material libraries counts as 'd'.");
        const double value = numberOf(lines_.words().back());
        if (std::isnan(value) || (saidOpacity_ && !isOpacity)) return;
        materials_.back().opacity = static_cast<float>(isOpacity ? value : 1 - value);
        saidOpacity_ = saidOpacity_ || isOpacity;
    }

    /// Options come before the name of the file, which may have blanks and is the last.
    MtlMap readMap() {
        MtlMap map;
        std::size_t word = 1;
        while (word + 1 < lines_.words().size() && readOption(map, word)) {
        }
        map.file = withoutQuotes(lines_.from(word));
        return map;
    }

    /// Reads the option at `word`, unless that is none, and goes to what follows it.
    bool readOption(MtlMap& map, std::size_t& word) {
        const auto& words = lines_.words();
        const auto* const option =
            std::find_if(std::begin(kOptions), std::end(kOptions),
                         [&](const Option& known) { return known.name == words[word]; });
        if (option == std::end(kOptions)) return false;
        const std::size_t first = ++word;
        const std::size_t end = std::min(first + option->words, words.size() - 1);
        while (word < end && (!option->isOfNumbers || isNumber(words[word]))) ++word;

        if (option->name == "-s") setNumbers(map.scale, first, word);
        if (option->name == "-o") setNumbers(map.offset, first, word);
        if (option->name == "-bm" && word > first)
            map.bumpFactor = static_cast<float>(numberOf(words[first]));
        if (option->name == "-clamp") map.isClamped = words[first] == "on";
        if (option->isMissed)
            notes_.add(
                fmt::format("'{}' of textures in material libraries is left out.", option->name));
        return true;
    }

    /// The third number is for textures of three dimensions.
    void setNumbers(Float2& values, std::size_t first, std::size_t end) const {
        if (first < end) values.x = static_cast<float>(numberOf(lines_.words()[first]));
        if (first + 1 < end) values.y = static_cast<float>(numberOf(lines_.words()[first + 1]));
    }

    void noteOther(const std::string& what) {
        if (std::find(std::begin(kWithoutEffect), std::end(kWithoutEffect), what) !=
            std::end(kWithoutEffect))
            return;
        if (numberOf(lines_.from(1)) != 0)
            notes_.add(fmt::format("'{}' in material libraries is left out.", lines_.words()[0]));
    }

    TextLines lines_;
    Notes& notes_;
    std::vector<MtlMaterial> materials_;
    bool saidOpacity_ = false; ///< by "d"
};

} // namespace

std::vector<MtlMaterial> parseMtl(std::string text, Notes& notes) {
    return MtlParser(std::move(text), notes).parse();
}

} // namespace wellstrat::render
