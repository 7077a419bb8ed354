// SPDX-License-Identifier: Apache-2.0

#include "obj_file.h"
#include "../text_lines.h"

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <map>
#include <string_view>
#include <system_error>
#include <utility>

namespace wellstrat::render {
namespace {

class ObjParser {
public:
    explicit ObjParser(std::string text) : lines_(std::move(text)) {}

    ObjFile parse() {
        useMaterial("");
        while (lines_.next()) readStatement();
        for (ObjCorner& corner : file_.corners) {
            keepExisting(corner.position, file_.positions.size());
            keepExisting(corner.uv, file_.uvs.size());
            keepExisting(corner.normal, file_.normals.size());
        }
        if (!file_.colors.empty()) file_.colors.resize(file_.positions.size(), Float3(1.0f));
        return std::move(file_);
    }

private:
    void readStatement() {
        const std::string_view what = lines_.words()[0];
        if (what == "v")
            readVertex();
        else if (what == "vt")
            file_.uvs.emplace_back(number(1), lines_.words().size() > 2 ? number(2) : 0.0f);
        else if (what == "vn")
            file_.normals.push_back(numbers(1));
        else if (what == "f" || what == "fo") // "fo" of old versions
            readFace();
        else if (what == "usemtl")
            useMaterial(std::string(lines_.from(1)));
        else if (what == "mtllib")
            file_.libraries.emplace_back(lines_.from(1));
        else if (what == "l" || what == "p")
            ++file_.otherElements;
        else if (what == "curv" || what == "curv2" || what == "surf")
            file_.hasFreeForms = true;
    }

    /// NaN if there are not so many words.
    float number(std::size_t word) const {
        const auto& words = lines_.words();
        return static_cast<float>(numberOf(word < words.size() ? words[word] : std::string_view()));
    }

    Float3 numbers(std::size_t first) const {
        return {number(first), number(first + 1), number(first + 2)};
    }

    void readVertex() {
        if (lines_.words().size() >= 7) { // with a color, as many programs write
            file_.colors.resize(file_.positions.size(), Float3(1.0f));
            file_.colors.push_back(numbers(4));
        }
        file_.positions.push_back(numbers(1));
    }

    void readFace() {
        const auto& words = lines_.words();
        if (words.size() < 4) {
            ++file_.otherElements;
            return;
        }
        for (std::size_t i = 1; i < words.size(); ++i) file_.corners.push_back(corner(words[i]));
        file_.faces.push_back({file_.corners.size(), material_});
    }

    /// "position/uv/normal", of which the last two may be empty or left out.
    ObjCorner corner(std::string_view word) const {
        ObjCorner corner{};
        corner.position = takeIndex(word, file_.positions.size());
        corner.uv = takeIndex(word, file_.uvs.size());
        corner.normal = takeIndex(word, file_.normals.size());
        return corner;
    }

    /// Takes what is before the next slash: from 1, or, if negative, counted from the last.
    static uint32_t takeIndex(std::string_view& word, std::size_t count) {
        const std::string_view part = word.substr(0, word.find('/'));
        word.remove_prefix(std::min(part.size() + 1, word.size()));
        int64_t index = 0;
        const auto [stop, error] = std::from_chars(part.data(), part.data() + part.size(), index);
        if (error != std::errc() || stop != part.data() + part.size()) return kNoObjIndex;
        const int64_t fromZero = index < 0 ? static_cast<int64_t>(count) + index : index - 1;
        const bool isIndex = fromZero >= 0 && fromZero < int64_t{kNoObjIndex};
        return isIndex ? static_cast<uint32_t>(fromZero) : kNoObjIndex;
    }

    static void keepExisting(uint32_t& index, std::size_t count) {
        if (index >= count) index = kNoObjIndex;
    }

    void useMaterial(const std::string& name) {
        const auto [known, isNew] = materials_.try_emplace(name, file_.materials.size());
        if (isNew) file_.materials.push_back(name);
        material_ = static_cast<uint32_t>(known->second);
    }

    TextLines lines_;
    ObjFile file_;
    std::map<std::string, std::size_t> materials_;
    uint32_t material_ = 0;
};

} // namespace

ObjFile parseObj(std::string text) { return ObjParser(std::move(text)).parse(); }

} // namespace wellstrat::render
