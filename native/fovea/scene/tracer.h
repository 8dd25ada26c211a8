// SPDX-License-Identifier: GPL-3.0-or-later
// Ray casting in a scene, from a view. Wraps scene/bvh, the only code that uses Embree.
#pragma once

#include <array>
#include <memory>
#include <optional>

#include <fovea/scene/bodies.h>

namespace fovea::scene {

/// Self-hit filter: triangles that a visibility ray ignores.
/// (a) for a line on a mesh edge: those of the facets at the edge;
/// (b) for a line on two surfaces: those of both facets;
/// (c) for a line across a triangle: those that share a vertex with it;
/// (d) for a contour of the smooth surface, which runs next to that of the mesh and often inside the mesh: also all of
///     its surface along the ray within `reach`, twice the longest side of its triangle, but for other solids before
///     it, which hide it however close. So folds closer than that do not hide their own contours, and large triangles
///     next to a sliver still break one for a few pixels; test_contour_visibility.cpp measures the error.
struct Ignore {
    Index placement = none;
    const EdgeSide* begin = nullptr;
    const EdgeSide* end = nullptr;
    Triangle around{none, none, none};  ///< its vertices; `none`: the line lies on an edge
    float reach = 0.0f;                 ///< view-space length
    const Bodies* bodies = nullptr;     ///< of its surface, and the component that it is on; with `reach`
    Index body = none;
    /// Offset of the ray's target from the surface, in view space, so that the roughness of the mesh does not hide
    /// lines across triangles. At a contour it lies in the image plane.
    vec3 above{0.0f};
    Index facet = none;  ///< for a line on two surfaces: facet of the first; below, that of the second
    Index other_placement = none, other_facet = none;

    bool across_triangles() const { return around.x != none; }
    /// Whether rays alone tell what a placement's surface hides: they handle how near a line across triangles is to its
    /// own surface.
    bool leaves_to_rays(Index of) const { return of == placement && across_triangles(); }
    /// Whether a facet of the placement's surface is not of another solid than the line. Shells may be the patches of
    /// one shape.
    bool is_own(Index of_facet) const {
        if (!bodies || body == none || bodies->of_facet[of_facet] == body) return true;
        return !bodies->solid[body] || !bodies->solid[bodies->of_facet[of_facet]];
    }
    /// Whether triangle `triangle` of placement `of` is in (a), (b) or (c). `surface`: that of the placement.
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

/// Intersection of a ray and a triangle.
struct Hit {
    Index placement;
    Index triangle;
    /// Ray parameter; for visibility rays, the share of the way from the eye to the target.
    double t;
    /// Barycentric coordinates: weights of the triangle's second and third corner.
    float u = 0.0f, v = 0.0f;
};

/// What was in the way of a ray, for the next one.
struct Blocker {
    Index instance = none, triangle = none;  ///< of the tracer's BVH
};

/// A planar convex polygon of three to five corners, in order, in view space; of none: nothing is known.
struct Outline {
    dvec3 corners[5];
    int count = 3;
    Index triangle = none, other = none;  ///< the triangles that it consists of, indices into the hit's surface
};

/// A surface hides a point only if it is closer by more than this share of the point's distance, so that lines on a
/// surface, or on two that touch, are not hidden by it.
inline constexpr double ray_margin = 1e-5;

/// A ray segment: points origin + t * direction with near_t <= t <= far_t.
struct Ray {
    dvec3 origin, direction;
    double near_t, far_t;
};

/// Ray caster over two levels: one BVH per surface, cached with the surface, and one over the placements, in view
/// space. What the section plane cuts away is not there for rays. Const methods are thread-safe. The scene must outlive
/// the tracer.
class Tracer {
   public:
    struct Bvh;

    /// Skips placements that do not occlude (holdouts do) or are outside the frame widened by 10 %.
    Tracer(const Scene& scene, const View& view);
    ~Tracer();
    Tracer(const Tracer&) = delete;
    Tracer& operator=(const Tracer&) = delete;

    /// The surface nearest to the eye that hides `point` (view space). Surfaces before the near plane are clipped.
    std::optional<Hit> occluder(const vec3& point, const Ignore& ignore) const;

    /// Surfaces that hide `point`, at most `most`, one hit each: a solid counts once per passage through it, an open
    /// shell once per crossing. Hits on the same component closer together than ray_margin count as one, as where a
    /// ray passes between two triangles. `bodies`: of this scene. `surfaces`: output.
    void surfaces_before(const vec3& point, const Ignore& ignore, int most, const SceneBodies& bodies,
                         std::vector<Hit>& surfaces) const;

    /// The nearest surface on the ray from the eye through `point`, wherever, but from `near_t` on; t is above 1 beyond
    /// the point. In double precision.
    std::optional<Hit> along(const dvec3& point, const Ignore& ignore, double near_t = 0.0) const;

    /// Whether any surface is on the way from `origin` to `point`, before the share `before` of it: wherever both are,
    /// if the view has no near plane, else `origin` is the eye. In double precision. `last`: in the way of a ray like
    /// it, which is asked first; then what is in the way of this.
    bool is_blocked(const dvec3& origin, const dvec3& point, double before, const Ignore& ignore, Blocker& last) const;

    /// The nearest surface beyond `point` on the ray from the eye through it.
    std::optional<Hit> behind(const vec3& point, const Ignore& ignore) const;

    /// Whether that surface is of the placement, or of one that shares its outline.
    bool continues_behind(const vec3& point, const Ignore& ignore, Index placement) const;

    /// The nearest surface under a pixel position; its t is view-space distance along -z.
    std::optional<Hit> seen(const dvec2& px) const;

    /// Throws std::invalid_argument if a surface has moved since the tracer was made: the BVH would not match its
    /// triangles.
    void check_current() const;

    /// The filter for a line on an element of a placement's surface (Surface::place_of_triangle). `other_facet`: for a
    /// line on two surfaces, the facet on the second, numbered over the scene. `contour`: the line is a contour of the
    /// smooth surface.
    Ignore ignore_at(Index placement, Index place, Index other_facet = none, bool contour = false) const;

    const View& view() const { return view_; }
    const Scene& scene() const { return scene_; }
    /// Whether the section plane cuts a point away (view space).
    bool cuts_away(const dvec3& point) const;
    /// A planar convex piece around a hit: the triangle, or the quadrilateral that it forms with the next or
    /// previous triangle of its facet; without what the section plane cuts away.
    Outline outline(const Hit& hit) const;

   private:
    /// Side of a pixel in space at the nearest of a triangle's corners.
    double px_at(const std::array<dvec3, 3>& corners) const;
    /// Corners of a triangle, in view space.
    std::array<dvec3, 3> corners(Index placement, Index triangle) const;
    /// Ray from the eye, or from the near plane, to a point; empty (far_t <= near_t) if the point is before the near
    /// plane.
    Ray ray_to(const vec3& point) const;
    /// Ray from a point away from the eye.
    Ray ray_beyond(const vec3& point) const;
    /// The part of a ray behind the section plane; empty where there is none.
    Ray behind_section(Ray ray) const;
    std::optional<Hit> nearest(const Ray& ray, const Ignore& ignore) const;
    Outline behind_section(const Outline& whole) const;
    struct Count;

    const Scene& scene_;
    View view_;
    dmat4 clip_to_view_;
    std::optional<dvec4> section_;  // in view space
    std::unique_ptr<Bvh> bvh_;
};

/// Builds what a Tracer will need of a surface that hides; cached with it.
void prepare_rays(const Surface& surface);

}  // namespace fovea::scene
