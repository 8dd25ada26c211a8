// SPDX-License-Identifier: GPL-3.0-or-later
// Rays through a scene as a view sees it. The only header over scene/bvh, the only user of Embree.
#pragma once

#include <memory>
#include <optional>

#include <fovea/scene/bodies.h>

namespace fovea::scene {

/// Triangles that a visibility ray ignores:
/// (a) of a line on a mesh edge, those of the facets at the edge;
/// (b) of a line on two surfaces, those of both facets;
/// (c) of a line across a triangle, those that share a corner with it;
/// (d) of a contour of the smooth surface, which runs beside the mesh's own and often inside the mesh, also all of the
///     surface along the ray within twice the length of its triangle. So folds that near do not hide their own
///     contours, and large triangles beside a sliver still break one for a few pixels: test_contour_visibility.cpp
///     measures the error.
struct Ignore {
    Index placement = none;
    const EdgeSide* begin = nullptr;
    const EdgeSide* end = nullptr;
    Triangle around{none, none, none};  ///< vertices; `none`: the line lies on an edge
    float reach = 0.0f;                 ///< view space
    /// Offset of the ray's target from the surface, view space: keeps roughness from hiding lines across triangles. At
    /// a contour the offset lies in the image plane.
    vec3 above{0.0f};
    Index facet = none;  ///< of a line on two surfaces, with that of the second
    Index other_placement = none, other_facet = none;

    bool across_triangles() const { return around.x != none; }
    /// `surface`: that of the placement.
    bool holds(Index of, const Surface& surface, Index triangle) const {
        if (of == other_placement && surface.triangle_facet[triangle] == other_facet) return true;
        if (of != placement) return false;
        if (facet != none) return surface.triangle_facet[triangle] == facet;
        if (across_triangles()) {
            const Triangle& t = surface.triangles[triangle];
            for (int i = 0; i < 3; ++i)
                if (t[i] == around.x || t[i] == around.y || t[i] == around.z) return true;
            return false;
        }
        const Index own = surface.triangle_facet[triangle];
        for (const EdgeSide* side = begin; side != end; ++side)
            if (side->facet() == own) return true;
        return false;
    }
};

/// A triangle that a ray met.
struct Hit {
    Index placement;
    Index triangle;
    /// Share of the way from the eye to the point asked about.
    float t;
    /// Barycentric coordinates: the share of the triangle's second corner, and of its third.
    float u = 0.0f, v = 0.0f;
};

/// A flat convex polygon of three or four corners, in order, in view space.
struct Outline {
    dvec3 corners[4];
    int count = 3;
    Index triangle = none, other = none;  ///< those it is made of, in the hit's surface
};

/// Points count as hidden by surfaces nearer than themselves by more than this share of their distance, so that a
/// line on a surface, or on two that touch, is not hidden by it.
inline constexpr double ray_margin = 1e-5;

/// A stretch of a straight line: shares of the way along `direction`.
struct Ray {
    vec3 origin, direction;
    float near_t, far_t;
};

/// Two levels: one BVH per surface, kept with the surface, and one over the placements, in view space. Const methods
/// may be called from many threads. The scene must outlive the tracer.
class Tracer {
   public:
    /// Placements that neither occlude nor reach into the frame are left out.
    Tracer(const Scene& scene, const View& view);
    ~Tracer();
    Tracer(const Tracer&) = delete;
    Tracer& operator=(const Tracer&) = delete;

    /// The surface nearest to the eye that hides `point` (view space); what lies nearer than the near plane is cut
    /// away.
    std::optional<Hit> occluder(const vec3& point, const Ignore& ignore) const;

    /// The surfaces that hide `point`, at most `most`, one hit for each: a solid body is one for entering and leaving
    /// it, a sheet one for each crossing. Hits on one body nearer to each other than ray_margin are one crossing, as
    /// where a ray passes between two triangles. `bodies`: of this scene; `surfaces`: what is found.
    void surfaces_before(const vec3& point, const Ignore& ignore, int most, const SceneBodies& bodies,
                         std::vector<Hit>& surfaces) const;

    /// The nearest surface beyond `point` on the ray from the eye through it.
    std::optional<Hit> behind(const vec3& point, const Ignore& ignore) const;

    /// The first surface seen at a pixel position, with t as view-space distance along -z.
    std::optional<Hit> seen(const dvec2& px) const;

    /// Throws std::invalid_argument where a surface has moved since: its triangles are no longer those of the rays.
    void check_current() const;

    /// What is ignored at a place of a placement's surface (Surface::place); for a line on two surfaces also the facet
    /// of the second, numbered over the scene; `contour`: where the smooth surface turns away from the viewer.
    Ignore ignore_at(Index placement, Index place, Index other_facet = none, bool contour = false) const;

    const View& view() const { return view_; }
    const Scene& scene() const { return scene_; }
    /// What a hit hides in one piece: the triangle, or the flat convex quadrilateral that it makes with the next
    /// triangle of its facet.
    Outline outline(const Hit& hit) const;

   private:
    /// Corners of a triangle in view space.
    void corners(Index placement, Index triangle, dvec3 out[3]) const;
    /// The way from the eye, or the near plane, to a point; empty (far_t <= near_t) where the point lies before it.
    Ray ray_to(const vec3& point) const;
    /// Whether a hit on the ray lies before its end, measured in double precision where that is in doubt.
    bool surely_before(const Hit& hit, const Ray& ray) const;
    /// Share of the way along the ray at which it meets the plane of the triangle hit.
    double plane_share(const Hit& hit, const Ray& ray) const;

    struct Count;
    struct Bvh;
    const Scene& scene_;
    View view_;
    dmat4 clip_to_view_;
    std::unique_ptr<Bvh> bvh_;
};

}  // namespace fovea::scene
