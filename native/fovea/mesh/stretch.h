// SPDX-License-Identifier: GPL-3.0-or-later
// Surfaces under non-uniform scale or shear: vertices pre-multiplied by the symmetric factor of the object's transform,
// so that angles in that space are those in world space.
#pragma once

#include <memory>

#include <fovea/mesh/surface.h>

namespace fovea::mesh {

/// The symmetric positive definite factor of a linear map's polar decomposition: the part that changes angles, as
/// rotation, reflection and uniform scale do not. Scaled so that its squared entries sum to 3. Identity for maps that
/// preserve angles (to 1e-4) and for singular ones, whose image has no curvature. Rounded to 2^-18, so that it stays
/// constant while an object rotates or scales uniformly. Higham, "Computing the Polar Decomposition", SISSC 1986.
dmat3 stretch_of(const dmat3& linear);

/// The surface with its vertices stretched by the placement's transform; element indices and orientation are unchanged.
/// Normals, curvature and angles in this space are those in world space up to rotation, reflection and uniform scale.
/// Cached with the surface, which it must not outlive; the surface itself if the stretch is the identity.
std::shared_ptr<const Surface> as_placed(const std::shared_ptr<const Surface>& surface, const dmat4& object_to_world);

}  // namespace fovea::mesh
