// SPDX-License-Identifier: GPL-3.0-or-later
// Whether places of surfaces are lit, by rays towards the lights of their scene.
#pragma once

#include <memory>
#include <tbb/enumerable_thread_specific.h>
#include <vector>

#include <fovea/field/corner_normals.h>
#include <fovea/scene/tracer.h>

namespace fovea::scene {

/// How many lights count: the strongest that cast shadows (light_view.h), as for light contours and cast shadows.
inline constexpr std::size_t most_lights = 4;

/// What a light does to a place.
enum class Shade : std::uint8_t {
    lit,       ///< it shines on it
    attached,  ///< it is behind the surface there: attached shadow
    cast,      ///< something is between, or the place is beside the cone of a spot: cast shadow
};

/// A place of a surface, in the world.
struct ShadedPlace {
    dvec3 point{0.0};   ///< where rays begin: above the surface, so that its own faces do not hide it
    dvec3 normal{0.0};  ///< unit, on the side that is looked at; 0: of no surface, as on a loose edge
    Ignore ignore;      ///< what does not hide it
};

/// Places of one placement's surface. The side that is looked at is the outside of a solid; of an open shell the side
/// towards the viewer. Normals are those of the smooth surface where the polygons stand for one (field/shape.h), and
/// rays begin on it: where a mesh that bends outward is about to turn away from the light, its own faces would be in
/// the way of rays from points inside of it. Elsewhere normals are those of the facets.
class ShadedSurface {
   public:
    /// `viewer`: in the world, homogeneous; of an orthographic view the direction towards it. The scene must outlive
    /// it.
    ShadedSurface(const Scene& scene, Index placement, const dvec4& viewer);

    /// The place at a point (in the world) on a triangle, or near it in its plane. `contour`: it is on the contour of
    /// the smooth surface, where one sees the side to which that bends away from the viewer.
    ShadedPlace at(Index triangle, const dvec3& point, bool contour = false) const;
    /// A place on no facet, as of a loose edge.
    ShadedPlace without_facet(const dvec3& point) const { return {point, dvec3(0.0), {.placement = placement_}}; }
    /// Unit normal of a facet on the side that is looked at, in the world; 0 if it has no area.
    dvec3 facet_normal(Index facet) const;
    /// Whether that side of a facet is towards the viewer.
    bool faces_viewer(Index facet) const;
    /// How far rays begin above flat surfaces: 2^-19 of the size of its coordinates, which exceeds their rounding.
    double lift() const { return lift_; }

    const Surface& surface() const { return *surface_; }

   private:
    const Surface* surface_;
    Index placement_;
    dmat4 to_world_;
    dmat3 normals_to_world_;
    dvec4 viewer_, viewer_obj_;
    double lift_;
    std::shared_ptr<const Bodies> bodies_;
    std::shared_ptr<const field::CornerNormals> smooth_;  // null: facets are meant as they are

    bool is_solid(Index facet) const;
    bool is_turned(Index facet) const;
};

/// The lights of a scene that cast shadows, and rays to them. Thread-safe; the scene must outlive it.
class Shades {
   public:
    explicit Shades(const Scene& scene, std::size_t most = most_lights);
    /// Those of casting_lights.
    Shades(const Scene& scene, std::vector<Light> lights);

    /// Lights, the strongest first.
    std::size_t count() const { return lights_.size(); }
    const Light& light(std::size_t number) const { return lights_[number]; }

    /// What one light does to a place.
    Shade by(std::size_t light, const ShadedPlace& place) const;
    /// Whether parts of a light differ.
    bool has_size(std::size_t light) const;
    /// What all do: lit if one of them shines on it, or there is none; else in cast shadow if one would but for what is
    /// between; else in attached shadow.
    Shade at(const ShadedPlace& place) const;
    /// The same for many, in parallel.
    Array<Shade> at(In<ShadedPlace> places) const;

   private:
    friend class PlaceByLight;
    std::vector<Light> lights_;
    std::vector<std::unique_ptr<const Tracer>> tracers_;  // per light, which is their eye
    /// Per light what hid it last: it mostly hides it from the next place, too. Does not change what is told.
    mutable tbb::enumerable_thread_specific<std::vector<Blocker>> last_;
};

/// A place as one light sees it, for one thread. The place and the Shades must outlive it.
class PlaceByLight {
   public:
    PlaceByLight(const Shades& shades, std::size_t light, const ShadedPlace& place);

    /// What the middle of the light does to it.
    Shade by_middle() const { return by(dvec3(0.0)); }
    /// What a part of it does: of an area at this share of its half sides, each in [-1, 1]; of points, spots and suns
    /// on the disk that is seen of them, into which the square is taken evenly.
    Shade by_part(const dvec2& part) const;

   private:
    /// `moved`: from the eye, in the view of the light; of a sun from the direction to it.
    Shade by(const dvec3& moved) const;

    const Light& light_;
    const Tracer& tracer_;
    const ShadedPlace& place_;
    Blocker* last_;                           // of this thread
    dvec3 seen_, normal_;                     // in the view of the light
    dvec3 across_[2] = {dvec3(0), dvec3(0)};  // of the light: its half sides, or axes of its disk
};

}  // namespace fovea::scene
