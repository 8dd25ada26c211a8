// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/path/extract.h>

#include <algorithm>
#include <bit>
#include <iterator>
#include <variant>

#include <fovea/base/hash.h>
#include <fovea/field/fields.h>
#include <fovea/mesh/stretch.h>
#include <fovea/path/doubles.h>
#include <fovea/path/find_curves.h>
#include <fovea/path/find_edges.h>

namespace fovea::path {
namespace {

/// Margin around the frame, as a share of its half size: strokes must not end visibly at the border.
constexpr double frame_margin = 0.1;

/// Lines of one placement.
struct PlacementPaths {
    std::shared_ptr<const EdgePaths> edges;
    std::shared_ptr<const std::vector<FoundCurves>> kept_curves;  // those that depend on the surface alone
    std::vector<FoundCurves> seen_curves;
};

std::uint64_t hash_sets(const std::vector<PlacedSet>& sets) {
    std::uint64_t hash = sets.size();
    for (const PlacedSet& set : sets) {
        hash = hash_numbers(hash, set.kinds.size(), std::bit_cast<std::uint64_t>(set.corner_angle_rad));
        hash = hash_of(In<std::uint8_t>(set.materials), hash);
        for (const LineKind& kind : set.kinds)
            hash = hash_of(In<double>(kind.values), hash_numbers(hash, kind.definition));
    }
    return hash;
}

/// Whether a set (LineSet or PlacedSet) requests a definition for which holds(definition) is true.
template <typename Sets, typename Holds>
bool any_asked(const Sets& sets, const Holds& holds) {
    const auto by_kind = [&](const LineKind& kind) { return holds(*line_definitions()[kind.definition]); };
    return std::ranges::any_of(sets, [&](const auto& set) { return std::ranges::any_of(set.kinds, by_kind); });
}

/// Whether a set requests a definition on mesh edges that is view-independent (`of_surface`) or view-dependent.
bool any_marks_edges(const std::vector<PlacedSet>& sets, bool of_surface) {
    return any_asked(sets, [&](const LineDefinition& definition) {
        return std::holds_alternative<EdgeRule>(definition.rule) && (definition.scope == Scope::surface) == of_surface;
    });
}

/// Eye position in object space; for an orthographic view the direction towards the viewer.
dvec3 eye_of(const View& view, const Placement& placed) {
    const dmat4 view_to_object = glm::inverse(view.world_to_view * placed.object_to_world);
    return dvec3(view_to_object * (view.orthographic ? dvec4(0, 0, 1, 0) : dvec4(0, 0, 0, 1)));
}

/// The view of a placement. `surface`: the placement's, pre-stretched (as_placed).
SurfaceView look_at(const Surface& surface, const Scene& scene, Index placement, const View& view,
                    const Tracer& tracer) {
    const Placement& placed = scene.placements[placement];
    return {.surface = surface,
            .eye_obj = surface.stretch() * eye_of(view, placed),
            .orthographic = view.orthographic,
            .placement = placement,
            .object_to_view = view.world_to_view * placed.object_to_world * dmat4(glm::inverse(surface.stretch())),
            .tracer = &tracer};
}

/// Whether a set requests view-dependent features, which a contour may duplicate.
bool any_beside_contours(const std::vector<PlacedSet>& sets) {
    return any_asked(sets, [](const LineDefinition& definition) {
        const auto* rule = std::get_if<CurveRule>(&definition.rule);
        return definition.scope != Scope::surface && rule && rule->type == CurveType::feature;
    });
}

/// Per triangle: 1 if no set requests any of `kinds` on its material; empty if there is no such triangle.
Array<std::uint8_t> triangles_without(const Surface& surface, const std::vector<PlacedSet>& sets, Kinds kinds) {
    if (!any_by_material(sets)) return {};
    std::vector<const PlacedSet*> asking;
    for (const PlacedSet& set : sets)
        if (asked_of(set) & kinds) asking.push_back(&set);
    return path::triangles_without(surface, [&](int material) {
        return std::ranges::any_of(asking, [&](const PlacedSet* set) { return set->has_material(material); });
    });
}

/// Per vertex: 1 beside the smooth contours that are drawn.
Array<std::uint8_t> near_drawn(const Surface& surface, const PlacementPaths& paths) {
    std::vector<const CurveChains*> drawn;
    for (const FoundCurves& curves : paths.seen_curves)
        if (smooth_contours() >> curves.definition & 1) drawn.push_back(curves.chains.get());
    return near_curves(surface, drawn);
}

PlacementPaths extract_placement(const SurfaceView& seen, const std::vector<PlacedSet>& sets, std::uint64_t sets_hash,
                                 bool view_dependent) {
    Cache& cache = seen.surface.cache();
    PlacementPaths paths;
    Array<std::uint8_t> near;
    const Kinds asked = asked_of(sets);
    if (view_dependent && (asked & contours()) && any_beside_contours(sets))
        near = near_smooth_contour(seen, triangles_without(seen.surface, sets, contours()));
    const bool edges_of_view = any_marks_edges(sets, false);
    FoundEdges edges;
    if (edges_of_view) edges = find_edges(seen, sets, sets_hash, true);
    paths.kept_curves = cache.get<std::vector<FoundCurves>>(
        sets_hash, [&] { return find_curves({.surface = seen.surface}, sets, true); });
    if (view_dependent) paths.seen_curves = find_curves(seen, sets, false, near, edges.hard);
    if (edges_of_view) {
        const Array<std::uint8_t> drawn =
            edges.doubled.empty() ? Array<std::uint8_t>() : near_drawn(seen.surface, paths);
        paths.edges = std::make_shared<const EdgePaths>(chain_edges(seen, sets, sets_hash, std::move(edges), drawn));
    } else if (any_marks_edges(sets, true)) {
        paths.edges = cache.get<EdgePaths>(sets_hash, [&] {
            return chain_edges(seen, sets, sets_hash, find_edges(seen, sets, sets_hash, false), {});
        });
    }
    return paths;
}

/// Where the chains of one placement (`none`: of the frame) are written in the result, and whether they are
/// view-dependent.
struct Slot {
    Index placement, path, point;
    bool of_view;
};

/// Writes the columns that chains of edges and of curves have in common. line_set, free and id take a chain's index;
/// point takes a point's index over all chains.
template <typename Chains, typename LineSet, typename Free, typename Id, typename Point>
void write_paths(const Chains& chains, Slot slot, const LineSet& line_set, const Free& free, const Id& id,
                 const Point& point, Paths& paths) {
    parallel_for(chains.rows.count(), [&](std::size_t c) {
        const std::size_t p = slot.path + c;
        paths.rows.offsets[p] = slot.point + chains.rows.begin(c);
        paths.closed[p] = chains.closed[c];
        paths.line_set[p] = line_set(c);
        paths.free_ends[p] = free(c);
        paths.of_view[p] = slot.of_view;
        paths.placement[p] = slot.placement;
        paths.id[p] = id(c);
        double arc = 0.0;
        for (Index i = chains.rows.begin(c); i < chains.rows.end(c); ++i) {
            if (i > chains.rows.begin(c)) arc += glm::distance(dvec3(point(i - 1)), dvec3(point(i)));
            paths.points_obj[slot.point + i] = point(i);
            paths.arc_obj[slot.point + i] = arc;
        }
    });
}

void write_found(const Scene& scene, const EdgeChains& found, Slot slot, Paths& paths) {
    const Chains& chains = *found.chains;
    const Placement& placement = scene.placements[slot.placement];
    const Surface& surface = *placement.surface;
    write_paths(
        chains, slot, [&](std::size_t c) { return chains.label[c]; }, [&](std::size_t c) { return found.free[c]; },
        [&](std::size_t c) { return hash_numbers(placement.id, chains.anchor[c]); },
        [&](Index i) { return surface.positions[chains.vertex[i]]; }, paths);
    parallel_for(chains.vertex.size(), [&](std::size_t i) {
        const std::size_t n = slot.point + i;
        paths.place[n] = chains.edge[i];
        paths.edge_t[n] = surface.edges[chains.edge[i]].x == chains.vertex[i] ? 0.0f : 1.0f;
        paths.kinds[n] = found.kinds[i];
        paths.strength[n] = 1.0f;
        paths.other_facet[n] = none;
    });
}

void write_found(const Scene& scene, const FoundCurves& found, Slot slot, Paths& paths) {
    const Placement* placement = slot.placement == none ? nullptr : &scene.placements[slot.placement];
    const CurveChains& chains = *found.chains;
    std::uint64_t id = placement ? placement->id : 0;
    if (found.other != none && found.other != slot.placement) id = hash_numbers(id, scene.placements[found.other].id);
    write_paths(
        chains, slot, [&](std::size_t) { return found.line_set; }, [&](std::size_t c) { return chains.free[c]; },
        [&](std::size_t c) { return hash_numbers(id, found.definition + 1, chains.anchor[c]); },
        [&](Index i) { return chains.point[i]; }, paths);
    if (slot.of_view && (smooth_contours() >> found.definition & 1))
        std::fill_n(paths.of_view.begin() + slot.path, chains.rows.count(), ends_at_cusps);
    parallel_for(chains.point.size(), [&](std::size_t i) {
        const std::size_t n = slot.point + i;
        paths.place[n] = placement ? placement->surface->place_of_triangle(chains.triangle[i]) : none;
        paths.edge_t[n] = 0.0f;
        paths.kinds[n] = Kinds(1) << found.definition;
        paths.strength[n] = chains.strength[i];
        paths.other_facet[n] = found.other == none
                                   ? none
                                   : scene.facet_base[found.other] +
                                         scene.placements[found.other].surface->triangle_facet[chains.other[i]];
    });
}

void resize(Paths& paths, Index path_count, Index point_count) {
    paths.rows.offsets.resize(path_count + 1);
    paths.rows.offsets[path_count] = point_count;
    resize_columns(paths, Paths::path_columns, path_count);
    resize_columns(paths, Paths::point_columns, point_count);
}

/// Appends what was found on a placement (`none`: in the image).
template <typename Found>
void append(const Scene& scene, Index placement, const Found& found, bool of_view, Paths& paths) {
    const Slot slot{placement, paths.count(), paths.rows.offsets.back(), of_view};
    resize(paths, slot.path + found.chains->rows.count(), slot.point + found.chains->rows.offsets.back());
    write_found(scene, found, slot, paths);
}

/// In at most 256 blocks, the Paths that write(paths, i) appends for each i; independent of the number of threads.
template <typename Write>
std::vector<Paths> paths_of(std::size_t count, const Write& write) {
    return parallel_parts<Paths>(count, count / 256 + 1, [&](Paths& part, std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) write(part, i);
    });
}

/// Concatenates parts; each is freed once it is copied.
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

}  // namespace

Paths extract_paths(const Scene& scene, const View& view, const std::vector<LineSet>& sets, const Tracer& tracer,
                    const Cancel& cancel, const OwnLines& own) {
    check(sets.size() < 255, "a style holds at most 254 line sets");
    if (sets.empty()) return {};
    tracer.check_current();
    check_filters(scene.placements.size(), sets, own);
    const bool view_dependent =
        any_asked(sets, [](const LineDefinition& definition) { return definition.scope >= Scope::view; });
    std::vector<Index> drawn;
    for (Index i = 0; i < scene.placements.size(); ++i)
        if ((scene.placements[i].usage & usage_draw) && in_frame(scene.placements[i], view, frame_margin))
            drawn.push_back(i);

    std::vector<Paths> parts = paths_of(drawn.size(), [&](Paths& part, std::size_t i) {
        cancel.poll();
        const Index placement = drawn[i];
        const Placement& placed = scene.placements[placement];
        const auto surface = as_placed(placed.surface, placed.object_to_world);
        const std::vector<PlacedSet> mine = sets_of(placement, *surface, sets, own);
        const std::uint64_t asked = hash_numbers(hash_sets(mine), hash_of(surface->field_options()),
                                                 static_cast<std::uint64_t>(surface->shape()));
        const PlacementPaths found =
            extract_placement(look_at(*surface, scene, placement, view, tracer), mine, asked, view_dependent);
        if (found.edges) {
            append(scene, placement, found.edges->kept, false, part);
            append(scene, placement, found.edges->seen, true, part);
        }
        for (const FoundCurves& c : *found.kept_curves) append(scene, placement, c, false, part);
        for (const FoundCurves& c : found.seen_curves) append(scene, placement, c, true, part);
    });
    const std::vector<FoundCurves> in_image = find_curves_in_image(sets, tracer, cancel);
    const auto of_scene = find_curves_in_scene(scene, drawn, sets, own, cancel);
    const auto take = [&](std::vector<Paths> more) { std::ranges::move(more, std::back_inserter(parts)); };
    take(paths_of(in_image.size(), [&](Paths& part, std::size_t i) { append(scene, none, in_image[i], true, part); }));
    take(paths_of(of_scene.size(), [&](Paths& part, std::size_t i) {
        append(scene, of_scene[i].first, of_scene[i].second, false, part);
    }));
    return join(parts);
}

}  // namespace fovea::path
