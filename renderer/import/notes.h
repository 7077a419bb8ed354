// SPDX-License-Identifier: Apache-2.0
//
// What to tell the user about a scene file, each thing once.

#pragma once

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace wellstrat::render {

class Notes {
public:
    /// Adds a sentence, unless it has been said.
    void add(std::string sentence) {
        if (std::find(sentences_.begin(), sentences_.end(), sentence) == sentences_.end())
            sentences_.push_back(std::move(sentence));
    }
    std::vector<std::string> take() { return std::move(sentences_); }

private:
    std::vector<std::string> sentences_;
};

} // namespace wellstrat::render
