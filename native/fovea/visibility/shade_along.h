// SPDX-License-Identifier: GPL-3.0-or-later
// The shade of lines: of the surfaces beside them.
#pragma once

#include <algorithm>
#include <bit>
#include <optional>
#include <vector>

#include <fovea/base/parallel.h>
#include <fovea/base/view.h>
#include <fovea/line/registry.h>
#include <fovea/path/paths.h>
#include <fovea/project/clipped_paths.h>
#include <fovea/scene/shade.h>

namespace fovea::visibility {

/// Distance from an edge at which its faces are looked at, as a factor on how far rays begin above them.
inline constexpr double beside_edge = 4.0;

/// Triangles of each facet of a surface.
struct TrianglesOfFacets {
    Lists<Index> of;

    explicit TrianglesOfFacets(const Surface& surface)
        : of(lists_of<Index>(surface.facet_count(), [&](const auto& give) {
              for (Index t = 0; t < surface.triangles.size(); ++t) give(surface.triangle_facet[t], t);
          })) {}
};

/// A face beside a line: one of its triangles, and the way into it.
struct Side {
    const ShadedSurface* surface;
    Index triangle;
    dvec3 inwards;
};

/// Placements as light meets them, one at a time, as lines come one placement after the other.
class Placed {
   public:
    Placed(const Scene& scene, const dvec4& viewer) : scene_(scene), viewer_(viewer) {}

    const ShadedSurface& at(Index placement) {
        if (!surface_ || placement != placement_) {
            surface_.emplace(scene_, placement, viewer_);
            placement_ = placement;
        }
        return *surface_;
    }

   private:
    const Scene& scene_;
    dvec4 viewer_;
    Index placement_ = none;
    std::optional<ShadedSurface> surface_;
};

/// Shade along the segments of clipped paths.
class ShadeAlong {
   public:
    ShadeAlong(const ClippedPaths& clipped, const Paths& paths, const Scene& scene, const Shades& shades,
               const dvec4& viewer)
        : clipped_(clipped),
          paths_(paths),
          scene_(scene),
          shades_(shades),
          first_(scene, viewer),
          second_(scene, viewer) {}

    Shade at(Index piece, double arc) {
        const Index segment = clipped_.segment_at(piece, arc);
        look_at(piece, segment);
        if (fixed_) return *fixed_;
        const double on_screen = clipped_.share_at(segment, arc);
        const double t = clipped_.orthographic ? on_screen : share_in_space(on_screen, -from_view_, -to_view_);
        const dvec3 point = glm::mix(from_, to_, t);
        if (sides_.empty()) return shades_.at(first_.at(placement_).without_facet(point));
        Shade all = Shade::attached;
        for (const Side& side : sides_) {
            const dvec3 near = point + beside_edge * side.surface->lift() * side.inwards;
            const Shade one = shades_.at(side.surface->at(side.triangle, near, contour_));
            if (one == Shade::lit) return one;
            if (one == Shade::cast) all = one;
        }
        return all;
    }

   private:
    void look_at(Index piece, Index segment) {
        if (segment == segment_) return;
        segment_ = segment;
        placement_ = paths_.placement[clipped_.path[piece]];
        const Index source = clipped_.source[segment];
        fixed_.reset();
        if (placement_ == none) fixed_ = Shade::lit;
        for (Kinds kinds = paths_.kinds[source] & of_one_shade_; kinds; kinds &= kinds - 1)
            fixed_ = line_definitions()[std::countr_zero(kinds)]->shade;
        if (fixed_) return;
        from_ = in_world(segment);
        to_ = in_world(segment + 1);
        from_view_ = clipped_.position_view[segment].z;
        to_view_ = clipped_.position_view[segment + 1].z;
        find_sides(source);
    }

    /// A clipped point, in double precision.
    dvec3 in_world(Index point) const {
        const Index source = clipped_.source[point];
        dvec3 here(paths_.points_obj[source]);
        const double t = clipped_.source_t[point];
        if (t > 0.0) here = glm::mix(here, dvec3(paths_.points_obj[source + 1]), t);
        return dvec3(scene_.placements[placement_].object_to_world * dvec4(here, 1.0));
    }

    void find_sides(Index source) {
        const ShadedSurface& own = first_.at(placement_);
        const Surface& surface = own.surface();
        const Index place = paths_.place[source], other = paths_.other_facet_at(source);
        sides_.clear();
        contour_ = (paths_.kinds[source] & smooth_contours()) != 0;
        if (surface.is_edge(place))
            at_edge(own, place);
        else if (other != none)
            on_two(own, surface.triangle_at(place), other);
        else
            sides_.push_back({&own, surface.triangle_at(place), dvec3(0.0)});
        const auto faces = [](const Side& side) {
            return side.surface->faces_viewer(side.surface->surface().triangle_facet[side.triangle]);
        };
        if (std::ranges::any_of(sides_, faces)) std::erase_if(sides_, [&](const Side& side) { return !faces(side); });
        if (surface.is_edge(place) && sides_.size() == 2) leave_out_hidden();
    }

    /// Of two faces of a sheet that fold over each other the one before the other hides it.
    void leave_out_hidden() {
        const auto normal = [](const Side& side) {
            return side.surface->facet_normal(side.surface->surface().triangle_facet[side.triangle]);
        };
        const bool first_behind = glm::dot(normal(sides_[1]), sides_[0].inwards) < 0.0,
                   second_behind = glm::dot(normal(sides_[0]), sides_[1].inwards) < 0.0;
        if (first_behind != second_behind) sides_.erase(sides_.begin() + (second_behind ? 1 : 0));
    }

    const TrianglesOfFacets& triangles_of(const Surface& surface) {
        if (&surface != listed_) {
            triangles_ = surface.cache().get<TrianglesOfFacets>(0, [&] { return TrianglesOfFacets(surface); });
            listed_ = &surface;
        }
        return *triangles_;
    }

    void at_edge(const ShadedSurface& own, Index edge) {
        const Surface& surface = own.surface();
        const Edge& e = surface.edges[edge];
        const dvec3 along = dvec3(surface.positions[e.y]) - dvec3(surface.positions[e.x]);
        const dmat3 to_world(scene_.placements[placement_].object_to_world);
        for (const EdgeSide side : surface.sides(edge)) {
            const Index facet = side.facet();
            const In<Index> triangles = triangles_of(surface).of[facet];
            if (triangles.empty()) continue;
            const auto has = [&](Index triangle, Index vertex) {
                const Triangle& t = surface.triangles[triangle];
                return t.x == vertex || t.y == vertex || t.z == vertex;
            };
            const auto at_it = std::ranges::find_if(triangles, [&](Index t) { return has(t, e.x) && has(t, e.y); });
            // The facet is to the left of an edge along which it winds.
            const dvec3 left = glm::cross(dvec3(surface.facet_plane[facet]), along);
            const dvec3 inwards = unit_or_zero(to_world * (side.forward() ? left : -left));
            sides_.push_back({&own, at_it == triangles.end() ? triangles.front() : *at_it, inwards});
        }
    }

    /// Of a line on two surfaces each is looked at before the other.
    void on_two(const ShadedSurface& own, Index triangle, Index other_facet) {
        const auto& base = scene_.facet_base;
        const auto placement =
            static_cast<Index>(std::upper_bound(base.begin(), base.end(), other_facet) - base.begin() - 1);
        const ShadedSurface& other = placement == placement_ ? own : second_.at(placement);
        const Index facet = other_facet - base[placement], own_facet = own.surface().triangle_facet[triangle];
        const In<Index> triangles = triangles_of(other.surface()).of[facet];
        const dvec3 a = own.facet_normal(own_facet), b = other.facet_normal(facet);
        sides_.push_back({&own, triangle, unit_or_zero(b - glm::dot(a, b) * a)});
        if (!triangles.empty()) sides_.push_back({&other, triangles.front(), unit_or_zero(a - glm::dot(a, b) * b)});
    }

    const ClippedPaths& clipped_;
    const Paths& paths_;
    const Scene& scene_;
    const Shades& shades_;
    const Kinds of_one_shade_ = kinds_of_one_shade();
    Placed first_, second_;
    Index segment_ = none, placement_ = none;
    std::optional<Shade> fixed_;
    dvec3 from_{0.0}, to_{0.0};
    double from_view_ = 0.0, to_view_ = 0.0;
    std::vector<Side> sides_;
    bool contour_ = false;  // of the smooth surface
    const Surface* listed_ = nullptr;
    std::shared_ptr<const TrianglesOfFacets> triangles_;
};

}  // namespace fovea::visibility
