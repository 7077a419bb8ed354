// SPDX-License-Identifier: Apache-2.0
//
// What the tool reports when it cannot do what was asked.

#pragma once

#include <exception>
#include <functional>
#include <stdexcept>
#include <string>
#include <string_view>

namespace wellstrat::cli {

constexpr int kExitViolation = 1; ///< a promise does not hold
constexpr int kExitError = 2;     ///< bad arguments, or something outside failed

/// Says in one line what was wrong and, for bad arguments, what is accepted.
class CliError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// The error "cannot ACTION 'PATH': reason", with the reason that `errnoValue` stands for.
CliError fileError(std::string_view action, std::string_view path, int errnoValue);

/// Says what went wrong: what() of `error`, or that memory is out.
std::string messageOf(const std::exception& error);

/// What run() returns or, if it throws a std::exception, kExitError after one line on the standard
/// error that says why.
int exitCodeOf(const std::function<int()>& run);

} // namespace wellstrat::cli
