// SPDX-License-Identifier: GPL-3.0-or-later
// Surfaces as uneven scales and shears show them: in a space of true angles.
#pragma once

#include <memory>

#include <fovea/mesh/surface.h>

namespace fovea {

/// What a linear map does to angles: it is a stretch, symmetric and positive, before a motion, a mirroring or an even
/// scale, which leave them as they are. The sum of its squared entries is 3. The identity for maps that keep angles (to
/// 1e-4), and for those that flatten everything: what they leave has no curvature. Rounded, so that it does not
/// change while an object turns or grows. Higham, "Computing the Polar Decomposition", SISSC 1986.
dmat3 stretch_of(const dmat3& linear);

/// The surface with its vertices stretched: all elements keep their numbers, and what was outside stays outside. In
/// this space normals, curvature and angles are those of the placement, but for its size. Kept with the surface, with
/// which it ends; the surface itself where it is not stretched.
std::shared_ptr<const Surface> as_placed(const std::shared_ptr<const Surface>& surface, const dmat4& object_to_world);

}  // namespace fovea
