// SPDX-License-Identifier: Apache-2.0

#include "text_points.h"

#include "text_fields.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace wellstrat::cli {
namespace {

constexpr std::size_t kMaxLine = 4096;

/// A line of the file.
struct Line {
    std::string text;
    std::size_t number = 0;
};

class TextPoints {
public:
    TextPoints(ByteSource& source, PointReader& reader) : source_(source), reader_(reader) {}

    void read() {
        skipByteOrderMark();
        for (Line line{{}, 1}; source_.readLine(line.text, kMaxLine); ++line.number) {
            if (line.text.size() == kMaxLine) {
                reader_.fail("line {} is longer than {} bytes; accepted is one point a line",
                             line.number, kMaxLine - 1);
            }
            readLine(line);
        }
        addUndecided();
        if (header_ && reader_.size() == 0) failNoNumber(*header_, names_.front());
        reader_.endSet([] { return "the end"; });
    }

private:
    /// The column before the coordinates.
    enum class Index { none, maybe, counted, named };

    void skipByteOrderMark() {
        if (source_.startsWith("\xff\xfe") || source_.startsWith("\xfe\xff")) {
            reader_.fail("is UTF-16 text; accepted are ASCII and UTF-8");
        }
        source_.skip("\xef\xbb\xbf");
    }

    void readLine(const Line& line) {
        const std::string_view text = trimmed(line.text);
        if (text == "#") {
            addUndecided();
            reader_.endSet([&] { return placeOf(line); });
            first_ = true;
            return;
        }
        const std::string_view content = std::string_view(line.text).substr(0, line.text.find('#'));
        if (trimmed(content).empty()) return;
        if (!header_ && reader_.dims() == 0) {
            names_ = namesIn(content);
            if (areNames(names_)) {
                header_ = line;
                return;
            }
        }
        if (!splitFields(content, fields_)) {
            reader_.fail("line {}: a value is missing beside a comma or semicolon", line.number);
        }
        addFields(line);
    }

    void addFields(const Line& line) {
        if (header_ && reader_.dims() == 0 && index_ != Index::maybe) index_ = firstIndex(line);
        if (index_ == Index::maybe) {
            if (!undecided_) {
                undecided_ = line;
                return;
            }
            index_ = countOf(fields_.front()) == 1 ? Index::counted : Index::none;
            const std::vector<std::string> fields = fields_;
            addUndecided();
            fields_ = fields;
        }
        addRow(line);
    }

    /// What the first line after the names says about an index.
    Index firstIndex(const Line& line) const {
        const std::size_t names = names_.size(), columns = fields_.size();
        const std::optional<std::size_t> count = countOf(fields_.front());
        if (columns == names + 1 && isQuoted(line.text)) return Index::named;
        if (columns == names + 1 && count) return Index::counted;
        if (columns != names) {
            reader_.fail("line {} has {} names, line {} has {} values", header_->number, names,
                         line.number, columns);
        }
        if (names_.front().empty()) return Index::named;
        if (columns == 1 || !count || *count > 1) return Index::none;
        // A coordinate may be 0, but not 1.
        return *count == 1 ? Index::counted : Index::maybe;
    }

    /// A line that may begin with an index, when no further one tells whether.
    void addUndecided() {
        if (!undecided_) return;
        const Line line = *std::exchange(undecided_, std::nullopt);
        if (index_ == Index::maybe) index_ = Index::none;
        splitFields(std::string_view(line.text).substr(0, line.text.find('#')), fields_);
        addRow(line);
    }

    void addRow(const Line& line) {
        const std::size_t skipped = index_ == Index::counted || index_ == Index::named ? 1 : 0;
        if (index_ == Index::counted) checkCount(line);
        const std::size_t columns = fields_.size() - skipped;
        if (reader_.dims() == 0) reader_.setDims(columns);
        if (columns != reader_.dims()) {
            reader_.fail("line {} has {} values, the lines before have {}", line.number,
                         fields_.size(), reader_.dims() + skipped);
        }
        for (std::size_t k = skipped; k < fields_.size(); ++k) {
            const std::optional<double> value = numberOf(fields_[k]);
            if (!value) failNoNumber(line, fields_[k]);
            reader_.add(*value, [&] { return placeOf(line); });
        }
    }

    /// Rows count on, or anew in each set.
    void checkCount(const Line& line) {
        const std::optional<std::size_t> count = countOf(fields_.front());
        if (!count || (*count != next_ && !(first_ && *count <= 1))) {
            reader_.fail("line {}: '{}' in the column that counts the rows, where {} is expected",
                         line.number, shown(fields_.front()), next_);
        }
        first_ = false;
        next_ = *count + 1;
    }

    static std::string placeOf(const Line& line) { return fmt::format("line {}", line.number); }

    [[noreturn]] void failNoNumber(const Line& line, const std::string& field) const {
        reader_.fail(
            "line {}: '{}' is no number; accepted are points, one a line, their "
            "coordinates separated by commas or blanks, after a line of names if there is "
            "one, and comments after #",
            line.number, shown(field));
    }

    ByteSource& source_;
    PointReader& reader_;
    std::vector<std::string> names_, fields_;
    std::optional<Line> header_;
    std::optional<Line> undecided_; ///< the first line, as long as index_ is `maybe`
    Index index_ = Index::none;
    bool first_ = true;    ///< of its set: the next row
    std::size_t next_ = 0; ///< the count of the next row
};

} // namespace

PatternTable readTextPoints(ByteSource& source, std::optional<double> scale) {
    PointReader reader(source);
    reader.setScale(scale.value_or(1));
    TextPoints(source, reader).read();
    return reader.finish();
}

} // namespace wellstrat::cli
