// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/vector/curve.h>

#include <algorithm>
#include <cmath>

#include <fovea/base/steps.h>

namespace fovea::vector {

int steps_of(const Cubic& c, double error) {
    // A chord over a step h is at most h^2 / 8 times the largest second derivative away, which is that of an end.
    const double bend = std::max(glm::length(bend_at(c, 0.0)), glm::length(bend_at(c, 1.0)));
    return base::steps_of(std::sqrt(bend / (8.0 * error)), 10000);
}

void Curve::line_to(const dvec2& point) {
    points.push_back(point);
    cubic.push_back(0);
}

void Curve::cubic_to(const dvec2& a, const dvec2& b, const dvec2& point) {
    points.insert(points.end(), {a, b, point});
    cubic.push_back(1);
}

void Curve::append(const Curve& more) {
    points.insert(points.end(), more.points.begin() + !empty(), more.points.end());
    cubic.insert(cubic.end(), more.cubic.begin(), more.cubic.end());
}

Curve Curve::through(In<dvec2> points, bool closed) {
    Curve curve{Points(points.begin(), points.end()), {}, closed};
    if (!points.empty()) curve.cubic.assign(points.size() - 1, 0);
    return curve;
}

Points flattened(const Curve& curve, double error) {
    Points points;
    if (!curve.empty()) points.push_back(curve.start());
    for_each_segment(curve, [&](const dvec2* p, bool cubic) {
        if (!cubic) return points.push_back(p[1]);
        const Cubic c{p[0], p[1], p[2], p[3]};
        const int steps = steps_of(c, error);
        for (int k = 1; k < steps; ++k) points.push_back(point_at(c, double(k) / steps));
        points.push_back(p[3]);
    });
    return points;
}

double length_of(In<dvec2> points) {
    double length = 0.0;
    for (std::size_t i = 1; i < points.size(); ++i) length += glm::distance(points[i - 1], points[i]);
    return length;
}

Curve reversed(const Curve& curve) {
    Curve back = curve;
    std::ranges::reverse(back.points);
    std::ranges::reverse(back.cubic);
    return back;
}

Curve rotated(const Curve& curve, std::size_t first) {
    std::size_t point = 0;
    for (std::size_t i = 0; i < first; ++i) point += curve.cubic[i] ? 3 : 1;
    Curve turned = curve;
    turned.points.pop_back();
    std::ranges::rotate(turned.points, turned.points.begin() + std::ptrdiff_t(point));
    std::ranges::rotate(turned.cubic, turned.cubic.begin() + std::ptrdiff_t(first));
    turned.points.push_back(turned.points.front());
    return turned;
}

}  // namespace fovea::vector
