// SPDX-License-Identifier: Apache-2.0

#include "libraries.h"
#include "../text_lines.h"

#include <fmt/format.h>

#include <cstddef>
#include <filesystem>
#include <iterator>
#include <optional>
#include <set>
#include <stdexcept>
#include <utility>

namespace wellstrat::render {
namespace {

class LibraryReader {
public:
    LibraryReader(FileFinder& files, Notes& notes) : files_(files), notes_(notes) {}

    void read(const std::string& names) {
        TextLines line(names);
        if (!line.next()) return;
        const auto& words = line.words();
        for (std::size_t first = 0; first < words.size();) {
            // The longest name that is one of a file; otherwise a word.
            std::size_t count = words.size() - first;
            std::optional<std::string> path;
            for (; !path && count > 0; --count) path = find(spanned(words, first, count));
            if (path) {
                readFile(*path);
                first += count + 1;
            } else {
                notes_.add(fmt::format("The material library '{}' is left out: no such file.",
                                       words[first]));
                ++first;
            }
        }
    }

    std::vector<MtlMaterial> materials;

private:
    static std::string spanned(const std::vector<std::string_view>& words, std::size_t first,
                               std::size_t count) {
        const char* const begin = words[first].data();
        const std::string_view last = words[first + count - 1];
        return {begin, last.data() + last.size()};
    }

    std::optional<std::string> find(const std::string& name) {
        try {
            return files_.find(name);
        } catch (const std::runtime_error&) {
            return {};
        }
    }

    void readFile(const std::string& path) {
        if (!read_.insert(path).second) return;
        try {
            files_.lookIn(std::filesystem::path(path).parent_path().string()); // for its pictures
            std::vector<MtlMaterial> more = parseMtl(contentOf(path), notes_);
            materials.insert(materials.end(), std::make_move_iterator(more.begin()),
                             std::make_move_iterator(more.end()));
        } catch (const std::runtime_error& error) {
            notes_.add(
                fmt::format("The material library '{}' is left out: {}.", path, error.what()));
        }
    }

    FileFinder& files_;
    Notes& notes_;
    std::set<std::string> read_;
};

} // namespace

std::vector<MtlMaterial> readLibraries(const std::vector<std::string>& names, FileFinder& files,
                                       Notes& notes) {
    LibraryReader reader(files, notes);
    for (const std::string& name : names) reader.read(name);
    return std::move(reader.materials);
}

} // namespace wellstrat::render
