// SPDX-License-Identifier: Apache-2.0
//
// Collects the points of a file, whatever its format.

#pragma once

#include "byte_source.h"
#include "common/command_line/errors.h"
#include "point_table.h"
#include "wellstrat/analysis/unit_points.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace wellstrat::cli {

/// Takes the values of one source in the order of the points, and complains in its name.
class PointReader {
public:
    explicit PointReader(const ByteSource& source) : source_(source) {}

    template <typename... T>
    [[noreturn]] void fail(fmt::format_string<T...> format, T&&... values) const {
        throw CliError(fmt::format("'{}': {}", source_.name(),
                                   fmt::format(format, std::forward<T>(values)...)));
    }

    /// To be called before the first value.
    void setDims(std::size_t dims) {
        if (dims == 0 || dims > UnitPoints::kMaxDimensions) {
            fail("the points have {} dimensions; accepted are 1 to {}", dims,
                 UnitPoints::kMaxDimensions);
        }
        table_.points.dims = static_cast<unsigned>(dims);
        maxSetPoints_ = std::min(kMaxFilePoints, kMaxFileNumbers / dims);
    }

    /// What values are multiplied by; 1 if not called.
    void setScale(double scale) { scale_ = scale; }

    /// Fails unless there is room for so many points.
    void requireRoom(uint64_t sets, uint64_t count) const {
        if (count > maxSetPoints_) failTooMany(maxSetPoints_);
        const uint64_t most = kMaxFileNumbers / dims();
        if (count > 0 && sets > most / count) failTooMany(most);
    }

    /// `place` names where the value stands, such as "line 3".
    template <class Place>
    void add(double value, const Place& place) {
        const double scaled = value * scale_;
        if (!(scaled >= 0 && scaled < 1)) fail("{}: {} is not in [0, 1)", place(), scaled);
        if (size() - setBegin_ == maxSetPoints_ * dims()) failTooMany(maxSetPoints_);
        if (size() == kMaxFileNumbers) failTooMany(kMaxFileNumbers / dims());
        table_.points.values.push_back(scaled);
    }

    /// Numbers so far, and dimensions; 0 as long as they are not known.
    std::size_t size() const { return table_.points.values.size(); }
    unsigned dims() const { return table_.points.dims; }

    /// Ends a set of points. One without any does not count.
    template <class Place>
    void endSet(const Place& place) {
        if (size() == setBegin_) return;
        const std::size_t count = (size() - setBegin_) / dims();
        if (sets_ == 0) setPoints_ = count;
        if (count != setPoints_) {
            fail("{}: set {} ends with {} points, the sets before have {}; all need as many",
                 place(), sets_ + 1, count, setPoints_);
        }
        ++sets_;
        setBegin_ = size();
    }

    /// The sets that were ended, at least one.
    PatternTable finish() {
        if (sets_ == 0) fail("holds no points");
        table_.patterns = sets_;
        return std::move(table_);
    }

private:
    [[noreturn]] void failTooMany(std::size_t most) const {
        fail("holds more than {} points, which is as many as are read", most);
    }

    const ByteSource& source_;
    PatternTable table_;
    double scale_ = 1;
    std::size_t maxSetPoints_ = kMaxFilePoints;
    std::size_t sets_ = 0, setBegin_ = 0, setPoints_ = 0;
};

} // namespace wellstrat::cli
