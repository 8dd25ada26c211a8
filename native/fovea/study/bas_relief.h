// SPDX-License-Identifier: GPL-3.0-or-later
// Bas-reliefs, up to which people tell the shape of what they see: depth scaled and sheared along the view. Cole 2009,
// section 4.2.6.
#pragma once

#include <fovea/base/types.h>

namespace fovea::study {

using namespace vector;  // as in bitmap.h

/// The surface z = f(x, y), z towards the viewer, becomes z = depth * f(x, y) + slope.x * x + slope.y * y.
struct BasRelief {
    double depth = 1.0;
    dvec2 slope{0.0};

    /// The unit normal of the relief where the surface's is `normal`, with a positive z.
    dvec3 of_normal(const dvec3& normal) const {
        return glm::normalize(dvec3(depth * dvec2(normal) - slope * normal.z, normal.z));
    }
    /// The relief that undoes this one.
    BasRelief inverse() const { return {1.0 / depth, -slope / depth}; }
};

/// Depths that are tried: of a few places alone the best relief may be flat.
inline constexpr double least_depth = 0.1, most_depth = 10.0;

/// The relief that turns normals nearest to others, by the mean angle, which a few lapses do not change much. Both are
/// unit vectors with z above 0, at least three. Of several starts, the best.
BasRelief fitted_relief(In<dvec3> normals, In<dvec3> onto);

/// Angle [rad] between unit vectors.
double angle_between(const dvec3& a, const dvec3& b);

}  // namespace fovea::study
