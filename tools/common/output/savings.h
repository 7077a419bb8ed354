// SPDX-License-Identifier: Apache-2.0
//
// The states that a long run saves on its way, which it can do without.

#pragma once

#include "common/command_line/errors.h"
#include "common/command_line/messages.h"

#include <exception>

namespace wellstrat::cli {

class Savings {
public:
    /// Calls save(). One that throws, as on a full disk, is said once until one succeeds again, and
    /// costs nothing else.
    template <typename Save>
    void attempt(Save&& save) {
        try {
            save();
            failing_ = false;
        } catch (const std::exception& error) {
            if (!failing_) say("{}; goes on without it", messageOf(error));
            failing_ = true;
        }
    }

    /// Whether the last one failed.
    bool failing() const { return failing_; }

private:
    bool failing_ = false;
};

} // namespace wellstrat::cli
