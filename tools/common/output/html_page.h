// SPDX-License-Identifier: Apache-2.0
//
// Self-contained HTML pages: headings, text, tables and pictures in one file that needs neither
// scripts nor a network.
//
//     HtmlPage page("Report", "Ours is better.", "What this page shows.");
//     page.section("Points");
//     page.figure({{{"256 points", bytesOfSvgOrPng}}, "Each square holds one point."});
//     HtmlTable table{"Errors.", {"generator", "RMSE"}, {{"ours", "1e-3"}, {"random", "4e-2"}}};
//     table.markBest(1, {0, 1}, Best::least);
//     page.table(table);
//     file.write(page.finish());
//
// All text is plain UTF-8, escaped here, but for `code`, which stands between backticks.

#pragma once

#include <cstddef>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace wellstrat::cli {

/// `text` with &, <, >, " and ' replaced, as content and attribute values need it.
std::string htmlText(std::string_view text);

struct HtmlPicture {
    std::string description; ///< for those who cannot see it
    std::string bytes;       ///< of a PNG or SVG file
    std::string label = {};  ///< short, shown in the picture's corner; empty for none
};

/// Pictures over one caption, up to `columns`, 1 to 4, of them beside each other where the window
/// is wide enough.
struct HtmlFigure {
    std::vector<HtmlPicture> pictures;
    std::string caption;
    unsigned columns = 1;
};

/// Which numbers are better.
enum class Best { least, most };

/// Columns of numbers, where each cell starts with a digit or a sign or is a dash, are aligned to
/// the right. The first column names the rows.
struct HtmlTable {
    std::string caption;
    std::vector<std::string> header;
    std::vector<std::vector<std::string>> rows; ///< each with a cell for each of the header
    std::set<std::pair<std::size_t, std::size_t>> best = {}; ///< rows and columns of marked cells

    /// Marks those of the cells of a column in these rows that begin with the best number, if they
    /// are not all the same. Cells without a number do not count.
    void markBest(std::size_t column, const std::vector<std::size_t>& ofRows, Best which);
    /// Of all rows.
    void markBest(std::size_t column, Best which);
};

class HtmlPage {
public:
    /// Under the title stand the verdict, one sentence that says what was found, and `lead`, which
    /// says what was done. Contents follow, with a link to each section.
    HtmlPage(std::string title, std::string verdict, std::string lead);

    void section(std::string_view title);
    void subsection(std::string_view title);
    void paragraph(std::string_view text);
    /// Lines as they are, such as commands.
    void code(std::string_view text);
    void table(const HtmlTable& table);
    /// Throws CliError for a picture that is neither PNG nor SVG.
    void figure(const HtmlFigure& figure);

    /// The file.
    std::string finish() const;

private:
    std::string title_, verdict_, lead_;
    std::vector<std::string> sections_;
    std::string body_;
};

} // namespace wellstrat::cli
