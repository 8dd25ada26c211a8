// SPDX-License-Identifier: GPL-3.0-or-later
// What is computed of surfaces before a frame asks for it.
#include <gtest/gtest.h>
#include <thread>

#include <fovea/draw/ahead.h>
#include <fovea/draw/frame.h>
#include <fovea/field/shape.h>
#include <fovea/style/json.h>

#include "drawing.h"

using namespace fovea;
using namespace fovea::draw;
using namespace fovea::drawing;

namespace {

const char* style_of_lines = R"({"schema": 1, "line_sets": [{"surfaces": "suited", "kinds": {"contour": {},
    "crease": {"angle": 40}, "intersection": {}, "ridge": {}}, "least_length": 0}]})";

/// Boxes that pass through each other, and a sphere that passes through itself.
std::shared_ptr<const Scene> crossing() {
    const auto spheres = meshes::with_another(meshes::sphere(24), meshes::box(vec3(-0.6f), vec3(0.7f, 0.8f, 3.0f)));
    return std::make_shared<Scene>(
        Scene({place(meshes::box(), moved({0, 0, 0}), 1), place(meshes::box(), moved({0.5, 0.7, 0.3}), 2),
               place(spheres, moved({-3, 0, 0}), 3)}));
}

Array<vec4> drawn(const std::shared_ptr<const Scene>& scene) {
    Frame frame({.scene = scene,
                 .view = perspective({3, -8, 4}, {0, 0, 0}, 30, 240, 180),
                 .style = style::read_style(style_of_lines),
                 .assets = std::make_shared<Assets>("."),
                 .backend = std::make_shared<CpuBackend>()});
    frame.picture();
    return std::move(frame.passes.combined);
}

bool one_thread() { return tbb::this_task_arena::max_concurrency() < 2; }

}  // namespace

TEST(Ahead, FramesAreTheSameHoweverMuchOfThemIsComputedAhead) {
    const Array<vec4> expected = drawn(crossing());
    for (int times = 0; times < 20; ++times) {
        const auto scene = crossing();
        {
            Ahead ahead(style::read_style(style_of_lines), nullptr);
            for (const Placement& placement : scene->placements) ahead.add(placement.surface);
            for (int k = 0; k < times * 50; ++k) std::this_thread::yield();
        }
        ASSERT_EQ(drawn(scene), expected) << times;
    }
}

TEST(Ahead, ComputesWhileTheCallerGoesOn) {
    if (one_thread()) GTEST_SKIP() << "this machine has one processor";
    const auto scene = crossing();
    Ahead ahead(style::read_style(style_of_lines), nullptr);
    for (const Placement& placement : scene->placements) ahead.add(placement.surface);
    for (const Placement& placement : scene->placements)
        while (!field::known_shape(*placement.surface)) std::this_thread::yield();
}

TEST(Ahead, EndsWithoutATraceWhenItIsCancelled) {
    const auto scene = crossing();
    const auto cancel = std::make_shared<Cancel>();
    cancel->requested = true;
    {
        Ahead ahead(style::read_style(style_of_lines), cancel);
        for (const Placement& placement : scene->placements) ahead.add(placement.surface);
    }
    EXPECT_EQ(drawn(scene), drawn(crossing()));
}
