// SPDX-License-Identifier: Apache-2.0
//
// The largest of many lines at an x that only grows, while lines are raised and lowered.
// A kinetic tournament (Basch, Guibas, Hershberger 1999, "Data structures for mobile data",
// J. Algorithms 31, 1-28): each node of a binary tree keeps the larger one of its children's lines
// and until which x that stays so.

#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace wellstrat {
inline namespace stream1 {

class KineticTournament {
public:
    /// Line j is slopes[j] * x, to begin with, and x is 0. There is at least one.
    explicit KineticTournament(const std::vector<double>& slopes) {
        while (leaves_ < slopes.size()) leaves_ *= 2;
        nodes_.resize(2 * leaves_);
        for (std::size_t j = 0; j < slopes.size(); ++j) nodes_[leaves_ + j].line = {slopes[j], 0};
        for (std::size_t node = leaves_; --node > 0;) choose(node);
    }

    /// Raises line `first` and all after it by `height`.
    void raiseFrom(std::size_t first, double height) { raise(1, 0, leaves_, first, height); }

    /// The largest value at x, which must not be less than at any call before.
    double largest(double x) {
        x_ = x;
        update(1);
        return nodes_[1].line.at(x_);
    }

private:
    static constexpr double kInfinity = std::numeric_limits<double>::infinity();

    struct Line {
        double slope = 0, height = -kInfinity;
        double at(double x) const { return slope * x + height; }
    };

    struct Node {
        Line line;
        double until = kInfinity; ///< the x at which a line in this subtree overtakes another
        double pending = 0;       ///< height that the children's lines have not got yet
    };

    void choose(std::size_t node) {
        const Node& left = nodes_[2 * node];
        const Node& right = nodes_[2 * node + 1];
        const double lead = left.line.at(x_) - right.line.at(x_);
        const bool leftWins = lead > 0 || (lead == 0 && left.line.slope >= right.line.slope);
        const Line winner = leftWins ? left.line : right.line;
        const Line loser = leftWins ? right.line : left.line;
        double until = std::min(left.until, right.until);
        if (loser.slope > winner.slope) {
            until = std::min(until, (winner.height - loser.height) / (loser.slope - winner.slope));
        }
        nodes_[node].line = winner;
        nodes_[node].until = until;
    }

    void raiseAll(std::size_t node, double height) {
        nodes_[node].line.height += height;
        nodes_[node].pending += height;
    }

    void handDown(std::size_t node) {
        const double height = nodes_[node].pending;
        if (height == 0) return;
        raiseAll(2 * node, height);
        raiseAll(2 * node + 1, height);
        nodes_[node].pending = 0;
    }

    void raise(std::size_t node, std::size_t begin, std::size_t end, std::size_t first,
               double height) {
        if (end <= first) return;
        if (begin >= first) {
            raiseAll(node, height);
            return;
        }
        handDown(node);
        const std::size_t middle = (begin + end) / 2;
        raise(2 * node, begin, middle, first, height);
        raise(2 * node + 1, middle, end, first, height);
        choose(node);
    }

    void update(std::size_t node) {
        if (x_ < nodes_[node].until) return;
        handDown(node);
        update(2 * node);
        update(2 * node + 1);
        choose(node);
    }

    std::size_t leaves_ = 1;
    double x_ = 0;
    std::vector<Node> nodes_;
};

} // namespace stream1
} // namespace wellstrat
