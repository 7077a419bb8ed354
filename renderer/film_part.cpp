// SPDX-License-Identifier: Apache-2.0

#include "film_part.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace wellstrat::render {
namespace {

bool isComplete(const SampleRange& range) { return range.counts.empty(); }

void dropCountsIfComplete(SampleRange& range) {
    const uint32_t all = range.end - range.begin;
    if (std::all_of(range.counts.begin(), range.counts.end(),
                    [all](uint32_t count) { return count == all; })) {
        range.counts.clear();
    }
}

/// Appends `range`, which begins where the last one ends or later.
void append(std::vector<SampleRange>& ranges, SampleRange range) {
    if (ranges.empty() || ranges.back().end != range.begin || !isComplete(ranges.back())) {
        ranges.push_back(std::move(range));
        return;
    }
    SampleRange& last = ranges.back();
    last.counts = std::move(range.counts);
    for (uint32_t& count : last.counts) count += last.end - last.begin;
    last.end = range.end;
}

/// The ranges of both, sorted and joined.
std::vector<SampleRange> unionOf(const std::vector<SampleRange>& a,
                                 const std::vector<SampleRange>& b) {
    std::vector<const SampleRange*> sorted;
    for (const auto* ranges : {&a, &b}) {
        for (const SampleRange& range : *ranges) sorted.push_back(&range);
    }
    std::sort(sorted.begin(), sorted.end(), [](const SampleRange* left, const SampleRange* right) {
        return left->begin < right->begin;
    });
    std::vector<SampleRange> all;
    for (const SampleRange* range : sorted) {
        if (!all.empty() && range->begin < all.back().end) {
            throw std::invalid_argument(fmt::format("both have samples {}:{}", range->begin,
                                                    std::min(range->end, all.back().end)));
        }
        append(all, *range);
    }
    return all;
}

} // namespace

FilmPart makePart(Film film, uint32_t begin, uint32_t end,
                  std::map<std::string, std::string> settings) {
    SampleRange range{begin, end, {}};
    range.counts.reserve(film.pixels().size());
    for (const PixelSums& sums : film.pixels()) range.counts.push_back(sums.count);
    dropCountsIfComplete(range);
    return {std::move(film), {std::move(range)}, std::move(settings)};
}

void addPart(FilmPart& part, const FilmPart& other) {
    const Film &a = part.film, &b = other.film;
    if (a.width() != b.width() || a.height() != b.height()) {
        throw std::invalid_argument(fmt::format("one has {}x{} pixels, the other {}x{}", a.width(),
                                                a.height(), b.width(), b.height()));
    }
    const std::string difference = differingSetting(part.settings, other.settings);
    if (!difference.empty()) {
        const auto valueOf = [&difference](const FilmPart& of) {
            const auto at = of.settings.find(difference);
            return at == of.settings.end() ? std::string("not given") : at->second;
        };
        throw std::invalid_argument(
            fmt::format("they differ in: {} ({}, {})", difference, valueOf(part), valueOf(other)));
    }
    std::vector<SampleRange> ranges = unionOf(part.ranges, other.ranges);
    part.film.add(other.film);
    part.ranges = std::move(ranges);
    part.firstSample = std::min(part.firstSample, other.firstSample);
}

std::string missingSamples(const FilmPart& part) {
    std::string text;
    const auto say = [&text](const char* what, uint32_t begin, uint32_t end) {
        text += fmt::format("{}{} {}:{}", text.empty() ? "" : ", ", what, begin, end);
    };
    uint32_t next = part.firstSample;
    for (const SampleRange& range : part.ranges) {
        if (range.begin > next) say("samples", next, range.begin);
        next = range.end;
        if (isComplete(range)) continue;
        const uint32_t least = *std::min_element(range.counts.begin(), range.counts.end());
        say("some samples of", range.begin + least, range.end);
    }
    return text;
}

std::string differingSetting(const std::map<std::string, std::string>& a,
                             const std::map<std::string, std::string>& b) {
    const auto missesIn = [](const auto& entry, const auto& other) {
        const auto at = other.find(entry.first);
        return at == other.end() || at->second != entry.second;
    };
    for (const auto& entry : a) {
        if (missesIn(entry, b)) return entry.first;
    }
    for (const auto& entry : b) {
        if (missesIn(entry, a)) return entry.first;
    }
    return "";
}

} // namespace wellstrat::render
