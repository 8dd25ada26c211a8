// SPDX-License-Identifier: GPL-3.0-or-later
// Surfaces of random meshes.
#pragma once

#include <memory>
#include <string>

#include <fovea/mesh/surface.h>

#include "choices.h"

namespace fovea::fuzz {

/// Made in one of the ways the core has: of polygons, repaired, refined, cut out, of strands, of spheres; some are
/// moved afterwards. Throws what these throw.
std::shared_ptr<Surface> random_surface(Choices& choices, const std::string& name);

}  // namespace fovea::fuzz
