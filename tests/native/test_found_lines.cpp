// SPDX-License-Identifier: GPL-3.0-or-later
// What a frame found of its lines serves another frame of the same content.
#include <functional>
#include <gtest/gtest.h>

#include <fovea/draw/content.h>
#include <fovea/draw/frame.h>
#include <fovea/style/json.h>

#include "drawing.h"

using namespace fovea;
using namespace fovea::draw;
using namespace fovea::drawing;

namespace {

Job job_at(double x, bool smoothed = true) {
    const char* thinned = R"({"schema": 1, "elision": {"enabled": true, "frames": 1},
        "line_sets": [{"kinds": {"contour": {}, "crease": {"angle": 40}}, "pen": {"width": 4, "spacing": 60}}]})";
    Job job{.scene = std::make_shared<Scene>(
                Scene({place(meshes::box(), moved({0, 0, 0}), 1), place(meshes::box(), moved({1.5, 2.5, 0.3}), 2)})),
            .view = perspective({x, -8, 4}, {0, 1, 0}, 50, 240, 180),
            .style = style::read_style(thinned),
            .assets = std::make_shared<Assets>("."),
            .backend = std::make_shared<CpuBackend>()};
    if (smoothed) job.near = {{1, Frame(job_at(x + 0.5, false)).found_lines()->lines}};
    return job;
}

/// A scene with all that lines may depend on.
struct Told {
    Scene scene{{place(meshes::box(), moved({0, 0, 0}), 1), place(meshes::box(), moved({1.5, 2.5, 0.3}), 2)}};
    View view = perspective({3, -8, 4}, {0, 1, 0});
    std::vector<float> importance{0.5f, 0.5f}, paint = std::vector<float>(24, 0.5f);
    std::vector<float> map{0.1f, 0.2f, 0.3f, 0.4f};
    style::PaintSource source = style::PaintSource::attribute;
    Overrides overrides;

    Told() { scene.lights.push_back({.id = 4}); }
    Surface& surface() { return const_cast<Surface&>(*scene.placements[0].surface); }
    std::uint64_t content() {
        overrides.importance = importance;
        overrides.painted = {{{source, "paint"}, {paint, paint}}};
        overrides.density_map = std::make_shared<ColorTexture>(map, 2, 2, 1, false);
        return content_of(scene, view, overrides);
    }
};

}  // namespace

TEST(FoundLines, AFrameThatTakesThemOverDrawsTheSamePictureAndFindsNothing) {
    Frame alone(job_at(3)), found(job_at(3, false)), other(job_at(3));
    alone.picture();
    other.take_over(found.found_lines());
    other.picture();
    EXPECT_EQ(alone.passes.combined, other.passes.combined);
    EXPECT_EQ(other.paths, found.paths);
    Frame plain(job_at(3, false));
    plain.picture();
    EXPECT_NE(plain.passes.combined, other.passes.combined);
    EXPECT_GT(found.found_lines()->bytes(), 10 * found.clipped->samples);
}

TEST(FoundLines, ContentIsTheSameForTheSameAndAnotherWithWhateverLinesDependOn) {
    const auto content = [](const std::function<void(Told&)>& change) {
        Told told;
        change(told);
        return told.content();
    };
    const std::uint64_t same = content([](Told&) {});
    EXPECT_EQ(content([](Told&) {}), same);
    const std::pair<const char*, std::function<void(Told&)>> changes[] = {
        {"place", [](Told& t) { t.scene.placements[1].object_to_world[3].x += 1e-9; }},
        {"id", [](Told& t) { t.scene.placements[1].id = 3; }},
        {"usage", [](Told& t) { t.scene.placements[0].usage = usage_draw; }},
        {"group", [](Told& t) { t.scene.placements[0].group = 7; }},
        {"number", [](Told& t) { t.scene.placements.pop_back(); }},
        {"light", [](Told& t) { t.scene.lights[0].direction.x += 0.1; }},
        {"color of a light", [](Told& t) { t.scene.lights[0].color.y = 0.5f; }},
        {"section", [](Told& t) { t.scene.section = dvec4(0, 0, 1, -0.2); }},
        {"vertex", [](Told& t) { t.surface().positions[5].z += 0.1f; }},
        {"vertex at rest", [](Told& t) { t.surface().set_rest(std::vector<vec3>(t.surface().vertex_count())); }},
        {"mark", [](Told& t) { t.surface().edge_marks[2] ^= mesh::mark_edge; }},
        {"material", [](Told& t) { t.surface().polygon_material[3] = 1; }},
        {"shape", [](Told& t) { t.surface().set_shape(mesh::Shape::smooth); }},
        {"curvature", [](Told& t) { t.surface().set_field_options({.smoothing = 2.0}); }},
        {"camera", [](Told& t) { t.view = perspective({3, -8, 4.1}, {0, 1, 0}); }},
        {"size", [](Told& t) { t.view.width += 1; }},
        {"clip", [](Told& t) { t.view.far_clip += 1; }},
        {"priority", [](Told& t) { t.importance[1] = 0.6f; }},
        {"paint", [](Told& t) { t.paint[20] = 0.6f; }},
        {"source of paint", [](Told& t) { t.source = style::PaintSource::vertex_group; }},
        {"density map", [](Told& t) { t.map[3] = 0.6f; }},
        {"kinds", [](Told& t) { t.overrides.lines.kinds = {1, 1}; }},
        {"parameter", [](Told& t) { t.overrides.lines.parameters = {{0, 0, {0.5, 0.5}}}; }},
        {"lined materials", [](Told& t) { t.overrides.lines.materials = {{0, 0}, {{1}}}; }},
        {"filter", [](Told& t) { t.overrides.line_sets = {{{1, 0}, {}}}; }},
    };
    for (const auto& [name, change] : changes) EXPECT_NE(content(change), same) << name;
}
