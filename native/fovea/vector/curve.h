// SPDX-License-Identifier: GPL-3.0-or-later
// Curves of lines and cubic Beziers.
#pragma once

#include <array>
#include <vector>

#include <fovea/base/types.h>

namespace fovea::vector {

using Points = std::vector<dvec2>;

/// A cubic Bezier by its control points.
using Cubic = std::array<dvec2, 4>;

/// The point of a cubic at u in [0,1].
inline dvec2 point_at(const Cubic& c, double u) {
    const double v = 1.0 - u;
    return v * v * v * c[0] + 3.0 * u * v * (v * c[1] + u * c[2]) + u * u * u * c[3];
}

/// Its first derivative by u.
inline dvec2 slope_at(const Cubic& c, double u) {
    const double v = 1.0 - u;
    return 3.0 * (v * v * (c[1] - c[0]) + 2.0 * u * v * (c[2] - c[1]) + u * u * (c[3] - c[2]));
}

/// Its second derivative by u.
inline dvec2 bend_at(const Cubic& c, double u) {
    return 6.0 * ((1.0 - u) * (c[0] - 2.0 * c[1] + c[2]) + u * (c[1] - 2.0 * c[2] + c[3]));
}

/// Steps of u, all alike, whose chords keep within `error` of the cubic.
int steps_of(const Cubic& c, double error);

/// Lines and cubics end to end. Empty: no points.
struct Curve {
    Points points;                    ///< the start; then one per line, three per cubic
    std::vector<std::uint8_t> cubic;  ///< per segment: whether it is one, or a line
    bool closed = false;              ///< the last point repeats the first

    bool empty() const { return points.empty(); }
    dvec2 start() const { return points.front(); }
    dvec2 end() const { return points.back(); }
    void line_to(const dvec2& point);
    void cubic_to(const dvec2& a, const dvec2& b, const dvec2& point);
    /// Appends a curve that starts at its end, or any to an empty one.
    void append(const Curve& more);
    /// Lines through all points.
    static Curve through(In<dvec2> points, bool closed);
};

/// Calls visit(points of the segment, whether it is cubic) for each: two points of a line, four of a cubic.
template <typename Visit>
void for_each_segment(const Curve& curve, const Visit& visit) {
    const dvec2* at = curve.points.data();
    for (const std::uint8_t cubic : curve.cubic) {
        visit(at, bool(cubic));
        at += cubic ? 3 : 1;
    }
}

/// Points on the curve, ends of segments among them; the lines between them keep within `error` of it.
Points flattened(const Curve& curve, double error);

/// Length of the lines through points.
double length_of(In<dvec2> points);

/// The same way back.
Curve reversed(const Curve& curve);

/// A closed curve that begins with segment number `first`.
Curve rotated(const Curve& curve, std::size_t first);

}  // namespace fovea::vector
