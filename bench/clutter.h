// SPDX-License-Identifier: Apache-2.0
//
// What a renderer does to the caches between two batches of samples: it walks through its scene.

#pragma once

namespace wellstrat {

/// Reads and writes one word in each cache line of 96 MiB.
void clutterCaches();

/// A clock that costs the same whatever the caches hold.
class Stopwatch {
public:
    void start();
    /// Seconds since `start`, less what the clock itself takes.
    double stop() const;

private:
    double start_ = 0;
};

} // namespace wellstrat
