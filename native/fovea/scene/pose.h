// SPDX-License-Identifier: GPL-3.0-or-later
// Where the placements of a scene are in one frame, and points of their surfaces in the image of another one.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include <fovea/base/view.h>
#include <fovea/scene/scene.h>

namespace fovea::scene {

/// A point of a surface, which is found again where the surface moves and deforms.
struct SurfacePoint {
    dvec3 position{0.0};              ///< object space
    std::array<Index, 3> vertices{};  ///< of what deforms: those of the triangle or edge on which it lies,
    std::array<double, 3> shares{};   ///< and how much it is of each; of an edge the third is 0
};

/// The point of an edge or triangle (Paths::place) nearest to a position. `at`: of its surface's vertices; empty: the
/// surface does not deform.
SurfacePoint surface_point(const Surface& surface, In<vec3> at, Index place, const dvec3& position);

/// The placements of a frame and its view, without the scene, which frames share and change.
struct Pose {
    struct Placed {
        std::uint64_t id;  ///< Placement::id
        Index placement;   ///< of the frame's own scene
        dmat4 object_to_view;
        /// Of vertices, object space; of placements of one surface the same; null: as if it did not deform.
        std::shared_ptr<const Array<vec3>> positions;

        In<vec3> at() const { return positions ? In<vec3>(*positions) : In<vec3>(); }
    };
    /// A point in the image.
    struct Seen {
        dvec2 px;
        double depth;  ///< distance along the view axis; not a number: it is not there
    };

    View view;
    std::vector<Placed> placed;  ///< ascending by id

    /// Index of the first one that has an id; `none`: it is not there.
    Index find(std::uint64_t id) const;
    /// Where a point of `here`, as another frame has it, is on what is `placed` in this one: by its vertices where both
    /// have as many, else as if it did not deform. It is not there where `placed` is none, behind the eye, and a
    /// million pixels away.
    Seen seen(const SurfacePoint& point, const Placed& here, Index placed) const;
    std::size_t bytes() const;  ///< about
};

/// Of all placements of a scene, with the positions of all vertices.
Pose pose_of(const Scene& scene, const View& view);
/// Of some, by index, with positions of surfaces that know their shape at rest alone.
Pose pose_of(const Scene& scene, const View& view, In<Index> placements);

}  // namespace fovea::scene
