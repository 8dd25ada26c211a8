// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/path/extract.h>

#include <algorithm>
#include <bit>
#include <iterator>
#include <variant>

#include <fovea/base/hash.h>
#include <fovea/field/fields.h>
#include <fovea/line/look_at.h>
#include <fovea/mesh/stretch.h>
#include <fovea/path/append.h>
#include <fovea/path/doubles.h>
#include <fovea/scene/section.h>

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
        const Array<std::uint8_t> drawn = edges.doubled ? near_drawn(seen.surface, paths) : Array<std::uint8_t>();
        paths.edges = std::make_shared<const EdgePaths>(chain_edges(seen, sets, sets_hash, std::move(edges), drawn));
    } else if (any_marks_edges(sets, true)) {
        paths.edges = cache.get<EdgePaths>(sets_hash, [&] {
            return chain_edges(seen, sets, sets_hash, find_edges(seen, sets, sets_hash, false), {});
        });
    }
    return paths;
}

/// What line sets are for a surface.
struct Asked {
    std::shared_ptr<const Surface> surface;
    std::vector<PlacedSet> sets;
    std::uint64_t hash = 0;

    Asked() = default;
    Asked(std::shared_ptr<const Surface> of, std::vector<PlacedSet> placed)
        : surface(std::move(of)),
          sets(std::move(placed)),
          hash(hash_numbers(hash_sets(sets), hash_of(surface->field_options()),
                            static_cast<std::uint64_t>(surface->shape()))) {}
};

/// The Paths that append(part, begin, end) appends to for at most 256 blocks; independent of the number of threads.
template <typename Append>
std::vector<Paths> in_parts(std::size_t count, const Append& append) {
    return parallel_parts<Paths>(count, count / 256 + 1, append);
}

}  // namespace

Paths extract_paths(const Scene& scene, const View& view, const std::vector<LineSet>& sets, const Tracer& tracer,
                    const Cancel& cancel, const OwnLines& own, double least_px) {
    check(sets.size() < 255, "a style holds at most 254 line sets");
    if (sets.empty()) return {};
    tracer.check_current();
    check_filters(scene.placements.size(), sets, own);
    const bool of_view =
        any_asked(sets, [](const LineDefinition& definition) { return definition.scope >= Scope::view; });
    const Array<Index> drawn = parallel_where(scene.placements.size(), [&](Index i) {
        const Placement& placement = scene.placements[i];
        return (placement.usage & usage_draw) && in_frame(placement, view, frame_margin) &&
               cut_of(scene, placement).kept != Cut::nothing;
    });

    const bool alike = !varies_by_placement(sets, own);
    Cache shared;
    std::vector<Paths> parts = in_parts(drawn.size(), [&](Paths& part, std::size_t begin, std::size_t end) {
        Appender appender(scene, view, least_px);
        Asked asked;
        for (const Index placement : In<Index>(drawn).subspan(begin, end - begin)) {
            cancel.poll();
            const Placement& placed = scene.placements[placement];
            const auto surface = as_placed(placed.surface, placed.object_to_world);
            if (!alike || asked.surface != surface) asked = {surface, sets_of(placement, *surface, sets, own)};
            SurfaceView seen = look_at(*surface, placement, tracer);
            seen.shared = &shared;
            const PlacementPaths found = extract_placement(seen, asked.sets, asked.hash, of_view);
            if (found.edges) {
                appender.append(placement, found.edges->kept, false, part);
                appender.append(placement, found.edges->seen, true, part);
            }
            for (const FoundCurves& c : *found.kept_curves) appender.append(placement, c, false, part);
            for (const FoundCurves& c : found.seen_curves) appender.append(placement, c, true, part);
        }
    });
    const auto take = [&](const std::vector<std::pair<Index, FoundCurves>>& found, bool changes) {
        auto more = in_parts(found.size(), [&](Paths& part, std::size_t begin, std::size_t end) {
            Appender appender(scene, view, least_px);
            for (std::size_t i = begin; i < end; ++i) appender.append(found[i].first, found[i].second, changes, part);
        });
        std::ranges::move(more, std::back_inserter(parts));
    };
    std::vector<std::pair<Index, FoundCurves>> in_image;
    for (FoundCurves& curves : find_curves_in_image(sets, tracer, cancel))
        in_image.emplace_back(none, std::move(curves));
    take(in_image, true);
    take(find_curves_in_scene(scene, drawn, sets, own, cancel), false);
    return join(parts);
}

}  // namespace fovea::path
