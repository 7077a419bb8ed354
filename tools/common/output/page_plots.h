// SPDX-License-Identifier: Apache-2.0
//
// The plots of an HTML page.

#pragma once

#include "picture.h"

#include <deque>
#include <string>

namespace wellstrat::cli {

/// Draws the plots of a page as SVG, and keeps their files if asked to: for page.html and the plot
/// "error" page-error.svg, with its data and script.
class PagePlots {
public:
    PagePlots(const std::string& page, bool keepFiles)
        : stem_(page.substr(0, page.rfind('.'))), keepFiles_(keepFiles) {}

    /// The bytes of the picture. Throws CliError as drawPlot does.
    std::string draw(const std::string& name, const Plot& plot) {
        if (!keepFiles_) return drawPlot(plot, ".svg").picture;
        kept_.emplace_back("-o", stem_ + "-" + name + ".svg", true);
        return kept_.back().draw(plot);
    }

    /// Puts the files under their names.
    void commit() {
        for (Picture& picture : kept_) picture.commit();
    }

private:
    std::string stem_;
    bool keepFiles_;
    std::deque<Picture> kept_;
};

} // namespace wellstrat::cli
