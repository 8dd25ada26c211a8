// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/path/append.h>

#include <algorithm>
#include <limits>

#include <fovea/base/hash.h>

namespace fovea::path {
namespace {

void resize(Paths& paths, Index path_count, Index point_count) {
    paths.rows.offsets.resize(path_count + 1);
    paths.rows.offsets[path_count] = point_count;
    resize_columns(paths, Paths::path_columns, path_count);
    resize_columns(paths, Paths::point_columns, point_count);
}

/// Where a point of a triangle, or right beside it, is in the surface's rest shape.
dvec3 rest_of(const Surface& surface, Index triangle, const dvec3& point) {
    const Triangle& t = surface.triangles[triangle];
    const dvec3 normal = area_vector(surface.positions, t);
    dvec3 weight;
    for (int k = 0; k < 3; ++k) {
        const dvec3 a(surface.positions[t[(k + 1) % 3]]), b(surface.positions[t[(k + 2) % 3]]);
        weight[k] = std::max(glm::dot(glm::cross(b - a, point - a), normal), 0.0);
    }
    const double sum = weight.x + weight.y + weight.z;
    weight = sum > 0.0 ? weight / sum : dvec3(1.0 / 3.0);
    dvec3 at_rest(0.0);
    for (int k = 0; k < 3; ++k) at_rest += weight[k] * dvec3(surface.rest()[t[k]]);
    return at_rest;
}

}  // namespace

void Appender::look_at(Index placement) {
    if (placement == placement_) return;
    placement_ = placement;
    object_to_view_ =
        placement == none ? dmat4(1.0) : view_.world_to_view * scene_.placements[placement].object_to_world;
    object_to_clip_ = view_.view_to_clip * object_to_view_;
}

double Appender::length_px(const vec3& a, const vec3& b) const {
    dvec2 px[2];
    for (int i = 0; i < 2; ++i) {
        const dvec4 point(dvec3(i ? b : a), 1.0);
        if (-(object_to_view_ * point).z < view_.near_clip) return std::numeric_limits<double>::infinity();
        px[i] = to_pixels(view_, object_to_clip_ * point);
    }
    return glm::distance(px[0], px[1]);
}

template <typename Point>
Appender::Slot Appender::add_rows(Index placement, const Rows& rows, bool of_view, const Point& point, Paths& paths) {
    look_at(placement);
    const Slot slot{placement, paths.count(), of_view};
    Index points = paths.rows.offsets.back();
    chosen_.clear();
    for (Index c = 0; c < rows.count(); ++c) {
        const Index begin = rows.begin(c), count = rows.size(c);
        if (least_px_ > 0.0 && count == 2 && length_px(point(begin), point(begin + 1)) <= least_px_) continue;
        chosen_.push_back(c);
        paths.rows.offsets.push_back(points += count);
    }
    resize(paths, slot.path + static_cast<Index>(chosen_.size()), points);
    return slot;
}

/// line_set, free and id take a chain; point takes a point of the chains, at_rest too, and more(to, from) writes the
/// rest of it.
template <typename Chains, typename LineSet, typename Free, typename Id, typename Point, typename AtRest, typename More>
void Appender::write(const Chains& chains, Slot slot, const LineSet& line_set, const Free& free, const Id& id,
                     const Point& point, const AtRest& at_rest, const More& more, Paths& paths) const {
    parallel_for(chosen_.size(), 256, [&](std::size_t k) {
        const Index c = chosen_[k], begin = chains.rows.begin(c);
        const std::size_t p = slot.path + k, to = paths.rows.offsets[p];
        paths.closed[p] = chains.closed[c];
        paths.line_set[p] = line_set(c);
        paths.free_ends[p] = free(c);
        paths.of_view[p] = slot.of_view;
        paths.placement[p] = slot.placement;
        paths.id[p] = id(c);
        double arc = 0.0;
        dvec3 last(0.0);
        for (Index i = 0; i < chains.rows.size(c); ++i) {
            const dvec3 here = at_rest(begin + i);
            if (i > 0) arc += glm::distance(last, here);
            last = here;
            paths.points_obj[to + i] = point(begin + i);
            paths.arc_obj[to + i] = arc;
            more(to + i, begin + i);
        }
    });
}

void Appender::append(Index placement, const EdgeChains& found, bool of_view, Paths& paths) {
    const Chains& chains = *found.chains;
    const Surface& surface = *scene_.placements[placement].surface;
    const std::uint64_t object = scene_.placements[placement].id;
    const auto point = [&](Index i) { return surface.positions[chains.vertex[i]]; };
    const Slot slot = add_rows(placement, chains.rows, of_view, point, paths);
    write(
        chains, slot, [&](Index c) { return chains.label[c]; }, [&](Index c) { return found.free[c]; },
        [&](Index c) { return hash_numbers(object, chains.anchor[c]); }, point,
        [&](Index i) { return dvec3(surface.rest().empty() ? point(i) : surface.rest()[chains.vertex[i]]); },
        [&](std::size_t to, Index i) {
            paths.place[to] = chains.edge[i];
            paths.edge_t[to] = surface.edges[chains.edge[i]].x == chains.vertex[i] ? 0.0f : 1.0f;
            paths.kinds[to] = found.kinds[i];
            paths.strength[to] = 1.0f;
            paths.other_facet[to] = none;
        },
        paths);
}

void Appender::append(Index placement, const FoundCurves& found, bool of_view, Paths& paths) {
    const Placement* placed = placement == none ? nullptr : &scene_.placements[placement];
    const CurveChains& chains = *found.chains;
    std::uint64_t object = placed ? placed->id : 0;
    if (found.other != none && found.other != placement)
        object = hash_numbers(object, scene_.placements[found.other].id);
    const auto point = [&](Index i) { return chains.point[i]; };
    const Slot slot = add_rows(placement, chains.rows, of_view, point, paths);
    write(
        chains, slot, [&](Index) { return found.line_set; },
        [&](Index c) { return line_definitions()[found.definition]->ends_at_lines ? 0 : chains.free[c]; },
        [&](Index c) { return hash_numbers(object, found.definition + 1, chains.anchor[c]); }, point,
        [&](Index i) {
            const dvec3 here(point(i));
            const bool deformed = placed && !placed->surface->rest().empty();
            return deformed ? rest_of(*placed->surface, chains.triangle[i], here) : here;
        },
        [&](std::size_t to, Index i) {
            paths.place[to] = placed ? placed->surface->place_of_triangle(chains.triangle[i]) : none;
            paths.edge_t[to] = 0.0f;
            paths.kinds[to] = Kinds(1) << found.definition;
            paths.strength[to] = chains.strength[i];
            const Index other = found.other == none ? placement : found.other;
            paths.other_facet[to] =
                chains.other[i] == none || other == none
                    ? none
                    : scene_.facet_base[other] + scene_.placements[other].surface->triangle_facet[chains.other[i]];
        },
        paths);
    const auto* rule = std::get_if<CurveRule>(&line_definitions()[found.definition]->rule);
    if (rule && rule->type == CurveType::tone)
        std::fill_n(paths.of_view.begin() + slot.path, chosen_.size(), makes_tone);
    if (of_view && (smooth_contours() >> found.definition & 1))
        std::fill_n(paths.of_view.begin() + slot.path, chosen_.size(), ends_at_cusps);
}

Paths join(std::vector<Paths>& parts) {
    std::vector<Index> paths, points;
    for (const Paths& part : parts) {
        paths.push_back(part.count());
        points.push_back(part.rows.offsets.back());
    }
    counts_to_offsets(paths);
    counts_to_offsets(points);
    Paths all;
    resize(all, paths.back(), points.back());
    parallel_for(parts.size(), 1, [&](std::size_t i) {
        const Paths part = std::move(parts[i]);
        for (Index p = 0; p < part.count(); ++p) all.rows.offsets[paths[i] + p] = points[i] + part.rows.begin(p);
        copy_columns(part, Paths::path_columns, all, paths[i]);
        copy_columns(part, Paths::point_columns, all, points[i]);
    });
    return all;
}

}  // namespace fovea::path
