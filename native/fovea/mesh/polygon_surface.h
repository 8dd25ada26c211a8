// SPDX-License-Identifier: GPL-3.0-or-later
// A surface of polygons alone, as files outside Blender have them.
#pragma once

#include <memory>

#include <fovea/mesh/surface.h>

namespace fovea {

/// V positions; polygon f has the vertices corner_verts[polygon_offsets[f]] .. [polygon_offsets[f + 1]], 3 or more.
/// Edges follow from them, and polygons with more than four corners are cut into triangles. `material`: a number per
/// polygon, may be empty. Throws as Surface.
std::shared_ptr<Surface> polygon_surface(const std::string& name, In<vec3> positions, In<int> corner_verts,
                                         In<int> polygon_offsets, In<int> material = {});

}  // namespace fovea
