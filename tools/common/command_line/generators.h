// SPDX-License-Identifier: Apache-2.0
//
// Generators by the names that options take.

#pragma once

#include "wellstrat/generator.h"

#include <string>
#include <vector>

namespace wellstrat::cli {

/// A generator that --generator and --compare accept.
struct NamedGenerator {
    const char* name;
    const char* description;
    const Generator* generator; ///< as RixRNG takes it: null is the tables
    Order order = {};           ///< of the domain that is drawn
};

/// All of them.
const std::vector<NamedGenerator>& namedGenerators();

/// These, and slot 0 of the joint samples: of one domain there is nothing to choose.
const std::vector<NamedGenerator>& sampleGenerators();

/// The one of `among` called `name`. Throws CliError, which names `option` and all of them, if
/// there is none.
const NamedGenerator& findGenerator(const std::string& option, const std::string& name,
                                    const std::vector<NamedGenerator>& among = namedGenerators());

/// `names` without repetitions, each in its first place.
std::vector<std::string> eachOnce(const std::vector<std::string>& names);

} // namespace wellstrat::cli
