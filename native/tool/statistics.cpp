// SPDX-License-Identifier: GPL-3.0-or-later
#include <tool/statistics.h>

#include <chrono>
#include <cmath>
#include <nlohmann/json.hpp>

#include <fovea/path/extract.h>
#include <fovea/project/project.h>
#include <fovea/visibility/exact.h>

namespace fovea::tool {
namespace {

using nlohmann::ordered_json;

/// Times stages, one after the other.
class Clock {
   public:
    template <typename Stage>
    auto time(const char* name, const Stage& stage) {
        const auto start = std::chrono::steady_clock::now();
        auto result = stage();
        const std::chrono::duration<double, std::milli> taken = std::chrono::steady_clock::now() - start;
        milliseconds[name] = std::round(taken.count() * 1e3) / 1e3;
        return result;
    }
    ordered_json milliseconds;
};

LineSet line_set(const std::vector<std::string>& names) {
    LineSet set;
    for (const std::string& name : names)
        set.kinds.push_back({definition_index(name), default_values(definition_called(name))});
    return set;
}

ordered_json of(const Broken& broken) {
    ordered_json counts{{"count", broken.count}};
    if (broken.count) counts["first"] = broken.first;
    return counts;
}

ordered_json of(const Surface& surface) {
    const SurfaceReport& report = surface.report();
    return {{"vertices", surface.vertex_count()},
            {"edges", surface.mesh_edges},
            {"polygons", surface.polygon_count()},
            {"facets", surface.facet_count()},
            {"triangles", surface.triangles.size()},
            {"non_finite_vertices", report.non_finite_vertices},
            {"degenerate_polygons", report.degenerate_polygons},
            {"duplicate_polygons", report.duplicate_polygons},
            {"non_manifold_edges", report.non_manifold_edges},
            {"inconsistent_edges", report.inconsistent_edges}};
}

/// Per definition asked for, how many paths are of its kind, at least in part, and of how many segments in all.
ordered_json of(const Paths& paths, const LineSet& set) {
    ordered_json counts = ordered_json::object();
    for (const LineKind& kind : set.kinds) {
        std::size_t found = 0, segments = 0;
        for (Index p = 0; p < paths.count(); ++p) {
            const std::size_t before = segments;
            for (Index i = paths.rows.begin(p); i + 1 < paths.rows.end(p); ++i)
                segments += paths.kinds[i] >> kind.definition & 1;
            found += segments > before;
        }
        counts[line_definitions()[kind.definition]->name] = {{"paths", found}, {"segments", segments}};
    }
    return counts;
}

ordered_json of(const ClippedPaths& clipped, const Runs& runs) {
    double all = 0.0, visible = 0.0;
    for (Index q = 0; q < clipped.pieces.count(); ++q)
        all += clipped.arc_px[clipped.pieces.end(q) - 1] - clipped.arc_px[clipped.pieces.begin(q)];
    for (std::size_t r = 0; r < runs.size(); ++r) visible += runs.end_px[r] - runs.start_px[r];
    return {{"pieces", clipped.pieces.count()}, {"visible_runs", runs.size()}, {"px", all}, {"visible_px", visible}};
}

}  // namespace

std::vector<std::string> default_lines() {
    std::vector<std::string> names;
    for (const LineDefinition* definition : line_definitions())
        if (std::holds_alternative<EdgeRule>(definition->rule) && !definition->slow) names.push_back(definition->name);
    return names;
}

ordered_json statistics(const Model& model, const Camera& camera, const std::vector<std::string>& lines) {
    const LineSet set = line_set(lines);
    const Cancel cancel;
    Clock clock;
    const auto surface = clock.time("surface", [&] { return model.surface(); });
    const Scene scene(std::vector<Placement>{{.surface = surface, .id = 1}});
    const View view = view_of(model.positions, camera, model.y_up);
    const auto tracer = clock.time("rays", [&] { return std::make_unique<Tracer>(scene, view); });
    const Paths paths = clock.time("lines", [&] { return extract_paths(scene, view, {set}, *tracer, cancel); });
    const ClippedPaths clipped = clock.time("project", [&] { return project(paths, scene, view, {}, cancel); });
    const Runs runs = clock.time("visibility", [&] { return exact_visibility(clipped, paths, *tracer, cancel); });
    return {
        {"model", model.name},       {"broken", {{"vertices", of(model.vertices)}, {"polygons", of(model.polygons)}}},
        {"surface", of(*surface)},   {"lines", of(paths, set)},
        {"view", of(clipped, runs)}, {"milliseconds", clock.milliseconds}};
}

}  // namespace fovea::tool
