// SPDX-License-Identifier: GPL-3.0-or-later
#include <tool/statistics.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include <fovea/line/registry.h>

namespace fovea::tool {
namespace {

using nlohmann::ordered_json;

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

/// Per definition of the style: number of paths that are at least partly of its kind, and their number of segments.
ordered_json of(const Paths& paths, const style::Style& style) {
    ordered_json counts = ordered_json::object();
    for (const style::LineSet& set : style.line_sets)
        for (const auto& [name, parameters] : set.kinds) {
            const Index definition = definition_index(name);
            std::size_t found = 0, segments = 0;
            for (Index p = 0; p < paths.count(); ++p) {
                const std::size_t before = segments;
                for (Index i = paths.rows.begin(p); i + 1 < paths.rows.end(p); ++i)
                    segments += paths.kinds[i] >> definition & 1;
                found += segments > before;
            }
            counts[name] = {{"paths", found}, {"segments", segments}};
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

ordered_json statistics(const Model& model, const Frame& frame) {
    ordered_json milliseconds;
    for (const auto& [stage, ms] : frame.stages) milliseconds[stage] = std::round(ms * 1e3) / 1e3;
    ordered_json found{{"model", model.name},
                       {"broken", {{"vertices", of(model.vertices)}, {"polygons", of(model.polygons)}}},
                       {"surface", of(*frame.job.scene->placements[0].surface)},
                       {"lines", of(*frame.paths, frame.job.style)},
                       {"view", of(*frame.clipped, *frame.visible)}};
    if (frame.strokes) found["strokes"] = frame.strokes->count;
    found["milliseconds"] = milliseconds;
    return found;
}

nlohmann::ordered_json statistics(const vector::Drawing& drawing) {
    nlohmann::ordered_json found;
    drawing.for_each_figure([&](const char* name, auto number) { found[name] = number; });
    return found;
}

}  // namespace fovea::tool
