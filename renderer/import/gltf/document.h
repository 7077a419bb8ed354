// SPDX-License-Identifier: Apache-2.0
//
// A glTF file: what it says, and the bytes that it refers to.

#pragma once

#include "../files.h"
#include "../notes.h"

#include <tiny_gltf.h>

#include <cstddef>
#include <deque>
#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace wellstrat::render {

/// A picture as the file gives it: a file of its own, or bytes of one.
struct ImageSource {
    std::string name;     ///< for messages
    std::string uri;      ///< of a file; empty: see below
    int bufferView = -1;  ///< where the bytes are; -1: see below
    std::string mimeType; ///< of the bytes; may be empty
    std::string bytes;    ///< of a "data:" URI
    std::string problem;  ///< why there is none of all that; empty: there is
};

/// tinygltf 2.7.0 reads what the file says, except "buffers" and "images", which are fetched here:
/// it takes "+" in file names for a space, knows only seven types of "data:" URIs and none with
/// percent signs, looks for files in the working directory too, and refuses buffers that only
/// compressed views have use for. Indices of Draco's primitives are removed before, since it
/// refuses the accessors that the extension wants.
class GltfDocument {
public:
    /// Reads a file. Adds a note for each extension that is used and not known. Throws
    /// std::runtime_error with one line: it is no glTF 2.0, lacks some of its parts, or requires
    /// extensions that are not known.
    GltfDocument(const std::string& path, FileFinder& files, Notes& notes);
    GltfDocument(const GltfDocument&) = delete;
    GltfDocument& operator=(const GltfDocument&) = delete;

    const tinygltf::Model& model() const { return model_; }
    const std::vector<ImageSource>& images() const { return images_; }
    FileFinder& files() const { return files_; }

    /// The bytes of a range of a buffer. Throws std::runtime_error if it has not so many; `what`
    /// is for the message.
    std::string_view bytes(int buffer, std::size_t offset, std::size_t length,
                           const std::string& what) const;

    /// The bytes of a buffer view, decompressed if they are compressed. Throws std::runtime_error.
    /// Valid as long as the document.
    std::string_view bufferView(int view) const;

private:
    tinygltf::Model model_;
    FileFinder& files_;
    std::deque<std::string> storage_;       ///< what buffers_ points into
    std::vector<std::string_view> buffers_; ///< empty: only compressed views have use for it
    std::vector<ImageSource> images_;
    mutable std::map<int, std::string> decompressed_;
};

/// The element of this index. Throws std::runtime_error if there is none; `what` names the list.
template <typename T>
const T& at(const std::vector<T>& list, int index, const char* what) {
    if (index < 0 || static_cast<std::size_t>(index) >= list.size())
        throw std::runtime_error(std::string("refers to ") + what + " " + std::to_string(index) +
                                 ", of which there are " + std::to_string(list.size()));
    return list[static_cast<std::size_t>(index)];
}

} // namespace wellstrat::render
