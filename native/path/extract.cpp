#include "path/extract.h"

#include <algorithm>
#include <bit>
#include <glm/gtc/constants.hpp>
#include <numeric>

#include "base/hash.h"
#include "field/fields.h"
#include "mesh/stretch.h"
#include "path/chain.h"
#include "path/curves_of.h"
#include "path/doubles.h"

namespace fovea {
namespace {

/// Room around the frame, as a share of its half size: strokes must not end where one can see it.
constexpr double frame_margin = 0.1;
constexpr std::uint8_t unlabelled = 255;

/// Static kinds of a surface for one style: per line set and edge, and the edges that have any.
struct StaticLines {
    std::vector<Array<Kinds>> kinds;
    Array<Index> edges;
};

/// Curves across triangles that one definition finds for one line set.
struct FoundCurves {
    std::uint8_t line_set;
    Index definition;
    std::shared_ptr<const CurveChains> chains;
    Index other = none;  // the second placement on which they lie
};

/// Those of a style that depend on the surface alone.
struct StaticCurves {
    std::vector<FoundCurves> found;
};

/// Chains of edges: kept with the surface, and of this view; and their kinds by edge.
struct EdgePaths {
    std::shared_ptr<const Chains> kept;
    Chains seen;
    Array<Kinds> kept_kinds, seen_kinds;  // per point
    Array<std::uint8_t> kept_free, seen_free;  // per chain: FreeEnds
};

/// What one placement contributes.
struct PlacementPaths {
    std::shared_ptr<const EdgePaths> edges;
    std::shared_ptr<const StaticCurves> kept_curves;
    std::vector<FoundCurves> seen_curves;
};

std::uint64_t hash_sets(const std::vector<LineSet>& sets) {
    std::uint64_t hash = sets.size();
    for (const LineSet& set : sets) {
        hash = hash_numbers(hash, set.kinds.size(), std::bit_cast<std::uint64_t>(set.corner_angle_rad));
        for (const LineSet::Kind& kind : set.kinds)
            hash = hash_of(In<double>(kind.values), hash_numbers(hash, kind.definition));
    }
    return hash;
}

bool any_of_scope(const std::vector<LineSet>& sets, Scope least) {
    for (const LineSet& set : sets)
        for (const LineSet::Kind& kind : set.kinds)
            if (line_definitions()[kind.definition]->scope >= least) return true;
    return false;
}

/// Of definitions that mark edges, and hold for all views or depend on the view.
bool any_marks_edges(const std::vector<LineSet>& sets, bool of_surface) {
    for (const LineSet& set : sets)
        for (const LineSet::Kind& kind : set.kinds) {
            const LineDefinition& definition = *line_definitions()[kind.definition];
            if (definition.trace && (definition.scope == Scope::surface) == of_surface) return true;
        }
    return false;
}

void trace_kinds(const LineSet& set, const SurfaceView& seen, bool of_surface, Array<Kinds>& kinds) {
    for (const LineSet::Kind& kind : set.kinds) {
        const LineDefinition& definition = *line_definitions()[kind.definition];
        if (definition.trace && (definition.scope == Scope::surface) == of_surface)
            definition.trace(seen, kind.values, Kinds(1) << kind.definition, kinds);
    }
}

StaticLines find_static(const Surface& surface, const std::vector<LineSet>& sets) {
    StaticLines lines;
    const SurfaceView seen{.surface = surface};
    Array<std::uint8_t> any(surface.edges.size(), 0);
    for (const LineSet& set : sets) {
        Array<Kinds>& kinds = lines.kinds.emplace_back(surface.edges.size(), Kinds(0));
        trace_kinds(set, seen, true, kinds);
        parallel_for(kinds.size(), [&](std::size_t e) { any[e] |= kinds[e] != 0; });
    }
    for (Index e = 0; e < any.size(); ++e)
        if (any[e]) lines.edges.push_back(e);
    return lines;
}

void to_object(const dmat3& stretch, Array<vec3>& points) {
    const dmat3 inverse = glm::inverse(stretch);
    parallel_for(points.size(), [&](std::size_t i) { points[i] = vec3(inverse * dvec3(points[i])); });
}

/// Every definition that some line set asks for.
Kinds asked_of(const std::vector<LineSet>& sets) {
    Kinds asked = 0;
    for (const LineSet& set : sets)
        for (const LineSet::Kind& kind : set.kinds) asked |= Kinds(1) << kind.definition;
    return asked;
}

/// Definitions across triangles that the line sets ask for, in their order; each goes to the first set that has it. A
/// silhouette of mesh edges stands for the smooth one, which is found for nobody then.
struct Job {
    const LineDefinition* definition;
    Values values;
    Index line_set, number;  // none, none: for nobody
};

std::vector<Job> jobs_of(const std::vector<LineSet>& sets, bool of_surface) {
    std::vector<Job> jobs;
    const Kinds asked = asked_of(sets);
    Kinds done = 0;
    for (Index s = 0; s < sets.size(); ++s)
        for (const LineSet::Kind& kind : sets[s].kinds) {
            const LineDefinition& definition = *line_definitions()[kind.definition];
            const Kinds bit = Kinds(1) << kind.definition;
            if (!of_surface && definition.name == std::string_view("silhouette") && (asked & smooth_contours()))
                jobs.push_back({line_definitions()[definition_index("smooth_silhouette")], {}, none, none});
            if (!definition.find || (definition.scope == Scope::surface) != of_surface || (done & bit)) continue;
            done |= bit;
            jobs.push_back({&definition, kind.values, s, kind.definition});
        }
    return jobs;
}

/// `near`, `hard`: of doubles.h, or empty.
std::vector<FoundCurves> find_curves(const SurfaceView& seen, const std::vector<LineSet>& sets, bool of_surface,
                                     In<std::uint8_t> near = {}, In<std::uint8_t> hard = {}) {
    const std::vector<Job> jobs = jobs_of(sets, of_surface);
    std::vector<CurveChains> chains(jobs.size());
    parallel_for(jobs.size(), [&](std::size_t i) {
        const LineDefinition& definition = *jobs[i].definition;
        chains[i] = curves_of(definition, seen, jobs[i].values, near);
        if (definition.on_smooth_surface && !hard.empty()) chains[i] = without_doubles(chains[i], seen.surface, hard, 1);
    }, 1);
    std::vector<FoundCurves> found;
    Claims claims(seen.surface);
    for (std::size_t i = 0; i < jobs.size(); ++i) {
        if (jobs[i].definition->on_smooth_surface) chains[i] = claims.claim(*jobs[i].definition, std::move(chains[i]));
        if (jobs[i].line_set == none) continue;
        if (seen.surface.source()) to_object(seen.surface.stretch(), chains[i].point);
        found.push_back({static_cast<std::uint8_t>(jobs[i].line_set), jobs[i].number,
                         std::make_shared<const CurveChains>(std::move(chains[i]))});
    }
    return found;
}

/// Curves of the whole scene, each with the placement that has it.
std::vector<std::pair<Index, FoundCurves>> find_scene_curves(const Scene& scene, In<Index> drawn,
                                                             const std::vector<LineSet>& sets, const Cancel& cancel) {
    std::vector<std::pair<Index, FoundCurves>> found;
    Kinds done = 0;
    for (std::size_t s = 0; s < sets.size(); ++s)
        for (const LineSet::Kind& kind : sets[s].kinds) {
            const LineDefinition& definition = *line_definitions()[kind.definition];
            const Kinds bit = Kinds(1) << kind.definition;
            if (!definition.find_in_scene || (done & bit)) continue;
            done |= bit;
            for (const SceneCurves& part : definition.find_in_scene(scene, drawn, kind.values, cancel)) {
                if (part.curves->pieces.empty()) continue;
                const auto chains =
                    part.curves->derived.get<CurveChains>(0, [&] { return chain_curves(part.curves->pieces); });
                found.push_back({part.placement, {static_cast<std::uint8_t>(s), kind.definition, chains, part.other}});
            }
        }
    return found;
}

/// Lines of the view that a contour would double.
bool any_beside_contours(Kinds asked) {
    const auto& all = line_definitions();
    for (Index i = 0; i < all.size(); ++i)
        if ((asked >> i & 1) && all[i]->scope != Scope::surface && all[i]->select && !all[i]->on_smooth_surface) return true;
    return false;
}

/// Contours of mesh edges whose smooth counterpart is asked for too.
Kinds doubled_edges(Kinds asked) {
    const auto bit = [](const char* name) { return Kinds(1) << definition_index(name); };
    Kinds doubled = 0;
    if (asked & bit("smooth_contour")) doubled |= bit("contour");
    if (asked & bit("smooth_silhouette")) doubled |= bit("silhouette");
    return doubled;
}

/// Lines of the frame as a whole, in view space.
std::vector<FoundCurves> find_in_image(const std::vector<LineSet>& sets, const Tracer& tracer, const Cancel& cancel) {
    std::vector<FoundCurves> found;
    Cache shared;
    Kinds done = 0;
    for (std::size_t s = 0; s < sets.size(); ++s)
        for (const LineSet::Kind& kind : sets[s].kinds) {
            const LineDefinition& definition = *line_definitions()[kind.definition];
            const Kinds bit = Kinds(1) << kind.definition;
            if (!definition.find_in_image || (done & bit)) continue;
            done |= bit;
            const FrameView frame{tracer, cancel, shared};
            found.push_back({static_cast<std::uint8_t>(s), kind.definition,
                             std::make_shared<const CurveChains>(chain_curves(definition.find_in_image(frame, kind.values)))});
        }
    return found;
}

/// In object space; for an orthographic view the direction towards it.
dvec3 eye_of(const View& view, const Placement& placed) {
    const dmat4 view_to_object = glm::inverse(view.world_to_view * placed.object_to_world);
    return dvec3(view_to_object * (view.orthographic ? dvec4(0, 0, 1, 0) : dvec4(0, 0, 0, 1)));
}

/// `surface`: the placement's as it is placed.
SurfaceView look_at(const Surface& surface, const Scene& scene, Index placement, const View& view,
                    const Tracer& tracer) {
    const Placement& placed = scene.placements[placement];
    SurfaceView seen{.surface = surface};
    seen.object_to_view = view.world_to_view * placed.object_to_world * dmat4(glm::inverse(surface.stretch()));
    seen.orthographic = view.orthographic;
    seen.eye_obj = surface.stretch() * eye_of(view, placed);
    seen.placement = placement;
    seen.tracer = &tracer;
    return seen;
}

/// Asked of the surface as it is, like everywhere else: a stretch changes nothing of it but the last digits.
void find_facing(SurfaceView& seen) {
    const Surface& surface = seen.surface.source() ? *seen.surface.source() : seen.surface;
    const dvec3 eye = glm::inverse(seen.surface.stretch()) * seen.eye_obj;
    seen.facing.resize(surface.facet_count());
    parallel_for(seen.facing.size(), [&](std::size_t f) {
        const dvec4 plane(surface.facet_plane[f]);
        seen.facing[f] = glm::dot(dvec3(plane), eye) - (seen.orthographic ? 0.0 : plane.w) >= 0.0;
    });
}

/// Per edge: the first line set that finds it. Edges of `kept` come first, in their order; the others follow.
struct Labelled {
    Array<std::uint8_t> kept_labels, seen_labels;
    Array<Index> seen_edges;
    Array<Kinds> kinds;  // per edge, as found by the set that has it
};

Labelled label_edges(const StaticLines& lines, const std::vector<Array<Kinds>>& kinds) {
    Labelled labelled;
    const std::size_t edges = kinds[0].size();
    Array<std::uint8_t> label(edges, unlabelled);
    labelled.kinds.assign(edges, 0);
    parallel_for(edges, [&](std::size_t e) {
        for (std::size_t s = kinds.size(); s-- > 0;)
            if (kinds[s][e]) {
                label[e] = static_cast<std::uint8_t>(s);
                labelled.kinds[e] = kinds[s][e];
            }
    });
    labelled.kept_labels.resize(lines.edges.size());
    parallel_for(lines.edges.size(), [&](std::size_t i) { labelled.kept_labels[i] = label[lines.edges[i]]; });
    std::size_t next = 0;
    for (Index e = 0; e < edges; ++e) {
        if (next < lines.edges.size() && lines.edges[next] == e) {
            ++next;
        } else if (label[e] != unlabelled) {
            labelled.seen_edges.push_back(e);
            labelled.seen_labels.push_back(label[e]);
        }
    }
    return labelled;
}

Array<Kinds> kinds_of(const Chains& chains, const Array<Kinds>& edge_kinds) {
    Array<Kinds> kinds(chains.edge.size());
    parallel_for(kinds.size(), [&](std::size_t i) { kinds[i] = edge_kinds[chains.edge[i]]; });
    return kinds;
}

/// How many lines meet at each vertex, up to 2.
Array<std::uint8_t> lines_at_vertices(const Surface& surface, In<Index> kept, In<Index> seen) {
    Array<std::uint8_t> count(surface.vertex_count(), 0);
    for (const In<Index> edges : {kept, seen})
        for (Index e : edges)
            for (Index v : {surface.edges[e].x, surface.edges[e].y}) count[v] = std::min(count[v] + 1, 2);
    return count;
}

Array<std::uint8_t> free_ends(const Chains& chains, const Array<std::uint8_t>& lines_at) {
    Array<std::uint8_t> free(chains.rows.count());
    parallel_for(free.size(), [&](std::size_t c) {
        const Index first = chains.vertex[chains.rows.begin(c)], last = chains.vertex[chains.rows.end(c) - 1];
        free[c] = (lines_at[first] < 2 ? free_start : 0) | (lines_at[last] < 2 ? free_end : 0);
    });
    return free;
}

/// Also, per vertex, `hard` of doubles.h. `near`: of doubles.h.
std::pair<EdgePaths, Array<std::uint8_t>> find_edges(SurfaceView seen, const std::vector<LineSet>& sets,
                                                     std::uint64_t sets_hash, bool of_view, In<std::uint8_t> near) {
    const Surface& surface = seen.surface;
    // Contours of a mesh fold back on themselves where they end on a smooth surface: one path through all folds, so
    // that what is seen of them can be told from a line.
    std::vector<double> corner_angles, never(sets.size(), glm::pi<double>());
    for (const LineSet& set : sets) corner_angles.push_back(set.corner_angle_rad);
    const auto lines = surface.cache().get<StaticLines>(sets_hash, [&] { return find_static(surface, sets); });
    std::vector<Array<Kinds>> kinds = lines->kinds;
    Array<std::uint8_t> hard;
    if (of_view) {
        find_facing(seen);
        const Kinds doubled = doubled_edges(asked_of(sets));
        Array<Kinds> all(doubled ? surface.edges.size() : 0, 0);
        for (std::size_t s = 0; s < sets.size(); ++s) {
            trace_kinds(sets[s], seen, false, kinds[s]);
            if (doubled) drop_doubled_edges(surface, near, doubled, kinds[s]);
            parallel_for(all.size(), [&](std::size_t e) { all[e] |= kinds[s][e]; });
        }
        if (doubled) hard = at_hard_edges(surface, doubled, all);
    }
    const Labelled labelled = label_edges(*lines, kinds);
    // With one line set the labels never change, so its static chains are made once.
    const std::uint64_t chains_hash = hash_of(In<std::uint8_t>(labelled.kept_labels), sets_hash);
    EdgePaths paths;
    paths.kept = surface.cache().get<Chains>(
        chains_hash, [&] { return chain(seen, false, lines->edges, labelled.kept_labels, corner_angles); });
    paths.seen = chain(seen, true, labelled.seen_edges, labelled.seen_labels, never);
    paths.kept_kinds = kinds_of(*paths.kept, labelled.kinds);
    paths.seen_kinds = kinds_of(paths.seen, labelled.kinds);
    const Array<std::uint8_t> lines_at = lines_at_vertices(surface, lines->edges, labelled.seen_edges);
    paths.kept_free = free_ends(*paths.kept, lines_at);
    paths.seen_free = free_ends(paths.seen, lines_at);
    return {paths, hard};
}

PlacementPaths extract_placement(const SurfaceView& seen, const std::vector<LineSet>& sets, std::uint64_t sets_hash,
                                 bool view_dependent) {
    Cache& cache = seen.surface.cache();
    PlacementPaths paths;
    Array<std::uint8_t> near, hard;
    const Kinds asked = asked_of(sets), contours = smooth_contours() | Kinds(1) << definition_index("contour");
    if (view_dependent && (asked & contours) && (doubled_edges(asked) || any_beside_contours(asked)))
        near = near_smooth_contour(seen);
    if (any_marks_edges(sets, false)) {
        auto [edges, hard_ones] = find_edges(seen, sets, sets_hash, true, near);
        paths.edges = std::make_shared<const EdgePaths>(std::move(edges));
        hard = std::move(hard_ones);
    } else if (any_marks_edges(sets, true)) {
        paths.edges = cache.get<EdgePaths>(sets_hash, [&] { return find_edges(seen, sets, sets_hash, false, {}).first; });
    }
    paths.kept_curves = cache.get<StaticCurves>(
        sets_hash, [&] { return StaticCurves{find_curves({.surface = seen.surface}, sets, true)}; });
    if (view_dependent) paths.seen_curves = find_curves(seen, sets, false, near, hard);
    return paths;
}

/// Where the chains of one placement (`none`: of the frame) go in the result, and whether they are those of this view
/// alone.
struct Slot {
    Index placement, path, point;
    bool of_view;
};

/// What each path of a slot holds: chains of edges and of curves alike. Functions of the chain's number, and of the
/// number of a point among all of them.
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

void write_chains(const Scene& scene, const Chains& chains, const Array<Kinds>& kinds, const Array<std::uint8_t>& free,
                  Slot slot, Paths& paths) {
    const Placement& placement = scene.placements[slot.placement];
    const Surface& surface = *placement.surface;
    write_paths(
        chains, slot, [&](std::size_t c) { return chains.label[c]; }, [&](std::size_t c) { return free[c]; },
        [&](std::size_t c) { return hash_numbers(placement.id, chains.anchor[c]); },
        [&](Index i) { return surface.positions[chains.vertex[i]]; }, paths);
    parallel_for(chains.vertex.size(), [&](std::size_t i) {
        const std::size_t n = slot.point + i;
        paths.place[n] = chains.edge[i];
        paths.edge_t[n] = surface.edges[chains.edge[i]].x == chains.vertex[i] ? 0.0f : 1.0f;
        paths.kinds[n] = kinds[i];
        paths.strength[n] = 1.0f;
        paths.other_facet[n] = none;
    });
}

void write_curves(const Scene& scene, const FoundCurves& found, Slot slot, Paths& paths) {
    const Placement* placement = slot.placement == none ? nullptr : &scene.placements[slot.placement];
    const CurveChains& chains = *found.chains;
    std::uint64_t id = placement ? placement->id : 0;
    if (found.other != none && found.other != slot.placement) id = hash_numbers(id, scene.placements[found.other].id);
    write_paths(
        chains, slot, [&](std::size_t) { return found.line_set; },
        [&](std::size_t c) { return chains.closed[c] ? 0 : free_start | free_end; },
        [&](std::size_t c) { return hash_numbers(id, found.definition + 1, chains.anchor[c]); },
        [&](Index i) { return chains.point[i]; }, paths);
    if (slot.of_view && line_definitions()[found.definition]->on_smooth_surface)
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
    paths.closed.resize(path_count);
    paths.id.resize(path_count);
    paths.placement.resize(path_count);
    paths.line_set.resize(path_count);
    paths.free_ends.resize(path_count);
    paths.of_view.resize(path_count);
    paths.points_obj.resize(point_count);
    paths.arc_obj.resize(point_count);
    paths.place.resize(point_count);
    paths.edge_t.resize(point_count);
    paths.kinds.resize(point_count);
    paths.strength.resize(point_count);
    paths.other_facet.resize(point_count);
}

}  // namespace

Paths extract_paths(const Scene& scene, const View& view, const std::vector<LineSet>& sets, const Tracer& tracer,
                    const Cancel& cancel) {
    check(sets.size() < unlabelled, "a style holds at most 254 line sets");
    Paths paths;
    if (sets.empty()) return paths;
    tracer.check_current();
    const std::uint64_t sets_hash = hash_sets(sets);
    const bool view_dependent = any_of_scope(sets, Scope::view);
    std::vector<Index> drawn;
    for (Index i = 0; i < scene.placements.size(); ++i)
        if ((scene.placements[i].usage & usage_draw) && in_frame(scene.placements[i], view, frame_margin)) drawn.push_back(i);

    std::vector<PlacementPaths> found(drawn.size());
    parallel_blocks(drawn.size(), 1, [&](std::size_t i, std::size_t, std::size_t) {
        cancel.poll();
        const Placement& placed = scene.placements[drawn[i]];
        const auto surface = as_placed(placed.surface, placed.object_to_world);
        const std::uint64_t asked = hash_numbers(sets_hash, hash_of(surface->field_options()));
        found[i] = extract_placement(look_at(*surface, scene, drawn[i], view, tracer), sets, asked, view_dependent);
    });

    const std::vector<FoundCurves> in_image = find_in_image(sets, tracer, cancel);
    const auto of_scene = find_scene_curves(scene, drawn, sets, cancel);

    struct CurveSlot {
        const FoundCurves* found;
        Slot slot;
    };
    std::vector<std::pair<Slot, Slot>> slots(drawn.size());
    std::vector<CurveSlot> curve_slots;
    Index path = 0, point = 0;
    const auto add_curves = [&](Index placement, const FoundCurves& curves, bool of_view) {
        curve_slots.push_back({&curves, {placement, path, point, of_view}});
        path += curves.chains->rows.count();
        point += static_cast<Index>(curves.chains->point.size());
    };
    for (std::size_t i = 0; i < drawn.size(); ++i) {
        if (const EdgePaths* edges = found[i].edges.get()) {
            slots[i].first = {drawn[i], path, point, false};
            path += edges->kept->rows.count();
            point += static_cast<Index>(edges->kept->vertex.size());
            slots[i].second = {drawn[i], path, point, true};
            path += edges->seen.rows.count();
            point += static_cast<Index>(edges->seen.vertex.size());
        }
        for (const FoundCurves& c : found[i].kept_curves->found) add_curves(drawn[i], c, false);
        for (const FoundCurves& c : found[i].seen_curves) add_curves(drawn[i], c, true);
    }
    for (const FoundCurves& c : in_image) add_curves(none, c, true);
    for (const auto& [placement, curves] : of_scene) add_curves(placement, curves, false);
    resize(paths, path, point);
    parallel_blocks(drawn.size(), 1, [&](std::size_t i, std::size_t, std::size_t) {
        const EdgePaths* edges = found[i].edges.get();
        if (!edges) return;
        write_chains(scene, *edges->kept, edges->kept_kinds, edges->kept_free, slots[i].first, paths);
        write_chains(scene, edges->seen, edges->seen_kinds, edges->seen_free, slots[i].second, paths);
    });
    parallel_blocks(curve_slots.size(), 1, [&](std::size_t i, std::size_t, std::size_t) {
        write_curves(scene, *curve_slots[i].found, curve_slots[i].slot, paths);
    });
    return paths;
}

}  // namespace fovea
