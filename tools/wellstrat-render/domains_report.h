// SPDX-License-Identifier: Apache-2.0
//
// What wellstrat domains finds out, as text and JSON.

#pragma once

#include "scene/options.h"

#include "renderer/domain_error.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace wellstrat::cli {

struct DomainsOptions {
    SceneOptions scene;
    std::vector<std::string> generators{"joint"};
    uint64_t spp = 256, seeds = 16;
    std::optional<std::string> output;
};

/// A part of the mean squared error of pmj.
struct Part {
    std::string name;
    render::Measured value;
};

struct DomainErrors {
    double rmse; ///< of pmj
    std::vector<Part> domains;
    Part sum;
    std::vector<Part> generators;
};

/// Tables for readers, and what to do.
std::string domainsText(const DomainsOptions& options, ImageSize size, const DomainErrors& errors);

/// All numbers are parts of the mean squared error of pmj.
std::string domainsJson(const DomainsOptions& options, ImageSize size, const DomainErrors& errors);

} // namespace wellstrat::cli
