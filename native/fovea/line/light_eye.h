// SPDX-License-Identifier: GPL-3.0-or-later
// A scene as one of its lights sees it: shared by the definitions that need light. Its view space has the light at the
// origin; `point`s are in it.
#pragma once

#include <fovea/line/definition.h>
#include <fovea/scene/light_view.h>

namespace fovea::line {

/// Steps along a segment at which a light is asked, at most.
inline constexpr int most_steps = 1024;

class LightEye {
   public:
    const Light light;
    const Tracer tracer;
    const double radius;  ///< of the scene
    const double step;    ///< along edges (scene/light_view.h)

    /// The scene must outlive it.
    LightEye(const Scene& scene, const Light& of);

    /// From the object space of a placement.
    dmat4 from_object(Index placement) const {
        return tracer.view().world_to_view * tracer.scene().placements[placement].object_to_world;
    }
    /// What a ray of light does that passes a point of an outline or a contour.
    struct Passing {
        bool lit = false;  ///< it reaches the point; nothing else touches there
        std::optional<Hit> hit =
            {};  ///< what it meets: behind the point if it is lit, else before or there, if it shines
    };
    Passing pass(const dvec3& point, const Ignore& ignore) const;
    /// Whether the light shines in the direction of a point, and that is not cut away by the section plane.
    bool shines_at(const dvec3& point) const;
    /// The point at parameter t of the ray through a point, where t is 1.
    dvec3 on_ray(const dvec3& point, double t) const;
    /// Whether a hit is on the body of the line that rays ignore.
    bool is_one_body(const Hit& hit, const Ignore& ignore) const;
};

/// Edges of a placement's surface beyond which, seen from the eye, what hides ends: borders, and where all facets are
/// to one side in the image (line/contour.cpp). In the image they include the boundary of what the surface hides.
Array<Index> outline_edges(const SurfaceView& seen);

}  // namespace fovea::line
