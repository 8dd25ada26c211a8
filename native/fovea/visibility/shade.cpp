// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/visibility/shade.h>

#include <algorithm>
#include <optional>
#include <string_view>

#include <fovea/base/check.h>
#include <fovea/base/view.h>
#include <fovea/line/registry.h>
#include <fovea/visibility/exact.h>
#include <fovea/visibility/segment.h>

namespace fovea::visibility {
namespace {

constexpr std::size_t runs_per_block = 32;
/// Distance from an edge at which its faces are looked at, as a factor on how far rays begin above them.
constexpr double beside = 4.0;

dvec3 unit_or_zero(const dvec3& v) {
    const double length = glm::length(v);
    return length > 0.0 ? v / length : dvec3(0.0);
}

/// Triangles of each facet of a surface.
struct FacetTriangles {
    Lists<Index> of;

    explicit FacetTriangles(const Surface& surface)
        : of(lists_of<Index>(surface.facet_count(), [&](const auto& give) {
              for (Index t = 0; t < surface.triangles.size(); ++t) give(surface.triangle_facet[t], t);
          })) {}
};

Kinds bit_of(std::string_view definition) { return kind_of(*line_definitions()[definition_index(definition)]); }

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
        if (placement != placement_) {
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
class Along {
   public:
    Along(const ClippedPaths& clipped, const Paths& paths, const Scene& scene, const Shades& shades,
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
            const dvec3 near = point + beside * side.surface->lift() * side.inwards;
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
        if (paths_.kinds[source] & light_contours_) fixed_ = Shade::attached;
        if (paths_.kinds[source] & cast_shadows_) fixed_ = Shade::cast;
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

    const FacetTriangles& triangles_of(const Surface& surface) {
        if (&surface != listed_) {
            triangles_ = surface.cache().get<FacetTriangles>(0, [&] { return FacetTriangles(surface); });
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
    const Kinds light_contours_ = bit_of("light_contour"), cast_shadows_ = bit_of("cast_shadow");
    Placed first_, second_;
    Index segment_ = none, placement_ = none;
    std::optional<Shade> fixed_;
    dvec3 from_{0.0}, to_{0.0};
    double from_view_ = 0.0, to_view_ = 0.0;
    std::vector<Side> sides_;
    bool contour_ = false;  // of the smooth surface
    const Surface* listed_ = nullptr;
    std::shared_ptr<const FacetTriangles> triangles_;
};

/// Cuts one run where along.at(arc) changes.
class Cutter {
   public:
    Cutter(const ClippedPaths& clipped, Along& along, double gap_px, ShadedRuns& out)
        : clipped_(clipped), along_(along), gap_(gap_px), out_(out) {}

    void cut(const Runs& runs, std::size_t run) {
        piece_ = runs.piece[run];
        parts_.clear();
        const double end = runs.end_px[run];
        begin_ = runs.start_px[run];
        // At an end the faces around a corner meet: it is as what is right beside it.
        const double inset = std::min(0.5 * exact_tolerance_px, 0.25 * (end - begin_)), last = end - inset;
        before_ = begin_ + inset;
        shade_ = along_.at(piece_, before_);
        for (Index i = clipped_.segment_at(piece_, begin_); i + 1 < clipped_.pieces.end(piece_); ++i) {
            if (clipped_.arc_px[i] >= end) break;
            const double length = clipped_.arc_px[i + 1] - clipped_.arc_px[i];
            for (Index j = 0; j < clipped_.sample_count[i]; ++j) {
                const double here = clipped_.arc_px[i] + (j + 0.5) / clipped_.sample_count[i] * length;
                if (here > before_ && here < last) go_to(here);
            }
        }
        go_to(last);
        push(end);
        close_gaps();
        for (const Part& part : parts_) {
            if (part.end <= part.begin) continue;
            out_.runs.push(piece_, part.begin, part.end, runs.invisibility[run]);
            out_.shade.push_back(part.shade);
        }
    }

   private:
    /// Looks at the next place of the run.
    void go_to(double arc) {
        while (before_ < arc) {
            double same = before_, other = arc;
            Shade next = along_.at(piece_, arc);
            if (next == shade_) break;
            while (other - same > exact_tolerance_px) {
                const double middle = 0.5 * (same + other);
                const Shade here = along_.at(piece_, middle);
                if (here == shade_) {
                    same = middle;
                } else {
                    other = middle;
                    next = here;
                }
            }
            push(0.5 * (same + other));
            before_ = other;
            shade_ = next;
        }
        before_ = arc;
    }

    void push(double end) {
        parts_.push_back({begin_, end, shade_});
        begin_ = end;
    }

    /// Short parts between two of one shade become theirs.
    void close_gaps() {
        std::size_t count = 0;
        for (const Part& part : parts_) {
            if (count >= 2 && parts_[count - 2].shade == part.shade &&
                parts_[count - 1].end - parts_[count - 1].begin < gap_)
                parts_[--count - 1].end = part.end;
            else
                parts_[count++] = part;
        }
        parts_.resize(count);
    }

    struct Part {
        double begin, end;
        Shade shade;
    };
    const ClippedPaths& clipped_;
    Along& along_;
    double gap_;
    ShadedRuns& out_;
    std::vector<Part> parts_;
    Index piece_ = none;
    double begin_ = 0.0, before_ = 0.0;
    Shade shade_ = Shade::lit;
};

}  // namespace

ShadedRuns by_shade(const ClippedPaths& clipped, const Paths& paths, const Scene& scene, const View& view,
                    const Runs& runs, In<std::uint8_t> cut, double gap_px, const Cancel& cancel) {
    check_same_paths(clipped, paths, "shade");
    check_runs(clipped, runs);
    check(clipped.path.empty() || clipped.path.back() < cut.size(), "cut: one value per path expected");
    const Shades shades(scene);
    const dvec4 viewer = glm::inverse(view.world_to_view) * (view.orthographic ? dvec4(0, 0, 1, 0) : dvec4(0, 0, 0, 1));
    ShadedRuns all;
    for (const ShadedRuns& part : parallel_parts<ShadedRuns>(runs.size(), runs_per_block,
                                                             [&](ShadedRuns& out, std::size_t begin, std::size_t end) {
                                                                 Along along(clipped, paths, scene, shades, viewer);
                                                                 Cutter cutter(clipped, along, gap_px, out);
                                                                 for (std::size_t r = begin; r < end; ++r) {
                                                                     cancel.poll();
                                                                     if (cut[clipped.path[runs.piece[r]]])
                                                                         cutter.cut(runs, r);
                                                                 }
                                                             })) {
        all.runs.append(part.runs);
        all.shade.insert(all.shade.end(), part.shade.begin(), part.shade.end());
    }
    return all;
}

}  // namespace fovea::visibility
