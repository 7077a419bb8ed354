// SPDX-License-Identifier: Apache-2.0
//
// Images that scenes refer to.

#pragma once

#include "wellstrat/vector.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace wellstrat::render {

/// What a coordinate outside [0, 1) means: the picture again, the picture mirrored every other
/// time, or the nearest pixel of its border.
enum class Wrap : uint8_t { repeat, mirror, clamp };

/// How a picture is looked up between and beyond the middles of its pixels.
struct TextureSampling {
    Wrap u = Wrap::repeat, v = Wrap::repeat;
    bool nearest = false; ///< the color of one pixel; otherwise bilinear
};

/// A picture in linear colors. Immutable, so safe in any thread.
class Texture {
public:
    /// Pixels row by row, the top row first: width * height of them, finite and not negative.
    /// Throws std::invalid_argument for another number of them, or none.
    Texture(unsigned width, unsigned height, std::vector<Float3> pixels);

    unsigned width() const { return width_; }
    unsigned height() const { return height_; }

    const std::vector<Float3>& pixels() const { return pixels_; }

    /// The color of a pixel; not checked.
    Float3 pixel(unsigned x, unsigned y) const { return pixels_[std::size_t{y} * width_ + x]; }

    /// (0, 0) is the left end of the top row, as in glTF. `uv` must be finite.
    Float3 lookup(Float2 uv, TextureSampling sampling = {}) const;

private:
    unsigned width_, height_;
    std::vector<Float3> pixels_;
};

enum class Encoding { linear, sRgb };

/// What of a picture is read: its colors as they are stored, not multiplied by alpha; its alpha as
/// a gray, which is 1 where the picture has none; or the same, which is the luminance there.
enum class Channels { colors, alpha, alphaOrGray };

/// Pixels whose values were none of light.
struct ReplacedPixels {
    uint64_t notFinite = 0;  ///< infinite, or NaN
    uint64_t outOfRange = 0; ///< others that are negative or above 1e9
    float largestFinite = 0; ///< what stands for the infinite ones
};

/// Reads a picture in any format that OpenImageIO knows, of at most 2^27 pixels. Negative values
/// become 0 and those above 1e9 become 1e9. What is infinite or NaN, as a sun too bright for the
/// numbers of its file is, becomes the largest value of the picture that is neither. `replaced` is
/// told of such pixels unless it is null. `encoding` is that of colors in integers: floats and
/// alpha are linear. Throws std::runtime_error with one line that says why the picture cannot be
/// read.
Texture readTexture(const std::string& path, Encoding encoding,
                    Channels channels = Channels::colors, ReplacedPixels* replaced = nullptr);

/// The same from the bytes of a file in memory, such as one within a .glb. `formatHint` is the
/// file name extension that it would have.
Texture readTexture(const std::vector<unsigned char>& bytes, const std::string& formatHint,
                    Encoding encoding, Channels channels = Channels::colors);

/// From now on this process reads pictures without helping threads. For a copy of a process, which
/// lacks the threads that libraries believe to have.
void readTexturesInOneThread();

} // namespace wellstrat::render
