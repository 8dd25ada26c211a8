// SPDX-License-Identifier: GPL-3.0-or-later
// Section plane: what is in front of it is cut away. Surfaces are not changed: rays, rasterizers and the clipping of
// lines each leave out what lies before the plane.
#pragma once

#include <fovea/base/parallel.h>
#include <fovea/scene/scene.h>

namespace fovea::scene {

/// What is kept of a placement, and the plane in its object space.
struct Cut {
    enum Kept : std::uint8_t { all, part, nothing };
    Kept kept = all;
    /// Distance in world units before the plane = dot(plane, (point, 1)); a positive one is cut away. The plane is
    /// moved forward by `slack`, which exceeds the rounding of positions, so that faces in the plane stay.
    dvec4 plane{0.0, 0.0, 0.0, -1.0};
    double slack = 0.0;

    double before(const vec3& point_obj) const { return glm::dot(plane, dvec4(dvec3(point_obj), 1.0)); }
};
Cut cut_of(const Scene& scene, const Placement& placement);

/// The section plane in view space, with a unit normal; unset: nothing is cut.
std::optional<dvec4> section_in_view(const Scene& scene, const View& view);

/// Whether the viewer faces the section, that is, is in what is cut away.
bool faces_section(const dvec4& plane_view, const View& view);

/// A side of the section's inside in the image [px]; seen from the front, the inside is to its left.
struct SectionSide {
    dvec2 from, to;
};

/// Sides of what the section plane cuts of the solid bodies of placements that are drawn (bodies.h); open shells have
/// no inside. They form closed loops, also where they are clipped at the near plane. Empty if the viewer does not face
/// the section. Nothing that is kept hides it.
Array<SectionSide> section_sides(const Scene& scene, const View& view);

}  // namespace fovea::scene
