// SPDX-License-Identifier: GPL-3.0-or-later
// Lines move with what they lie on, and do not depend on the order in which a mesh lists its parts.
#include <glm/gtc/quaternion.hpp>
#include <gtest/gtest.h>
#include <map>
#include <numeric>

#include "curve_match.h"
#include "drawing.h"
#include "rules.h"

using namespace fovea;
using namespace fovea::draw;
using namespace fovea::meshes;
using namespace fovea::drawing;
using analytic::ExactCurves;

namespace {

/// The same mesh with another order of vertices and polygons, each polygon turned around when asked; materials and edge
/// marks go along.
Mesh reordered(const Mesh& mesh, bool shuffle, bool reverse) {
    std::mt19937 random(5);
    const std::size_t polygons = mesh.polygon_offsets.size() - 1;
    std::vector<int> vertex(mesh.positions.size()), polygon(polygons);
    std::iota(vertex.begin(), vertex.end(), 0);  // where each goes
    std::iota(polygon.begin(), polygon.end(), 0);
    if (shuffle) {
        std::shuffle(vertex.begin(), vertex.end(), random);
        std::shuffle(polygon.begin(), polygon.end(), random);
    }
    Mesh result(mesh.name, mesh.positions);
    for (std::size_t v = 0; v < vertex.size(); ++v) result.positions[vertex[v]] = mesh.positions[v];
    for (const int f : polygon) {
        std::vector<int> corners;
        for (int c = mesh.polygon_offsets[f]; c < mesh.polygon_offsets[f + 1]; ++c)
            corners.push_back(vertex[mesh.corner_verts[c]]);
        if (reverse) std::reverse(corners.begin(), corners.end());
        if (shuffle) std::rotate(corners.begin(), corners.begin() + random() % corners.size(), corners.end());
        result.add_polygon(corners);
        if (!mesh.material.empty()) result.material.push_back(mesh.material[f]);
    }
    if (mesh.edge_mark.empty()) return result;
    result.edge_mark.assign(result.edge_verts.size(), 0);
    for (std::size_t e = 0; e < mesh.edge_verts.size(); ++e)
        result.edge_mark[result.edge(vertex[mesh.edge_verts[e].x], vertex[mesh.edge_verts[e].y])] = mesh.edge_mark[e];
    return result;
}

struct Change {
    const char* name;
    dmat4 motion{1.0};  ///< of all positions, baked in, and of the camera
    bool shuffle = false;
    bool mirror = false;
};

std::vector<Change> changes() {
    const dmat4 turn = glm::mat4_cast(glm::angleAxis(1.1, glm::normalize(dvec3(1, 2, -1))));
    return {{"rotation", turn},           {"translation", moved({3, -2, 1})},
            {"large", scaled(dvec3(64))}, {"small", scaled(dvec3(1.0 / 64))},
            {"order", dmat4(1.0), true},  {"mirror", scaled({-1, 1, 1}), false, true}};
}

/// A wavy surface, and what cuts it: a box with materials and marks, or, for curves of the smooth surface that a mesh
/// stands for, an ellipsoid. A box stands for none: of its three faces, a corner takes the normal of the first.
std::vector<Mesh> bodies(const LineDefinition& definition) {
    if (has_rule<CurveRule>(definition))
        return {analytic::waves({.n = 96, .irregular = true}).mesh,
                analytic::ellipsoid(4, true, dvec3(.5, .3, .4)).mesh};
    Mesh cube = box(vec3(-.4f), vec3(.3f));
    cube.material = {0, 1, 0, 1, 0, 1};
    cube.edge_mark = cube.edge_flags({0, 3});
    return {analytic::waves({.n = 96, .irregular = true}).mesh, cube};
}

/// Below their defaults, thresholds leave some of every line on waves; still far above noise. Without hysteresis, whose
/// yes or no to a whole line may hang on the last digit.
Values values_of(const LineDefinition& definition) {
    Values values;
    for (const Parameter& p : definition.parameters) {
        const std::string name = p.name;
        const bool on_surface = has_rule<CurveRule>(definition);
        values.push_back(name == "threshold"              ? (has_rule<ImageRule>(definition) ? 1.0 : 0.25) * p.value
                         : on_surface && name == "low"    ? 1.0
                         : on_surface && name == "length" ? 0.0
                                                          : p.value);
    }
    values.file = quick_values(definition).file;
    return values;
}

/// The bodies of a definition after a change; made once, as surfaces keep their fields.
const std::vector<Placement>& changed(const LineDefinition& definition, const Change& change) {
    static std::map<std::pair<bool, std::string>, std::vector<Placement>> made;
    std::vector<Placement>& placements = made[{has_rule<CurveRule>(definition), change.name}];
    if (!placements.empty()) return placements;
    for (Mesh mesh : bodies(definition)) {
        mesh = reordered(mesh, change.shuffle, change.mirror);
        for (vec3& p : mesh.positions) p = vec3(change.motion * dvec4(dvec3(p), 1.0));
        placements.push_back(place(mesh, dmat4(1.0), placements.size() + 1));
    }
    return placements;
}

/// A plane after a motion, with a unit normal.
dvec4 moved_plane(const dvec4& plane, const dmat4& motion) {
    const dvec4 moved = glm::transpose(glm::inverse(motion)) * plane;
    return moved / glm::length(dvec3(moved));
}

/// Segments of one definition, moved back.
ExactCurves lines_after(Index definition, const Change& change) {
    View view = perspective({3, 2.2, 3}, {0, 0, 0});
    view.world_to_view = view.world_to_view * glm::inverse(change.motion);
    const LineDefinition& made = *line_definitions()[definition];
    Scene scene(changed(made, change));
    if (made.in_section || made.ends_at_lines) scene.section = moved_plane({0.0, 0.0, 1.0, -0.05}, change.motion);
    scene.lights.push_back({.direction = glm::normalize(dmat3(change.motion) * dvec3(-0.4, -0.3, -0.8))});  // a sun
    const Tracer tracer(scene, view);
    LineSet set;
    set.kinds.push_back({definition, values_of(*line_definitions()[definition])});
    const Paths paths = extract_paths(scene, view, {set}, tracer, Cancel());
    const dmat4 back = glm::inverse(change.motion);
    ExactCurves segments;
    for (Index p = 0; p < paths.count(); ++p) {
        // The camera moves along, so lines of the image stay where they are to it.
        const dmat4 here = paths.placement[p] == none ? dmat4(1.0) : back;
        const auto point = [&](Index i) { return dvec3(here * dvec4(dvec3(paths.points_obj[i]), 1.0)); };
        for (Index i = paths.rows.begin(p); i + 1 < paths.rows.end(p); ++i)
            segments.push_back({point(i), point(i + 1)});
    }
    return segments;
}

/// Share of the one that has the other within a tenth of an edge.
double share_near(const ExactCurves& one, const ExactCurves& other) {
    constexpr double edge = 2.0 / 96;
    const analytic::NearSegments near(other, edge);
    double sum = 0.0;
    for (const auto& s : one)
        if (near.distance(0.5 * (s.a + s.b), dvec3(0)) < 0.1 * edge) sum += glm::distance(s.a, s.b);
    return one.empty() ? 1.0 : sum / length(one);
}

}  // namespace

class Invariance : public testing::TestWithParam<Index> {};

TEST_P(Invariance, OfLines) {
    const ExactCurves before = lines_after(GetParam(), {"nothing"});
    EXPECT_GT(length(before), 0.1);
    for (const Change& change : changes()) {
        // Levels of depth begin and end at the sphere around the bounding box, which turns with the object, not in it.
        if (line_definitions()[GetParam()]->name == std::string("topographic") &&
            change.name == std::string("rotation"))
            continue;
        const ExactCurves after = lines_after(GetParam(), change);
        EXPECT_NEAR(length(after) / length(before), 1.0, .005) << change.name;
        EXPECT_GE(share_near(before, after), .995) << change.name;
        EXPECT_GE(share_near(after, before), .995) << change.name;
    }
}

INSTANTIATE_TEST_SUITE_P(Registry, Invariance, testing::Range(Index(0), Index(line_definitions().size())),
                         [](const auto& info) { return std::string(line_definitions()[info.param]->name); });
