// SPDX-License-Identifier: Apache-2.0
//
// The words of text files whose lines are statements: OBJ and MTL.

#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace wellstrat::render {

/// Lines end with \n, \r\n or \r, and go on after one that ends with a backslash. What follows a
/// word that begins with # is a comment. A byte order mark of UTF-8 is no part of the text.
class TextLines {
public:
    explicit TextLines(std::string text);

    /// Goes to the next line that has words. False at the end of the text.
    bool next();

    /// The words of the line, valid until `next`.
    const std::vector<std::string_view>& words() const { return words_; }

    /// The line from a word on, with the blanks between words as they are; empty if there are not
    /// so many words.
    std::string_view from(std::size_t word) const;

private:
    std::string_view physicalLine();
    std::string_view line();
    void split(std::string_view line);

    std::string text_;
    std::size_t position_ = 0;
    std::string joined_; ///< a line of several
    std::vector<std::string_view> words_;
};

/// The number that a word is; NaN if it is none.
double numberOf(std::string_view word);

} // namespace wellstrat::render
