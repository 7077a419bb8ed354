// SPDX-License-Identifier: Apache-2.0

#include "film_file.h"

#include "image_encoder.h"
#include "memory.h"

#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <memory>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <vector>

namespace wellstrat::render {
namespace {

const std::string kPrefix = "wellstrat:";
const std::string kSamples = "samples", kFirst = "first"; ///< no settings are called so

/// The channels of an exact film: first those for the eye, then the words that are read back.
const std::vector<std::string> kColorNames{"R", "G", "B"}, kColorAndAlphaNames{"R", "G", "B", "A"};
const std::string kOpen = "open";
constexpr int kWordsOfSum = 4;

std::vector<std::string> fixedWordNames() {
    std::vector<std::string> names{"count", "invalid"};
    for (const char* sum : {"red", "green", "blue", "square"}) {
        for (int word = 0; word < kWordsOfSum; ++word) {
            names.push_back(fmt::format("sum.{}.{}", sum, word));
        }
    }
    return names;
}

std::string countName(const SampleRange& range) { return fmt::format("count.{}", range.begin); }

/// `hasOpen`: some of the samples are transparent.
std::vector<std::string> wordNames(const std::vector<SampleRange>& ranges, bool hasOpen) {
    std::vector<std::string> names = fixedWordNames();
    if (hasOpen) names.push_back(kOpen);
    for (const SampleRange& range : ranges) {
        if (!range.counts.empty()) names.push_back(countName(range));
    }
    return names;
}

uint32_t bitsOf(float value) {
    uint32_t bits;
    std::memcpy(&bits, &value, sizeof bits);
    return bits;
}

/// Visits the words of a pixel in the order of their names.
template <typename Pixel, typename Visit>
void visitWords(Pixel& sums, Visit&& visit) {
    visit(sums.count, 0);
    visit(sums.invalid, 0);
    for (auto* sum : {&sums.color[0], &sums.color[1], &sums.color[2], &sums.square}) {
        for (int word = 0; word < kWordsOfSum; ++word) visit(*sum, 32 * word);
    }
}

std::string rangesText(const std::vector<SampleRange>& ranges) {
    std::string text;
    for (const SampleRange& range : ranges) {
        text += fmt::format("{}{}:{}", text.empty() ? "" : " ", range.begin, range.end);
    }
    return text;
}

OIIO::ImageSpec specOf(const Film& film, int channels, const OIIO::TypeDesc& type) {
    return {static_cast<int>(film.width()), static_cast<int>(film.height()), channels, type};
}

/// A file being read.
class Decoder {
public:
    explicit Decoder(const std::string& path) : input_(OIIO::ImageInput::open(path)) {
        if (!input_) throw std::runtime_error(OIIO::geterror());
    }
    const OIIO::ImageSpec& spec() const { return input_->spec(); }

    /// A row of all channels in their own types.
    void read(unsigned y, std::vector<uint32_t>& row) {
        const auto line = static_cast<int>(y);
        if (!input_->read_scanlines(0, 0, line, line + 1, 0, 0, spec().nchannels,
                                    OIIO::TypeDesc::UNKNOWN, row.data())) {
            throw std::runtime_error(input_->geterror());
        }
    }

private:
    std::unique_ptr<OIIO::ImageInput> input_;
};

std::runtime_error damaged(const char* what) {
    return std::runtime_error(fmt::format("it is damaged: {}", what));
}

/// Reads a number and moves `text` behind it.
bool takeNumber(std::string_view& text, uint32_t& number) {
    const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    text.remove_prefix(static_cast<std::size_t>(stop - text.data()));
    return error == std::errc();
}

bool take(std::string_view& text, char c) {
    if (text.empty() || text[0] != c) return false;
    text.remove_prefix(1);
    return true;
}

std::vector<SampleRange> parseRanges(std::string_view text) {
    std::vector<SampleRange> ranges;
    do {
        SampleRange range{};
        const bool read =
            takeNumber(text, range.begin) && take(text, ':') && takeNumber(text, range.end);
        const uint32_t first = ranges.empty() ? 0 : ranges.back().end;
        if (!read || range.begin < first || range.begin >= range.end) {
            throw damaged("its sample ranges make no sense");
        }
        ranges.push_back(std::move(range));
    } while (take(text, ' '));
    if (!text.empty()) throw damaged("its sample ranges make no sense");
    return ranges;
}

/// The first sample of a picture that has `ranges`.
uint32_t parseFirst(std::string_view text, const std::vector<SampleRange>& ranges) {
    uint32_t first = 0;
    if (!takeNumber(text, first) || !text.empty() || first > ranges.front().begin) {
        throw damaged("its first sample makes no sense");
    }
    return first;
}

std::map<std::string, std::string> settingsOf(const OIIO::ImageSpec& spec) {
    std::map<std::string, std::string> settings;
    for (const OIIO::ParamValue& attribute : spec.extra_attribs) {
        const std::string name = attribute.name().string();
        if (name.compare(0, kPrefix.size(), kPrefix) == 0) {
            settings[name.substr(kPrefix.size())] = attribute.get_string();
        }
    }
    return settings;
}

void checkShape(const OIIO::ImageSpec& spec) {
    const auto fits = [](int size) { return size > 0 && size <= int{kMaxFilmSize}; };
    if (!fits(spec.width) || !fits(spec.height) || spec.depth != 1 || spec.x != 0 || spec.y != 0 ||
        spec.tile_width != 0) {
        throw damaged("its size makes no sense");
    }
    for (int c = 0; c < spec.nchannels; ++c) {
        if (spec.channelformat(c).size() != sizeof(uint32_t)) {
            throw damaged("a channel has another type");
        }
    }
}

/// Where the channels that have these names stand.
std::vector<std::size_t> channelsOf(const OIIO::ImageSpec& spec,
                                    const std::vector<std::string>& names) {
    std::vector<std::size_t> channels;
    for (const std::string& name : names) {
        const int channel = spec.channelindex(name);
        if (channel < 0 || spec.channelformat(channel) != OIIO::TypeDesc::UINT) {
            throw damaged("channels are missing");
        }
        channels.push_back(static_cast<std::size_t>(channel));
    }
    return channels;
}

uint64_t samplesOf(const std::vector<SampleRange>& ranges, std::size_t pixel) {
    uint64_t samples = 0;
    for (const SampleRange& range : ranges) {
        samples += range.counts.empty() ? range.end - range.begin : range.counts[pixel];
    }
    return samples;
}

void checkCounts(const FilmPart& part) {
    for (std::size_t i = 0; i < part.film.pixels().size(); ++i) {
        for (const SampleRange& range : part.ranges) {
            if (!range.counts.empty() && range.counts[i] > range.end - range.begin) {
                throw damaged("a pixel has more samples than there are");
            }
        }
        const PixelSums& sums = part.film.pixels()[i];
        if (sums.count != samplesOf(part.ranges, i) || sums.invalid > sums.count ||
            sums.open > sums.count) {
            throw damaged("its numbers of samples contradict each other");
        }
    }
}

/// The ranges that are unfinished, with room for their counts.
std::vector<SampleRange*> unfinishedRanges(const OIIO::ImageSpec& spec, FilmPart& part) {
    std::vector<SampleRange*> unfinished;
    for (SampleRange& range : part.ranges) {
        if (spec.channelindex(countName(range)) < 0) continue;
        range.counts.resize(part.film.pixels().size());
        unfinished.push_back(&range);
    }
    return unfinished;
}

} // namespace

std::string encodePart(const FilmPart& part) {
    const Film& film = part.film;
    const bool hasOpen = isTransparent(film);
    const auto& colors = hasOpen ? kColorAndAlphaNames : kColorNames;
    const std::vector<std::string> names = wordNames(part.ranges, hasOpen);
    const std::size_t channels = colors.size() + names.size();
    OIIO::ImageSpec spec = specOf(film, static_cast<int>(channels), OIIO::TypeDesc::FLOAT);
    spec.channelnames = colors;
    spec.channelnames.insert(spec.channelnames.end(), names.begin(), names.end());
    if (hasOpen) spec.alpha_channel = 3;
    spec.channelformats.assign(channels, OIIO::TypeDesc::UINT);
    std::fill_n(spec.channelformats.begin(), colors.size(), OIIO::TypeDesc::FLOAT);
    spec.attribute(kPrefix + kSamples, rangesText(part.ranges));
    if (part.firstSample > 0) {
        spec.attribute(kPrefix + kFirst, fmt::format("{}", part.firstSample));
    }
    for (const auto& [name, value] : part.settings) spec.attribute(kPrefix + name, value);

    constexpr unsigned kBand = 16; // as many rows as ZIP compresses together
    ImageEncoder encoder(".exr", spec);
    std::vector<uint32_t> band;
    for (unsigned begin = 0; begin < film.height(); begin += kBand) {
        const unsigned end = std::min(begin + kBand, film.height());
        band.clear();
        for (unsigned y = begin; y < end; ++y) {
            for (unsigned x = 0; x < film.width(); ++x) {
                const Float3 mean = film.mean(x, y);
                for (int c = 0; c < 3; ++c) band.push_back(bitsOf(mean[c]));
                if (hasOpen) band.push_back(bitsOf(film.alpha(x, y)));
                visitWords(film.pixel(x, y), [&band](auto value, int shift) {
                    band.push_back(static_cast<uint32_t>(value >> shift));
                });
                if (hasOpen) band.push_back(film.pixel(x, y).open);
                for (const SampleRange& range : part.ranges) {
                    if (range.counts.empty()) continue;
                    band.push_back(range.counts[std::size_t{y} * film.width() + x]);
                }
            }
        }
        encoder.write(begin, end, band.data());
    }
    return encoder.finish();
}

FilmPart readPart(const std::string& path) {
    Decoder decoder(path);
    const OIIO::ImageSpec& spec = decoder.spec();
    std::map<std::string, std::string> settings = settingsOf(spec);
    const auto samples = settings.extract(kSamples);
    const auto first = settings.extract(kFirst);
    if (samples.empty())
        throw std::runtime_error(
            "it has no exact sums of samples: it is no .exr file that `wellstrat render` wrote");
    checkShape(spec);
    const auto width = static_cast<unsigned>(spec.width);
    const auto height = static_cast<unsigned>(spec.height);
    requireMemory(filmMemory(width, height), fmt::format("its {}x{} pixels", width, height));

    FilmPart part{Film(width, height), parseRanges(samples.mapped()), std::move(settings)};
    if (!first.empty()) part.firstSample = parseFirst(first.mapped(), part.ranges);
    const std::vector<SampleRange*> unfinished = unfinishedRanges(spec, part);
    const bool hasOpen = spec.channelindex(kOpen) >= 0;
    const std::vector<std::size_t> channels = channelsOf(spec, wordNames(part.ranges, hasOpen));
    const auto stride = static_cast<std::size_t>(spec.nchannels);
    std::vector<uint32_t> row(width * stride);
    for (unsigned y = 0; y < height; ++y) {
        decoder.read(y, row);
        for (unsigned x = 0; x < width; ++x) {
            const uint32_t* const words = &row[x * stride];
            auto channel = channels.begin();
            visitWords(part.film.pixel(x, y), [&](auto& value, int shift) {
                value |= static_cast<std::decay_t<decltype(value)>>(words[*channel++]) << shift;
            });
            if (hasOpen) part.film.pixel(x, y).open = words[*channel++];
            for (SampleRange* range : unfinished) {
                range->counts[std::size_t{y} * width + x] = words[*channel++];
            }
        }
    }
    checkCounts(part);
    return part;
}

} // namespace wellstrat::render
