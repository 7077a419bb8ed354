// SPDX-License-Identifier: Apache-2.0
//
// The integrands of the lab that are functions of one draw, as the judge sees them.

#pragma once

#include "bank_search/judge.h"
#include "wellstrat/analysis/integrands.h"

#include <string>
#include <vector>

namespace bank_tests {

/// Those without parameters, and edges at all angles: the other half of the circle is the same.
inline std::vector<std::string> plainLab() {
    std::vector<std::string> names{"step-1d",     "linear",  "gaussian-1d", "smooth-1d",
                                   "disk",        "step",    "triangle",    "gaussian",
                                   "bilinear",    "smooth",  "disk-3d",     "triangle-3d",
                                   "gaussian-3d", "edge-3d", "trilinear",   "smooth-3d"};
    for (unsigned angle = 0; angle < 180; angle += 15) {
        names.push_back("edge-" + std::to_string(angle));
    }
    return names;
}

/// And waves, checkerboards and rectangles.
inline std::vector<std::string> wholeLab() {
    std::vector<std::string> names = plainLab();
    for (unsigned frequency = 1; frequency <= 64; frequency *= 2) {
        names.push_back("sine-" + std::to_string(frequency));
    }
    for (const unsigned zoom : {1u, 8u, 64u}) {
        names.push_back("checkerboard-" + std::to_string(zoom));
    }
    for (unsigned number = 0; number < 16; ++number) {
        names.push_back("box-" + std::to_string(number));
    }
    names.push_back("sine-1d-2");
    return names;
}

inline std::vector<wellstrat::bank::JudgedIntegrand>
judgedLab(const std::vector<std::string>& names, unsigned gridDigits = 20) {
    std::vector<wellstrat::bank::JudgedIntegrand> judged;
    for (const std::string& name : names) {
        judged.push_back(
            wellstrat::bank::judgedIntegrand(wellstrat::makeIntegrand(name), gridDigits));
    }
    return judged;
}

} // namespace bank_tests
