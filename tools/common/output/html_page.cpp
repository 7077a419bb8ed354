// SPDX-License-Identifier: Apache-2.0

#include "html_page.h"

#include "common/command_line/errors.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <numeric>
#include <utility>

namespace wellstrat::cli {
namespace {

constexpr auto kStyle = R"(
:root { --ink: #1d2330; --soft: #5b6475; --line: #d9dde5; --tint: #f5f6f9; --accent: #2f5f98; }
* { box-sizing: border-box; }
body { margin: 0; color: var(--ink); background: #fff;
  font: 16px/1.55 system-ui, -apple-system, "Segoe UI", "Noto Sans", "DejaVu Sans", sans-serif; }
main { max-width: 80rem; margin: 0 auto; padding: 2.5rem 1.5rem 4rem; }
h1 { font-size: 2.1rem; line-height: 1.2; margin: 0 0 .75rem; letter-spacing: -.01em; }
h2 { font-size: 1.45rem; margin: 3.25rem 0 .75rem; padding-top: .9rem;
  border-top: 1px solid var(--line); }
h3 { font-size: 1.08rem; margin: 2rem 0 .5rem; }
p { max-width: 46rem; margin: .6rem 0; }
.verdict { font-size: 1.25rem; line-height: 1.4; }
.lead { font-size: 1.08rem; color: var(--soft); }
nav { margin: 1.5rem 0 0; }
nav a { display: inline-block; margin: 0 1.1rem .3rem 0; }
a { color: var(--accent); text-decoration: none; }
a:hover { text-decoration: underline; }
code, pre { font-family: ui-monospace, "DejaVu Sans Mono", Menlo, Consolas, monospace;
  font-size: .875em; background: var(--tint); border-radius: 4px; }
code { padding: .1em .3em; }
pre { padding: .8rem 1rem; line-height: 1.5; white-space: pre-wrap; overflow-wrap: anywhere; }
figure { margin: 1.25rem 0 1.75rem; }
.pictures { display: flex; flex-wrap: wrap; gap: 1rem; justify-content: flex-start; }
.picture { position: relative; }
.picture img { display: block; width: 100%; height: auto; border: 1px solid var(--line);
  border-radius: 6px; background: #fff; }
.label { position: absolute; left: .4rem; top: .4rem; padding: .05rem .4rem; border-radius: 4px;
  color: #fff; background: #000a; font-size: .85rem; }
.columns-1 .picture { width: 60rem; max-width: 100%; }
.columns-2 .picture { width: calc(50% - .5rem); }
.columns-3 .picture { width: calc(33.33% - .667rem); }
.columns-4 .picture { width: calc(25% - .75rem); }
figcaption, caption { color: var(--soft); font-size: .93rem; }
figcaption { margin-top: .6rem; }
caption { text-align: left; padding-bottom: .5rem; }
figcaption, caption { max-width: min(52rem, calc(100vw - 3rem)); }
.scroll { overflow-x: auto; margin: 1.25rem 0 1.75rem; }
table { border-collapse: collapse; font-size: .93rem; font-variant-numeric: tabular-nums; }
th, td { padding: .3rem 1.1rem .3rem 0; text-align: left; vertical-align: baseline; }
tbody th, tbody td { white-space: nowrap; }
th.number, td.number { text-align: right; }
td strong { background: #e2eddd; border-radius: 4px; padding: .1em .3em; margin-right: -.3em; }
thead th { border-bottom: 2px solid var(--line); color: var(--soft); font-weight: 600;
  vertical-align: bottom; }
tbody th { font-weight: 600; position: sticky; left: 0; background: #fff; }
tbody td, tbody th { border-bottom: 1px solid var(--line); }
@media (max-width: 50rem) { main { padding: 1.5rem 1rem 3rem; }
  .pictures { gap: .6rem; }
  .columns-2 .picture, .columns-3 .picture { width: 100%; }
  .columns-4 .picture { width: calc(50% - .3rem); }
  th, td { padding-right: .7rem; }
  tbody th, tbody td:not(.number) { white-space: normal; } }
@media print { main { max-width: none; padding: 0; } figure, tr { break-inside: avoid; } }
)";

/// RFC 4648, section 4.
std::string base64(std::string_view bytes) {
    constexpr auto kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
        uint32_t group = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            group = group << 8 | (k < count ? static_cast<unsigned char>(bytes[i + k]) : 0u);
        }
        for (std::size_t k = 0; k < 4; ++k) {
            text += k <= count ? kDigits[group >> (18 - 6 * k) & 63] : '=';
        }
    }
    return text;
}

std::string pictureUri(const std::string& bytes) {
    const auto startsWith = [&bytes](std::string_view start) { return bytes.rfind(start, 0) == 0; };
    if (startsWith("\x89PNG")) return "data:image/png;base64," + base64(bytes);
    if (startsWith("<?xml") || startsWith("<svg")) {
        return "data:image/svg+xml;base64," + base64(bytes);
    }
    throw CliError("a picture for an HTML page is neither PNG nor SVG");
}

/// Escaped, and with `code`.
std::string markedText(std::string_view text) {
    std::string marked;
    bool code = false;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find('`', begin), text.size());
        marked += htmlText(text.substr(begin, end - begin));
        if (end < text.size()) {
            code = !code;
            marked += code ? "<code>" : "</code>";
        }
        begin = end + 1;
    }
    return code ? marked + "</code>" : marked;
}

bool isNumber(const std::string& cell) {
    return cell.empty() || (cell[0] >= '0' && cell[0] <= '9') || cell[0] == '-' || cell[0] == '+';
}

/// The attribute of the cells of a column.
std::string columnClass(const HtmlTable& table, std::size_t column) {
    const bool numbers = std::all_of(table.rows.begin(), table.rows.end(),
                                     [&](const auto& row) { return isNumber(row.at(column)); });
    return numbers ? " class=\"number\"" : "";
}

std::string labelOf(const HtmlPicture& picture) {
    if (picture.label.empty()) return "";
    return fmt::format("<span class=\"label\" aria-hidden=\"true\">{}</span>",
                       htmlText(picture.label));
}

} // namespace

std::string htmlText(std::string_view text) {
    std::string escaped;
    for (const char c : text) {
        switch (c) {
        case '&': escaped += "&amp;"; break;
        case '<': escaped += "&lt;"; break;
        case '>': escaped += "&gt;"; break;
        case '"': escaped += "&quot;"; break;
        case '\'': escaped += "&#39;"; break;
        default: escaped += c;
        }
    }
    return escaped;
}

void HtmlTable::markBest(std::size_t column, const std::vector<std::size_t>& ofRows, Best which) {
    std::vector<std::pair<double, std::size_t>> numbers;
    for (const std::size_t row : ofRows) {
        const std::string& cell = rows.at(row).at(column);
        char* end = nullptr;
        const double number = std::strtod(cell.c_str(), &end);
        if (end != cell.c_str() && std::isfinite(number)) {
            numbers.emplace_back(which == Best::least ? number : -number, row);
        }
    }
    if (numbers.empty()) return;
    std::sort(numbers.begin(), numbers.end());
    const double first = numbers.front().first;
    if (first == numbers.back().first) return;
    for (const auto& [number, row] : numbers) {
        if (number == first) best.emplace(row, column);
    }
}

void HtmlTable::markBest(std::size_t column, Best which) {
    std::vector<std::size_t> all(rows.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    markBest(column, all, which);
}

HtmlPage::HtmlPage(std::string title, std::string verdict, std::string lead)
    : title_(std::move(title)), verdict_(std::move(verdict)), lead_(std::move(lead)) {}

void HtmlPage::section(std::string_view title) {
    sections_.emplace_back(title);
    body_ += fmt::format("<h2 id=\"section-{}\">{}</h2>\n", sections_.size(), htmlText(title));
}

void HtmlPage::subsection(std::string_view title) {
    body_ += fmt::format("<h3>{}</h3>\n", htmlText(title));
}

void HtmlPage::paragraph(std::string_view text) {
    body_ += fmt::format("<p>{}</p>\n", markedText(text));
}

void HtmlPage::code(std::string_view text) {
    body_ += fmt::format("<pre>{}</pre>\n", htmlText(text));
}

void HtmlPage::table(const HtmlTable& table) {
    std::vector<std::string> classes;
    body_ += fmt::format("<div class=\"scroll\"><table>\n<caption>{}</caption>\n<thead><tr>",
                         markedText(table.caption));
    for (std::size_t c = 0; c < table.header.size(); ++c) {
        classes.push_back(columnClass(table, c));
        body_ +=
            fmt::format("<th scope=\"col\"{}>{}</th>", classes[c], markedText(table.header[c]));
    }
    body_ += "</tr></thead>\n<tbody>\n";
    for (std::size_t r = 0; r < table.rows.size(); ++r) {
        body_ += "<tr>";
        for (std::size_t c = 0; c < table.rows[r].size(); ++c) {
            std::string cell = markedText(table.rows[r][c]);
            if (table.best.count({r, c}) != 0) cell = "<strong>" + cell + "</strong>";
            body_ += fmt::format(c == 0 ? "<th scope=\"row\"{}>{}</th>" : "<td{}>{}</td>",
                                 classes.at(c), cell);
        }
        body_ += "</tr>\n";
    }
    body_ += "</tbody></table></div>\n";
}

void HtmlPage::figure(const HtmlFigure& figure) {
    body_ += fmt::format("<figure><div class=\"pictures columns-{}\">\n", figure.columns);
    for (const HtmlPicture& picture : figure.pictures) {
        body_ +=
            fmt::format("<div class=\"picture\"><img alt=\"{}\" src=\"{}\">{}</div>\n",
                        htmlText(picture.description), pictureUri(picture.bytes), labelOf(picture));
    }
    body_ +=
        fmt::format("</div><figcaption>{}</figcaption></figure>\n", markedText(figure.caption));
}

std::string HtmlPage::finish() const {
    std::string contents;
    for (std::size_t s = 0; s < sections_.size(); ++s) {
        contents += fmt::format("<a href=\"#section-{}\">{}</a>\n", s + 1, htmlText(sections_[s]));
    }
    return fmt::format(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
        "<title>{0}</title>\n<style>{1}</style>\n</head>\n<body><main>\n<h1>{0}</h1>\n"
        "<p class=\"verdict\">{2}</p>\n<p class=\"lead\">{3}</p>\n<nav>\n{4}</nav>\n"
        "{5}</main></body>\n</html>\n",
        htmlText(title_), kStyle, markedText(verdict_), markedText(lead_), contents, body_);
}

} // namespace wellstrat::cli
