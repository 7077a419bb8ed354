// SPDX-License-Identifier: Apache-2.0

#include "polygons.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace wellstrat::render {
namespace {

struct Point {
    double x, y;
};

bool operator==(Point a, Point b) { return a.x == b.x && a.y == b.y; }

/// Twice the area of a triangle; negative if it is clockwise.
double area(Point a, Point b, Point c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Newell's: each component is twice the area of a projection.
std::array<double, 3> normalOf(const std::vector<Float3>& corners) {
    std::array<double, 3> normal{};
    Float3 a = corners.back();
    for (const Float3 b : corners) {
        for (int c = 0; c < 3; ++c) {
            const int u = (c + 1) % 3, v = (c + 2) % 3;
            normal[static_cast<std::size_t>(c)] += (double{a[u]} - b[u]) * (double{a[v]} + b[v]);
        }
        a = b;
    }
    return normal;
}

/// The corners without the coordinate in which the normal is longest; counterclockwise.
std::vector<Point> projected(const std::vector<Float3>& corners) {
    const auto normal = normalOf(corners);
    const auto longest = std::max_element(
        normal.begin(), normal.end(), [](double a, double b) { return std::abs(a) < std::abs(b); });
    const auto axis = static_cast<int>(longest - normal.begin());
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    std::vector<Point> points;
    points.reserve(corners.size());
    for (const Float3 corner : corners)
        points.push_back(*longest < 0 ? Point{corner[v], corner[u]} : Point{corner[u], corner[v]});
    return points;
}

class EarClipper {
public:
    explicit EarClipper(const std::vector<Point>& points) : points_(points) {
        for (std::size_t i = 0; i < points.size(); ++i) rest_.push_back(static_cast<uint32_t>(i));
    }

    bool isConvex() const {
        for (std::size_t i = 0; i < rest_.size(); ++i)
            if (!isConvexAt(i)) return false;
        return true;
    }

    void clip(std::vector<std::array<uint32_t, 3>>& triangles) {
        std::size_t next = 0;
        while (rest_.size() > 3) {
            const std::size_t ear = findEar(next);
            triangles.push_back({rest_[before(ear)], rest_[ear], rest_[after(ear)]});
            rest_.erase(rest_.begin() + static_cast<std::ptrdiff_t>(ear));
            next = ear; // not the same corner's again: thinner triangles
        }
        triangles.push_back({rest_[0], rest_[1], rest_[2]});
    }

private:
    std::size_t before(std::size_t i) const { return i == 0 ? rest_.size() - 1 : i - 1; }
    std::size_t after(std::size_t i) const { return i + 1 == rest_.size() ? 0 : i + 1; }
    Point point(std::size_t i) const { return points_[rest_[i]]; }

    bool isConvexAt(std::size_t i) const {
        return area(point(before(i)), point(i), point(after(i))) > 0;
    }

    bool isEar(std::size_t i) const {
        if (!isConvexAt(i)) return false;
        const Point a = point(before(i)), b = point(i), c = point(after(i));
        for (std::size_t k = 0; k < rest_.size(); ++k) {
            const Point p = point(k);
            if (p == a || p == b || p == c || isConvexAt(k)) continue;
            if (area(a, b, p) >= 0 && area(b, c, p) >= 0 && area(c, a, p) >= 0) return false;
        }
        return true;
    }

    /// The first ear from `next` on; where there is none, which is in no simple polygon, a corner.
    std::size_t findEar(std::size_t next) const {
        for (std::size_t n = 0; n < rest_.size(); ++n) {
            const std::size_t i = (next + n) % rest_.size();
            if (isEar(i)) return i;
        }
        return next % rest_.size();
    }

    const std::vector<Point>& points_;
    std::vector<uint32_t> rest_;
};

} // namespace

void appendTriangles(const std::vector<Float3>& corners,
                     std::vector<std::array<uint32_t, 3>>& triangles) {
    if (corners.size() > 3) {
        const std::vector<Point> points = projected(corners);
        EarClipper clipper(points);
        if (!clipper.isConvex()) return clipper.clip(triangles);
    }
    for (std::size_t i = 2; i < corners.size(); ++i)
        triangles.push_back({0, static_cast<uint32_t>(i - 1), static_cast<uint32_t>(i)});
}

} // namespace wellstrat::render
