// SPDX-License-Identifier: Apache-2.0
//
// Self-contained HTML pages: headings, text, tables and pictures in one file that needs neither
// scripts nor a network.
//
//     HtmlPage page("Report", "What this page shows.");
//     page.section("Points");
//     page.figure({{{"256 points of pmj", bytesOfSvgOrPng}}, "Each square holds one point."});
//     page.table({"Errors.", {"generator", "RMSE"}, {{"pmj", "1.2e-3"}, {"random", "4.5e-2"}}});
//     file.write(page.finish());
//
// All text is plain UTF-8, escaped here, but for `code`, which stands between backticks.

#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace wellstrat::cli {

/// `text` with &, <, >, " and ' replaced, as content and attribute values need it.
std::string htmlText(std::string_view text);

struct HtmlPicture {
    std::string description; ///< for those who cannot see it
    std::string bytes;       ///< of a PNG or SVG file
};

/// Pictures over one caption, up to `columns`, 1 to 4, of them beside each other where the window
/// is wide enough.
struct HtmlFigure {
    std::vector<HtmlPicture> pictures;
    std::string caption;
    unsigned columns = 1;
};

/// Columns of numbers, where each cell starts with a digit or a sign or is a dash, are aligned to
/// the right. The first column names the rows.
struct HtmlTable {
    std::string caption;
    std::vector<std::string> header;
    std::vector<std::vector<std::string>> rows; ///< each with a cell for each of the header
};

class HtmlPage {
public:
    /// `lead` is the paragraph under the title; contents follow, with a link to each section.
    HtmlPage(std::string title, std::string lead);

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
    std::string title_, lead_;
    std::vector<std::string> sections_;
    std::string body_;
};

} // namespace wellstrat::cli
