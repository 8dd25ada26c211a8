// SPDX-License-Identifier: GPL-3.0-or-later
// The color layer, its effects and paper: the same for any number of threads, sound on poor input.
#include <cmath>
#include <cstring>
#include <gtest/gtest.h>
#include <limits>
#include <tbb/global_control.h>

#include <fovea/color/effects.h>
#include <fovea/color/layer.h>
#include <fovea/color/paper.h>
#include <fovea/mesh/refine.h>

#include "drawing.h"

namespace fovea {
using namespace draw;
namespace {

using namespace drawing;

style::Color in(Shading shading) {
    style::Color color;
    color.shading = shading;
    return color;
}

Array<vec4> layer(const Tracer& tracer, Shading shading) {
    const Light sun{.direction = {-0.3, 0.5, -0.8}, .color = vec3(3.0f)};
    const SceneColor colors(tracer.scene().placements.size());
    return color_layer(tracer, colors, In<Light>(&sun, 1), vec3(0.2f), in(shading), Cancel());
}

bool same(const Array<vec4>& a, const Array<vec4>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(vec4)) == 0;
}

TEST(Color, IsTheSameForAnyNumberOfThreads) {
    const Scene scene({place(meshes::sphere(24)), place(meshes::box(vec3(-3, -3, -2), vec3(3, 3, -1)))});
    const Tracer tracer(scene, perspective({5, -4, 3}, {0, 0, 0}, 50.0, 200, 150));
    const Array<vec4> many = layer(tracer, Shading::toon);
    Array<float> radius(many.size());
    for (std::size_t i = 0; i < radius.size(); ++i) radius[i] = float(i % 200) / 20.0f;
    Array<vec4> blurred = many;
    blur(blurred, 200, radius);
    tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    EXPECT_TRUE(same(many, layer(tracer, Shading::toon)));
    Array<vec4> again = many;
    blur(again, 200, radius);
    EXPECT_TRUE(same(blurred, again));
    EXPECT_FALSE(same(blurred, many));
}

TEST(Color, LooksThroughAnOrthographicCameraAlike) {
    const Scene scene({place(meshes::sphere(32))});
    // From so far away that both see the same half.
    const Tracer flat(scene, orthographic({0, -400, 0}, {0, 0, 0}, 3.0, 120, 90));
    const Tracer deep(scene, perspective({0, -400, 0}, {0, 0, 0}, 50.0 * 400 / 3 * 0.72, 120, 90));
    const Array<vec4> a = layer(flat, Shading::smooth), b = layer(deep, Shading::smooth);
    double difference = 0.0, ink = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        difference += std::abs(a[i].x - b[i].x);
        ink += a[i].x;
    }
    EXPECT_GT(ink, 1000.0);
    EXPECT_LT(difference / ink, 0.02);
}

TEST(Color, BrokenInputHasAPicture) {
    const Scene scene({place(meshes::sphere(12)), place(meshes::box(), scaled({0, 1, 1}))});
    const Tracer tracer(scene, perspective({5, -4, 3}, {0, 0, 0}, 50.0, 64, 48));
    const float nan = std::numeric_limits<float>::quiet_NaN();
    auto broken = std::make_shared<SurfaceColor>();
    broken->slots = {
        {.color = vec3(nan), .texture = {}, .uv = none, .attribute = none, .unlit = false, .opacity = 0.0f}};
    const Light lights[] = {{.kind = Light::point, .position = dvec3(0.0), .color = vec3(nan)},
                            {.kind = Light::spot, .position = dvec3(0.0), .direction = dvec3(0.0)}};
    const SceneColor colors{broken, nullptr};
    for (const vec4& pixel : color_layer(tracer, colors, lights, vec3(nan), in(Shading::smooth), Cancel()))
        ASSERT_TRUE(std::isfinite(pixel.x + pixel.y + pixel.z + pixel.w));
}

TEST(Color, NumbersThatAreNoneHaveAPictureOnBothSidesOfAPlacementWithoutVolume) {
    const Scene scene({place(meshes::sphere(6), dmat4(1.0)), place(meshes::box(), scaled({1, 0, 1}), 2)});
    const Tracer tracer(scene, perspective({5, -4, 3}, {0, 0, 0}, 50.0, 64, 48));
    const float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
    auto broken = std::make_shared<SurfaceColor>();
    broken->slots = {{.color = vec3(1.0f), .texture = {}, .uv = none, .attribute = 0, .unlit = false, .opacity = 0.0f}};
    broken->attributes.emplace_back(scene.placements[0].surface->corner_count(), vec3(nan, inf, -inf));
    const Light lights[] = {{.kind = Light::sun, .direction = dvec3(inf), .color = vec3(1.0f)},
                            {.kind = Light::sun, .direction = {0, 0, -1}, .color = vec3(1.0f)}};
    const SceneColor colors{broken, nullptr};
    float most = 0.0f;
    for (const vec4& pixel : color_layer(tracer, colors, lights, vec3(0.1f, nan, inf), in(Shading::smooth), Cancel())) {
        ASSERT_TRUE(std::isfinite(pixel.x + pixel.y + pixel.z + pixel.w));
        most = std::max(most, pixel.w);
    }
    EXPECT_EQ(most, 1.0f);
}

TEST(Color, EffectsTakeEmptyAndThinImages) {
    Array<vec4> nothing;
    blur(nothing, 5, {});
    desaturate(nothing, {});
    for (int width : {1, 7}) {
        Array<vec4> line(7);
        for (std::size_t i = 0; i < 7; ++i) line[i] = vec4(float(i));
        const Array<float> radius(7, 2.0f);
        blur(line, width, radius);
        float sum = 0.0f;
        for (const vec4& pixel : line) sum += pixel.x;
        EXPECT_NEAR(sum, 21.0f, 1e-4f);
        EXPECT_GT(line[0].x, 0.1f);
    }
}

TEST(Paper, InkOnTeethIsMonotonousAndKeepsTheMean) {
    for (float opacity : {0.0f, 0.02f, 0.3f, 0.9f, 0.99f, 1.0f}) {
        double sum = 0.0;
        float before = 0.0f;
        for (int i = 0; i < 1000; ++i) {
            const float here = toothed(opacity, (float(i) + 0.5f) / 1000.0f, 1.0f);
            EXPECT_GE(here, before);
            sum += before = here;
        }
        EXPECT_NEAR(sum / 1000.0, opacity, 1e-3);
        EXPECT_EQ(toothed(opacity, 0.9f, 0.0f), opacity);
    }
}

/// A cage of a quad, a triangle and a pentagon in the plane, with its corners' positions as values.
TEST(RefinedCorners, OnAFlatCageTheyLieWhereTheCornersOfItsFacesAre) {
    const meshes::Mesh cage = meshes::of_polygons(
        "cage", {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 0.5, 0}, {1.5, 2, 0}, {0.5, 2.5, 0}, {-0.5, 2, 0}},
        {{0, 1, 2, 3}, {1, 4, 2}, {3, 2, 5, 6, 7}});
    const MeshArrays arrays = cage.arrays();
    const RefinedSurface surface("cage", arrays, {.level = 2, .round_corners = false});
    Array<float> values;
    for (int vertex : arrays.corner_verts) {
        values.push_back(cage.positions[vertex].x);
        values.push_back(cage.positions[vertex].y);
    }
    const Array<float> mixed = surface.mix_corners(values, 2, arrays.polygon_offsets);
    ASSERT_EQ(mixed.size(), 2 * std::size_t(surface.corner_count()));
    // Corners that share a vertex of the refined mesh agree, also over the faces of the cage.
    std::vector<vec2> at(surface.vertex_count(), vec2(HUGE_VALF));
    for (Index f = 0; f < surface.polygon_count(); ++f) {
        const In<Index> vertices = surface.polygon_vertices(f);
        for (std::size_t i = 0; i < vertices.size(); ++i) {
            const std::size_t corner = surface.first_corner(f) + i;
            const vec2 here(mixed[2 * corner], mixed[2 * corner + 1]);
            vec2& known = at[vertices[i]];
            if (known.x != HUGE_VALF) {
                EXPECT_NEAR(known.x, here.x, 1e-5f);
                EXPECT_NEAR(known.y, here.y, 1e-5f);
            }
            known = here;
            // The limit surface pulls vertices in, but not far.
            EXPECT_LT(glm::length(vec2(surface.positions[vertices[i]]) - here), 0.35f);
        }
    }
    EXPECT_THROW((void)surface.mix_corners(values, 3, arrays.polygon_offsets), std::invalid_argument);
}

TEST(Paper, LiesUnderLinesCutByHoldout) {
    View view;
    view.width = 4;
    view.height = 1;
    const vec4 half(0.25f, 0.0f, 0.0f, 0.5f);
    const Array<vec4> lines{vec4(0.0f), half, vec4(0.0f), half};
    const Array<float> holdout{0.0f, 0.0f, 1.0f, 1.0f};
    style::Paper paper;
    paper.color = {1.0, 0.5, 0.0};
    Array<vec4> out;
    on_paper(lines, {}, {}, holdout, view, nullptr, paper, {}, out);
    EXPECT_EQ(out, (Array<vec4>{vec4(1.0f, 0.5f, 0.0f, 1.0f), vec4(0.75f, 0.25f, 0.0f, 1.0f), vec4(0.0f), half}));
    on_paper(lines, {}, {}, {}, view, nullptr, paper, {}, out);
    EXPECT_EQ(out[3], vec4(0.75f, 0.25f, 0.0f, 1.0f));
    EXPECT_THROW(on_paper(lines, {}, {}, {holdout.data(), 2}, view, nullptr, paper, {}, out), std::invalid_argument);
    paper.transparent = true;
    on_paper(lines, {}, {}, {}, view, nullptr, paper, {}, out);
    EXPECT_EQ(out, lines);
}

}  // namespace
}  // namespace fovea
