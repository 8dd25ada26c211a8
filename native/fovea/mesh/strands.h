// SPDX-License-Identifier: GPL-3.0-or-later
// Meshes of strands: of hair, which Blender stores as polylines with radii, and of bare curves.
//
// A strand becomes a closed prism of three sides, not a ribbon that faces the camera: it does not depend on the view,
// so it is kept, instanced, refitted and hit by rays as any other surface, and what it hides and its contour are true
// from every side. Three sides are the fewest that enclose something, and the width of a regular prism varies little as
// it turns: between 0.91 and 1.05 of the strand's.
#pragma once

#include <fovea/mesh/surface.h>

namespace fovea::mesh {

/// Borrowed polylines: strand s has the points offsets[s] .. offsets[s + 1], two or more.
struct Strands {
    In<vec3> points;
    In<float> radii;  ///< per point
    In<int> offsets;
};

/// The same, owned.
struct OwnedStrands {
    Array<vec3> points;
    Array<float> radii;
    Array<int> offsets;
    Strands strands() const { return {points, radii, offsets}; }
};

/// `steps` segments for each one, on the Catmull-Rom curves through the points, as Blender has them. Throws
/// std::invalid_argument, naming the object, where arrays do not fit together, as the functions below do.
OwnedStrands rounded_strands(const std::string& name, const Strands& strands, int steps);

/// A closed prism along each strand, 3 vertices per point, whose mean width is that of the strand; where its radius is
/// below a fiftieth of its greatest one, that. `occludes`: whether it hides what lies behind.
OwnedMesh strand_prisms(const std::string& name, const Strands& strands, bool occludes);

/// The strands as edges without faces, one vertex per point.
OwnedMesh strand_wires(const std::string& name, const Strands& strands);

}  // namespace fovea::mesh
