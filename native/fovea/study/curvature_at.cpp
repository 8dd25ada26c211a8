// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/study/curvature_at.h>

#include <algorithm>
#include <cmath>

#include <fovea/base/elementary.h>

namespace fovea::study {
namespace {

using base::dvec2, base::dvec3;
using field::Curvature, field::CurvatureD;

/// Both forms in a frame of the tangent plane.
struct Forms {
    double xx = 0.0, xy = 0.0, yy = 0.0;
    double third[4] = {0.0, 0.0, 0.0, 0.0};  // (x,x,x), (x,x,y), (x,y,y), (y,y,y)
};

/// Adds `weight` times the forms of a frame whose first axis has these coordinates (cosine, sine) in another one.
void add(double k1, double k2, const double* C, const dvec2& axis, double weight, Forms& sum) {
    const double c = axis.x, s = axis.y;
    sum.xx += weight * (k1 * c * c + k2 * s * s);
    sum.xy += weight * (k1 - k2) * c * s;
    sum.yy += weight * (k1 * s * s + k2 * c * c);
    // The axes of the other frame have the coordinates (c, -s) and (s, c) in the first one.
    const auto third = [&](const dvec2& u, const dvec2& v, const dvec2& w) {
        return C[0] * u.x * v.x * w.x + C[1] * (u.x * v.x * w.y + u.x * v.y * w.x + u.y * v.x * w.x) +
               C[2] * (u.x * v.y * w.y + u.y * v.x * w.y + u.y * v.y * w.x) + C[3] * u.y * v.y * w.y;
    };
    const dvec2 x(c, -s), y(s, c);
    sum.third[0] += weight * third(x, x, x);
    sum.third[1] += weight * third(x, x, y);
    sum.third[2] += weight * third(x, y, y);
    sum.third[3] += weight * third(y, y, y);
}

/// The curvature of forms in the frame (x, y, normal).
CurvatureD principal(const Forms& forms, const dvec3& x, const dvec3& y, const dvec3& normal) {
    const double mean = 0.5 * (forms.xx + forms.yy), half = 0.5 * (forms.xx - forms.yy);
    const double radius = std::sqrt(half * half + forms.xy * forms.xy), sign = mean < 0.0 ? -1.0 : 1.0;
    CurvatureD made{};
    made.normal = normal;
    made.k1 = mean + sign * radius;
    made.k2 = mean - sign * radius;
    const double angle = 0.5 * base::angle_of(sign * forms.xy, sign * half);
    const dvec2 axis(base::cosine(angle), base::sine(angle));
    made.e1 = axis.x * x + axis.y * y;
    made.e2 = axis.x * y - axis.y * x;
    Forms turned;
    add(0.0, 0.0, forms.third, dvec2(axis.x, -axis.y), 1.0, turned);
    std::copy_n(turned.third, 4, made.C);
    return made;
}

}  // namespace

CurvatureD mixed(const Curvature& a, const Curvature& b, const Curvature& c, const base::vec3& weights) {
    const Curvature* const corners[] = {&a, &b, &c};
    dvec3 sum(0.0);
    for (int i = 0; i < 3; ++i) {
        if (corners[i]->normal == base::vec3(0.0f)) return {};
        sum += double(weights[i]) * dvec3(corners[i]->normal);
    }
    if (!(glm::length(sum) > 1e-6)) return {};
    const dvec3 normal = glm::normalize(sum);
    const dvec3 other = std::abs(normal.x) < 0.6 ? dvec3(1, 0, 0) : dvec3(0, 1, 0);
    const dvec3 x = glm::normalize(glm::cross(other, normal)), y = glm::cross(normal, x);
    Forms forms;
    for (int i = 0; i < 3; ++i) {
        // A frame of the vertex, turned onto the tangent plane here: the middle of where its axes lie.
        const dvec3 e1(corners[i]->e1), e2(corners[i]->e2);
        const dvec2 axis(glm::dot(e1, x) + glm::dot(e2, y), glm::dot(e1, y) - glm::dot(e2, x));
        const double length = glm::length(axis);
        if (!(length > 1e-6)) return {};
        const double C[] = {corners[i]->C[0], corners[i]->C[1], corners[i]->C[2], corners[i]->C[3]};
        add(corners[i]->k1, corners[i]->k2, C, axis / length, double(weights[i]), forms);
    }
    return principal(forms, x, y, normal);
}

CurvatureD turned_around(const CurvatureD& of) {
    return {-of.normal, of.e1, -of.e2, -of.k1, -of.k2, {-of.C[0], of.C[1], -of.C[2], of.C[3]}};
}

}  // namespace fovea::study
