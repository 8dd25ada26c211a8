// SPDX-License-Identifier: GPL-3.0-or-later
// Intersection of a ray and a triangle, in double precision, watertight: Woop, Benthin, Wald, "Watertight Ray/Triangle
// Intersection", JCGT 2(1), 2013, section 3.
#pragma once

#include <cmath>
#include <utility>

#include <fovea/base/types.h>

namespace fovea::scene {

/// A ray, and the shear in which it runs along the z axis from the coordinate origin. All in the triangles' space.
struct ShearedRay {
    dvec3 origin{0.0}, direction{0.0};
    int x = 0, y = 1, z = 2;  ///< the axis along which the direction is longest is z
    double shear_x = 0.0, shear_y = 0.0, scale = 0.0;

    ShearedRay() = default;
    /// `along` is not 0.
    ShearedRay(const dvec3& from, const dvec3& along) : origin(from), direction(along) {
        const dvec3 size = glm::abs(along);
        z = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
        x = (z + 1) % 3;
        y = (z + 2) % 3;
        scale = 1.0 / along[z];
        shear_x = along[x] * scale;
        shear_y = along[y] * scale;
    }
    [[gnu::always_inline]] dvec3 operator()(const vec3& point) const {
        const double depth = double(point[z]) - origin[z];
        return {double(point[x]) - origin[x] - shear_x * depth, double(point[y]) - origin[y] - shear_y * depth, depth};
    }
};

/// Where a ray meets the plane of a triangle: ray parameter, and weights of the second and third corner.
struct TriangleHit {
    double t = 0.0, u = 0.0, v = 0.0;
};

/// Whether the ray's line meets triangle abc, its sides and corners included: a line through a side that two triangles
/// share meets at least one of them, whatever is rounded. One that lies in the triangle's plane does not meet it.
inline bool meets(const ShearedRay& ray, const vec3& at_a, const vec3& at_b, const vec3& at_c, TriangleHit& hit) {
    const dvec3 a = ray(at_a), b = ray(at_b), c = ray(at_c);
    const double u = c.x * b.y - c.y * b.x, v = a.x * c.y - a.y * c.x;
    if ((u < 0.0 && v > 0.0) || (u > 0.0 && v < 0.0)) return false;
    const double w = b.x * a.y - b.y * a.x;
    if ((u < 0.0 || v < 0.0 || w < 0.0) && (u > 0.0 || v > 0.0 || w > 0.0)) return false;
    const double sum = u + v + w;
    if (sum == 0.0) return false;
    const double share = 1.0 / sum;
    hit = {(u * a.z + v * b.z + w * c.z) * share * ray.scale, v * share, w * share};
    return true;
}

}  // namespace fovea::scene
