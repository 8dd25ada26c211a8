// SPDX-License-Identifier: GPL-3.0-or-later
// Painted values: exact for what is linear over the surface, wherever a line runs on it.
#include <gtest/gtest.h>
#include <limits>
#include <tbb/global_control.h>

#include <fovea/color/painted_image.h>
#include <fovea/focus/focus.h>
#include <fovea/path/painted.h>

#include "drawing.h"
#include "wires.h"

using namespace fovea;
using namespace fovea::draw;

namespace {

/// Linear in space, so that edges and triangles must give it everywhere.
float ramp(const vec3& p) { return 0.5f + 0.3f * p.x + 0.1f * p.y - 0.05f * p.z; }

template <typename Value>
std::vector<float> at_corners(const meshes::Mesh& mesh, const Value& value) {
    std::vector<float> values;
    for (const int v : mesh.corner_verts) values.push_back(value(mesh.positions[v]));
    return values;
}

const dvec3 eye(3, -4, 2.5);

}  // namespace

TEST(Painted, IsLinearOnEdgesAndInTriangles) {
    for (const char* definition : {"contour", "smooth_contour", "topographic", "crease", "isophote"}) {
        const meshes::Mesh mesh = std::string(definition) == "crease" ? meshes::box() : meshes::sphere(12);
        const drawing::Drawing drawn({drawing::place(mesh)}, drawing::perspective(eye, dvec3(0)),
                                     {drawing::line_set({definition})});
        const std::vector<float> corners = at_corners(mesh, ramp);
        const Array<float> found = values_on_paths(drawn.paths, drawn.scene, {corners});
        ASSERT_GT(found.size(), 8u) << definition;
        // Smooth contours leave the triangles for the smooth surface: there the nearest place counts.
        const float beside = std::string(definition) == "smooth_contour" ? 0.01f : 0.0f;
        for (std::size_t i = 0; i < found.size(); ++i)
            ASSERT_NEAR(found[i], ramp(drawn.paths.points_obj[i]), 2e-5f + beside) << definition << " " << i;
        // And so on each atlas sample, in perspective, too.
        const Array<float> samples = values_of_samples(drawn.clipped, found);
        ASSERT_GT(samples.size(), 100u) << definition;
        for (Index q = 0; q < drawn.clipped.pieces.count(); ++q)
            for (Index i = drawn.clipped.pieces.begin(q); i + 1 < drawn.clipped.pieces.end(q); ++i)
                for (Index j = 0; j < drawn.clipped.sample_count[i]; ++j) {
                    const vec3 a = drawn.clipped.position_view[i], b = drawn.clipped.position_view[i + 1];
                    const float s = (j + 0.5f) / drawn.clipped.sample_count[i], t = s * a.z / (b.z + s * (a.z - b.z));
                    const dvec4 there = glm::inverse(drawn.view.world_to_view) * dvec4(dvec3(glm::mix(a, b, t)), 1.0);
                    ASSERT_NEAR(samples[drawn.clipped.sample_start[i] + j], ramp(vec3(there)), 5e-5f + beside)
                        << definition;
                }
    }
}

TEST(Painted, AtVerticesAndMidEdge) {
    const meshes::Mesh mesh = meshes::grid(1);  // one square, edges 0: 20, 1: 01, 2: 13, 3: 32
    const Scene scene({drawing::place(mesh)});
    const std::vector<float> corners{0.0f, 1.0f, 0.6f, 0.2f};  // of vertices 0, 1, 3, 2
    Paths paths;
    paths.rows.offsets = {0, 4};
    paths.placement = {0};
    paths.points_obj = {mesh.positions[0], (mesh.positions[0] + mesh.positions[1]) * 0.5f, mesh.positions[1],
                        mesh.positions[3]};
    paths.place = {1, 1, 2, 2};
    const bool turned = mesh.edge_verts[2].x == 3;
    paths.edge_t = {0.0f, 0.5f, turned ? 1.0f : 0.0f, turned ? 0.0f : 1.0f};
    const Array<float> found = values_on_paths(paths, scene, {corners});
    const float expected[] = {0.0f, 0.5f, 1.0f, 0.6f};
    for (int i = 0; i < 4; ++i) EXPECT_FLOAT_EQ(found[i], expected[i]) << i;
}

TEST(Painted, WhereNeighborsDisagreeAnEdgeHasTheirMean) {
    const meshes::Mesh mesh = meshes::of_polygons(
        "pair", {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 0, 0}, {2, 1, 0}}, {{0, 1, 2, 3}, {1, 4, 5, 2}});
    const Scene scene({drawing::place(mesh)});
    const std::vector<float> corners{0, 0, 0, 0, 1, 1, 1, 1};
    Paths paths;
    paths.rows.offsets = {0, 2};
    paths.placement = {0};
    paths.points_obj = {{1, 0, 0}, {1, 1, 0}};
    paths.place = {2, 2};  // the edge between the two
    paths.edge_t = {0, 1};
    const Array<float> found = values_on_paths(paths, scene, {corners});
    EXPECT_FLOAT_EQ(found[0], 0.5f);
    EXPECT_FLOAT_EQ(found[1], 0.5f);
}

TEST(Painted, IsNeutralWhereNothingIsPainted) {
    const meshes::Mesh mesh = meshes::box();
    const drawing::Drawing drawn({drawing::place(mesh), drawing::place(mesh, drawing::moved({3, 0, 0}), 2)},
                                 drawing::perspective(eye, dvec3(0)), {drawing::line_set({"crease"})});
    std::vector<float> corners(24, 2.0f);
    corners[0] = std::numeric_limits<float>::quiet_NaN();
    const Array<float> found = values_on_paths(drawn.paths, drawn.scene, {corners, {}});
    for (Index p = 0; p < drawn.paths.count(); ++p)
        for (Index i = drawn.paths.rows.begin(p); i < drawn.paths.rows.end(p); ++i) {
            const bool bare = drawn.paths.placement[p] == 1;
            EXPECT_GE(found[i], unpainted);
            EXPECT_LE(found[i], bare ? unpainted : 1.0f);
        }
    EXPECT_THROW(values_on_paths(drawn.paths, drawn.scene, {corners}), std::invalid_argument);
    const std::vector<float> few(23, 0.0f);
    EXPECT_THROW(values_on_paths(drawn.paths, drawn.scene, {few, {}}), std::invalid_argument);
    const wires::Wires loose({{{-1, 0, -5}, {1, 0, -5}}});
    EXPECT_EQ(values_on_paths(loose.paths, loose.scene, {{}})[0], unpainted);
}

TEST(Painted, TheSameForAnyNumberOfThreads) {
    const meshes::Mesh mesh = meshes::sphere(40);
    const drawing::Drawing drawn({drawing::place(mesh)}, drawing::perspective(eye, dvec3(0)),
                                 {drawing::line_set({"contour", "topographic"})});
    const std::vector<float> corners = at_corners(mesh, ramp);
    const Array<float> many = values_on_paths(drawn.paths, drawn.scene, {corners});
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    EXPECT_EQ(values_on_paths(drawn.paths, drawn.scene, {corners}), many);
}

TEST(Painted, PixelsHaveWhatTheySee) {
    const meshes::Mesh mesh = meshes::grid(3);
    const Scene scene({drawing::place(mesh)});
    const View view = drawing::orthographic({0, 0, 5}, {0, 0, 0}, 4.0, 64, 48);
    const Tracer tracer(scene, view);
    const std::vector<float> corners = at_corners(mesh, ramp);
    const Array<float> image = painted_image(tracer, {corners}, Cancel()), bare = painted_image(tracer, {{}}, Cancel());
    const dmat4 to_world = glm::inverse(view.view_to_clip * view.world_to_view);
    for (int y = 0; y < view.height; ++y)
        for (int x = 0; x < view.width; ++x) {
            const dvec4 ndc(2 * (x + 0.5) / view.width - 1, 2 * (y + 0.5) / view.height - 1, 0, 1);
            const vec3 there(to_world * ndc);
            const float outside = std::max(std::abs(there.x), std::abs(there.y)) - 1.0f;
            if (std::abs(outside) < 0.07f) continue;  // the border's own pixels
            const std::size_t i = std::size_t(y) * view.width + x;
            EXPECT_NEAR(image[i], outside > 0 ? 0.0f : ramp({there.x, there.y, 0}), 1e-4f) << x << " " << y;
            EXPECT_NEAR(bare[i], outside > 0 ? 0.0f : unpainted, 1e-6f);
        }
}
