// SPDX-License-Identifier: GPL-3.0-or-later
// Stages refuse what other scenes, or other positions, were made of.
#include <gtest/gtest.h>

#include <fovea/draw/pens.h>
#include <fovea/runs/compaction.h>
#include <fovea/runs/filters.h>
#include <fovea/stroke/tessellate.h>
#include <fovea/visibility/depth_image.h>

#include "drawing.h"
#include "refused.h"

namespace fovea {
using namespace draw;
namespace {

using namespace drawing;

/// Sharp edges of a mesh, each a path of its own.
struct Sharp {
    std::shared_ptr<Surface> surface;
    Drawing drawn;

    explicit Sharp(const meshes::Mesh& mesh)
        : surface(mesh.surface()),
          drawn({{.surface = surface}}, perspective({4, -5, 3}, dvec3(0)),
                {line_set_with("crease", {0.0, 1.0}, 10.0)}) {}
};

template <typename Call>
void expect_refused(const Call& call) {
    EXPECT_THROW(call(), std::invalid_argument);
}

}  // namespace

TEST(MixedStages, PathsAndRunsOfAnotherSceneAreRefused) {
    const Sharp many(meshes::sphere(16)), few(meshes::box());
    const Drawing &a = many.drawn, &b = few.drawn;
    ASSERT_GT(a.paths.count(), b.paths.count());
    ASSERT_GT(a.runs.size(), b.runs.size());
    const std::vector<float> per_path(a.paths.count(), 1.0f), per_few(b.paths.count(), 1.0f);
    expect_refused([&] { project::project(a.paths, b.scene, b.view, {}, Cancel()); });
    expect_refused([&] { exact_visibility(a.clipped, b.paths, b.tracer, Cancel()); });
    expect_refused([&] { exact_visibility(a.clipped, a.paths, b.tracer, Cancel()); });
    expect_refused([&] { samples_from_runs(b.clipped, a.runs); });
    expect_refused([&] { close_gaps(b.clipped, a.runs, 1.0, per_path); });
    expect_refused([&] { close_gaps(a.clipped, a.runs, 1.0, per_few); });
    expect_refused([&] { trim_folds(b.clipped, a.runs, b.paths.of_view, 5.0); });
    expect_refused([&] { trim_folds(a.clipped, a.runs, b.paths.of_view, 5.0); });
    expect_refused([&] { meet_ends(b.clipped, a.runs, b.paths.of_view, b.paths.placement, 8.0); });
    expect_refused([&] { meet_ends(a.clipped, a.runs, b.paths.of_view, b.paths.placement, 8.0); });
    expect_refused([&] { halo(b.clipped, a.runs, per_path, a.paths.of_view); });
    expect_refused([&] { halo(a.clipped, a.runs, per_few, b.paths.of_view); });
    expect_refused([&] { overshoot(b.clipped, a.runs, per_path); });
    expect_refused([&] { overshoot(a.clipped, a.runs, per_few); });
    expect_refused([&] { compact(b.clipped, a.paths, a.runs); });
    expect_refused([&] { compact(a.clipped, b.paths, a.runs); });
    expect_refused([&] { pens_of_runs(b.clipped, a.runs, a.paths.line_set, {}); });
    expect_refused([&] { pens_of_runs(a.clipped, a.runs, b.paths.line_set, {}); });
    const Pen pen;
    const std::vector<Index> of_many(a.runs.size(), 0), of_few(b.runs.size(), 0);
    expect_refused([&] { tessellate(b.clipped, a.runs, of_many, {}, {&pen, 1}); });
    expect_refused([&] { tessellate(a.clipped, a.runs, of_few, {}, {&pen, 1}); });
}

TEST(MixedStages, ATracerOfSurfacesThatHaveMovedIsRefusedByTheirName) {
    const Sharp ball(meshes::sphere(16));
    const Drawing& drawn = ball.drawn;
    ball.surface->set_positions(std::vector<vec3>(ball.surface->vertex_count(), vec3(0.5f)));
    const std::string& name = ball.surface->name();
    const auto says_it = [&](const auto& call) { return refused(call).find(name) != std::string::npos; };
    EXPECT_TRUE(
        says_it([&] { extract_paths(drawn.scene, drawn.view, {line_set({"crease"})}, drawn.tracer, Cancel()); }));
    EXPECT_TRUE(says_it([&] { exact_visibility(drawn.clipped, drawn.paths, drawn.tracer, Cancel()); }));
    EXPECT_TRUE(says_it([&] { depth_image(drawn.tracer, Cancel()); }));
}

}  // namespace fovea
