// SPDX-License-Identifier: GPL-3.0-or-later
// Surfaces under a non-uniform scale or shear: the object multiplied by the symmetric part of its transform, so that
// angles in that space are those in the world.
#pragma once

#include <memory>

#include <fovea/mesh/surface.h>

namespace fovea::mesh {

/// The symmetric positive factor of a linear map's polar decomposition, which is all of it that changes angles;
/// rotation, reflection and uniform scale do not. The sum of its squared entries is 3. The identity for maps that keep
/// angles (to 1e-4), and for those that flatten everything: what they leave has no curvature. Rounded, so that it does
/// not change while an object turns or grows. Higham, "Computing the Polar Decomposition", SISSC 1986.
dmat3 stretch_of(const dmat3& linear);

/// The surface with its vertices stretched: all elements keep their numbers, and what was outside stays outside. In
/// this space normals, curvature and angles are those of the placement, but for its size. Kept with the surface, with
/// which it ends; the surface itself where it is not stretched.
std::shared_ptr<const Surface> as_placed(const std::shared_ptr<const Surface>& surface, const dmat4& object_to_world);

}  // namespace fovea::mesh
