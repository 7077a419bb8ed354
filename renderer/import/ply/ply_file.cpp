// SPDX-License-Identifier: Apache-2.0

#include "ply_file.h"
#include "../../color.h"
#include "header.h"
#include "values.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

namespace wellstrat::render {
namespace {

/// The numbers of a vertex that are read, and what files call them.
enum Slot : std::size_t { x, nx = 3, u = 6, red = 8, kSlots = 11 };

constexpr std::array<std::array<std::string_view, 4>, kSlots> kSlotNames = {{
    {"x"},
    {"y"},
    {"z"},
    {"nx"},
    {"ny"},
    {"nz"},
    {"u", "s", "texture_u", "texture_s"},
    {"v", "t", "texture_v", "texture_t"},
    {"red", "r", "diffuse_red"},
    {"green", "g", "diffuse_green"},
    {"blue", "b", "diffuse_blue"},
}};

/// kSlots if there is none of this name.
std::size_t slotOf(const std::string& name) {
    const auto* const found =
        std::find_if(kSlotNames.begin(), kSlotNames.end(), [&](const auto& names) {
            return std::find(names.begin(), names.end(), name) != names.end();
        });
    return static_cast<std::size_t>(found - kSlotNames.begin());
}

double largestOf(PlyType type) {
    switch (type) {
    case PlyType::int8: return 127;
    case PlyType::uint8: return 255;
    case PlyType::int16: return 32767;
    case PlyType::uint16: return 65535;
    case PlyType::int32: return 2147483647;
    case PlyType::uint32: return 4294967295;
    default: return 1;
    }
}

bool isFloat(PlyType type) { return type == PlyType::float32 || type == PlyType::float64; }

class PlyParser {
public:
    explicit PlyParser(std::string_view file)
        : header_(parsePlyHeader(file)), values_(file.substr(header_.end), header_.format) {}

    PlyFile parse() {
        for (const PlyElement& element : header_.elements) {
            if (element.properties.empty()) continue; // any number of nothing
            if (element.name == "vertex")
                readVertices(element);
            else if (element.name == "face" || element.name == "tristrips")
                readFaces(element);
            else
                skip(element);
        }
        for (uint32_t& corner : file_.corners)
            if (corner >= file_.positions.size()) corner = kNoPlyIndex;
        if (!hasAllUvs_) file_.cornerUvs.clear();
        keepIfComplete(file_.normals); // where a second "vertex" has other properties
        keepIfComplete(file_.colors);
        keepIfComplete(file_.uvs);
        if (!hasFaces_) file_.otherElements += file_.positions.size();
        file_.texture = textureName();
        return std::move(file_);
    }

private:
    using Vertex = std::array<double, kSlots>;

    void readVertices(const PlyElement& element) {
        std::vector<std::size_t> slots; // of the properties
        std::array<const PlyProperty*, kSlots> found{};
        for (const PlyProperty& property : element.properties) {
            const std::size_t slot = property.countType ? kSlots : slotOf(property.name);
            slots.push_back(slot);
            if (slot < kSlots) found[slot] = &property;
        }
        const auto hasAll = [&](std::size_t first, std::size_t count) {
            return std::all_of(&found[first], &found[first] + count, [](auto* one) { return one; });
        };
        const bool hasPositions = hasAll(x, 3), hasNormals = hasAll(nx, 3), hasUvs = hasAll(u, 2);
        const PlyProperty* const color = hasAll(red, 3) ? found[red] : nullptr;

        file_.positions.reserve(std::min<uint64_t>(element.count, values_.most()));
        Vertex vertex{};
        for (uint64_t i = 0; i < element.count; ++i) {
            for (std::size_t k = 0; k < slots.size(); ++k) {
                if (slots[k] < kSlots)
                    vertex[slots[k]] = values_.next(element.properties[k].type);
                else
                    skip(element.properties[k]);
            }
            if (hasPositions) file_.positions.push_back(three(vertex, x));
            if (hasNormals) file_.normals.push_back(three(vertex, nx));
            if (hasUvs)
                file_.uvs.emplace_back(static_cast<float>(vertex[u]),
                                       static_cast<float>(vertex[u + 1]));
            if (color) file_.colors.push_back(colorOf(vertex, color->type));
        }
    }

    static Float3 three(const Vertex& vertex, std::size_t first) {
        return {static_cast<float>(vertex[first]), static_cast<float>(vertex[first + 1]),
                static_cast<float>(vertex[first + 2])};
    }

    static Float3 colorOf(const Vertex& vertex, PlyType type) {
        const Float3 color = three(vertex, red) / static_cast<float>(largestOf(type));
        return isFloat(type) ? color : linearFromSrgb(color);
    }

    void readFaces(const PlyElement& element) {
        hasFaces_ = true;
        for (uint64_t i = 0; i < element.count; ++i) {
            list_.clear();
            listUvs_.clear();
            for (const PlyProperty& property : element.properties) {
                if (!property.countType) {
                    file_.hasFaceColors = file_.hasFaceColors || property.name == "red";
                    values_.next(property.type);
                } else if (property.name == "vertex_indices" || property.name == "vertex_index") {
                    readList(property, list_);
                } else if (property.name == "texcoord") {
                    readList(property, listUvs_);
                } else {
                    skip(property);
                }
            }
            if (element.name == "face")
                addFace();
            else
                addStrips();
        }
    }

    void readList(const PlyProperty& property, std::vector<double>& values) {
        values.resize(values_.nextLength(*property.countType));
        for (double& value : values) value = values_.next(property.type);
    }

    void addFace() {
        if (list_.size() < 3) {
            ++file_.otherElements;
            return;
        }
        const bool hasUvs = listUvs_.size() == 2 * list_.size();
        hasAllUvs_ = hasAllUvs_ && hasUvs;
        for (std::size_t i = 0; i < list_.size(); ++i) {
            file_.corners.push_back(indexOf(list_[i]));
            if (hasAllUvs_)
                file_.cornerUvs.emplace_back(static_cast<float>(listUvs_[2 * i]),
                                             static_cast<float>(listUvs_[2 * i + 1]));
        }
        file_.faceEnds.push_back(file_.corners.size());
    }

    /// Every index after the second makes a triangle with the two before it, every other one turned
    /// round; -1 begins anew. Strips go on to other places by triangles with two equal corners.
    void addStrips() {
        hasAllUvs_ = false;
        std::size_t begin = 0;
        for (std::size_t i = 0; i < list_.size(); ++i) {
            if (list_[i] < 0) begin = i + 1;
            if (i < begin + 2) continue;
            const bool isTurned = (i - begin) % 2 == 1;
            const double a = list_[isTurned ? i - 1 : i - 2], b = list_[isTurned ? i - 2 : i - 1];
            if (a == b || b == list_[i] || a == list_[i]) continue;
            for (const double corner : {a, b, list_[i]}) file_.corners.push_back(indexOf(corner));
            file_.faceEnds.push_back(file_.corners.size());
        }
    }

    template <typename T>
    void keepIfComplete(std::vector<T>& values) const {
        if (values.size() != file_.positions.size()) values.clear();
    }

    static uint32_t indexOf(double value) {
        return value >= 0 && value < double{kNoPlyIndex} ? static_cast<uint32_t>(value)
                                                         : kNoPlyIndex;
    }

    void skip(const PlyElement& element) {
        if (element.name == "edge") file_.otherElements += element.count;
        for (uint64_t i = 0; i < element.count; ++i)
            for (const PlyProperty& property : element.properties) skip(property);
    }

    void skip(const PlyProperty& property) {
        std::size_t count = property.countType ? values_.nextLength(*property.countType) : 1;
        while (count-- > 0) values_.next(property.type);
    }

    std::string textureName() const {
        constexpr std::string_view kStart = "TextureFile ";
        for (const std::string& comment : header_.comments)
            if (comment.compare(0, kStart.size(), kStart) == 0)
                return comment.substr(kStart.size());
        return {};
    }

    PlyHeader header_;
    PlyValues values_;
    PlyFile file_;
    std::vector<double> list_, listUvs_; ///< of a face
    bool hasFaces_ = false, hasAllUvs_ = true;
};

} // namespace

PlyFile parsePly(std::string_view file) { return PlyParser(file).parse(); }

} // namespace wellstrat::render
