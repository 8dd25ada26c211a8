// SPDX-License-Identifier: GPL-3.0-or-later
// Lines of a surface are not hidden by it, and those behind it do not show, from wherever it is seen.
#include <cmath>
#include <gtest/gtest.h>

#include <fovea/visibility/exact.h>
#include <fovea/visibility/sampled.h>

#include "drawing.h"

using namespace fovea;
using namespace fovea::draw;
using namespace fovea::drawing;

namespace {

/// A sheet of bumps that hide one another.
meshes::Mesh bumps(int n) {
    meshes::Mesh mesh = meshes::grid(n);
    for (vec3& p : mesh.positions)
        p.z = 0.15f * std::sin(7.0f * p.x) * std::cos(9.0f * p.y) + 0.05f * std::sin(23.0f * p.x * p.y);
    return mesh;
}

/// Samples far from a change of exact visibility, and how many of them look otherwise.
struct Count {
    std::size_t visible = 0, looks_hidden = 0, hidden = 0, looks_visible = 0;
    double falsely_hidden() const { return double(looks_hidden) / double(visible); }
    double falsely_visible() const { return double(looks_visible) / double(hidden); }
};

/// All edges of a mesh, judged exactly once.
struct AllEdges {
    Drawing drawing;
    OwnSides sides;
    Array<float> exact;
    AllEdges(const meshes::Mesh& mesh, const View& view, double size = 1.0)
        : drawing({place(mesh, scaled(dvec3(size)))}, view, {line_set_with("crease", {0, 1})}),
          sides(own_sides(drawing.clipped, drawing.scene, view)),
          exact(samples_from_runs(drawing.clipped, drawing.runs)) {}

    Array<float> look(int scale, int probes) const {
        const DepthOptions options{.scale = scale};
        const auto occluders = depth_meshes(drawing.scene, drawing.view, options.margin);
        return sampled_visibility(drawing.clipped, sides,
                                  draw_depth(depth_layout(drawing.view, options), drawing.view, occluders),
                                  {.probes = probes});
    }

    /// Per sample: 1 where it and its neighbors along the path are all visible, or all hidden; 0 for padding.
    Array<std::uint8_t> far_on_path() const {
        Array<std::uint8_t> far(exact.size(), 0);
        for (Index i = 0; i < drawing.clipped.px.size(); ++i)
            for (Index j = 0; j < drawing.clipped.sample_count[i]; ++j) {
                const std::size_t s = drawing.clipped.sample_start[i] + j, last = exact.size() - 1;
                far[s] = (exact[s] == 0.0f || exact[s] == 1.0f) && exact[s - std::min<std::size_t>(s, 1)] == exact[s] &&
                         exact[std::min(s + 1, last)] == exact[s];
            }
        return far;
    }

    /// Also up to two pixels beside the path in the image.
    Array<std::uint8_t> far_in_image() const {
        Array<std::uint8_t> far = far_on_path();
        for (const double offset : {-2.0, -1.0, 1.0, 2.0}) {
            const auto beside = seen_beside(drawing.clipped, drawing.paths, drawing.tracer, offset, Cancel());
            for (std::size_t s = 0; s < far.size(); ++s) far[s] &= (beside[s] != 0) == (exact[s] == 1.0f);
        }
        return far;
    }

    void count(const Array<std::uint8_t>& far, const Array<float>& looked, Count& count) const {
        for (std::size_t s = 0; s < looked.size(); ++s) {
            if (!far[s]) continue;
            ++(exact[s] == 1.0f ? count.visible : count.hidden);
            count.looks_hidden += exact[s] == 1.0f && looked[s] < 0.75f;
            count.looks_visible += exact[s] == 0.0f && looked[s] > 0.25f;
        }
    }
};

std::vector<View> views() {
    std::vector<View> result;
    for (const dvec3 eye : {dvec3(5, -7, 4), dvec3(0.3, -8, 0.6), dvec3(0.1, 0.2, 9), dvec3(4, 6, -3)}) {
        result.push_back(perspective(eye, dvec3(0), 110));
        result.push_back(orthographic(eye, dvec3(0), 3.2));
    }
    return result;
}

/// A mesh from all views, each judged exactly once.
struct Pictures {
    std::vector<std::unique_ptr<AllEdges>> pictures;
    std::vector<Array<std::uint8_t>> far;
    Pictures(const meshes::Mesh& mesh, Array<std::uint8_t> (AllEdges::*far_from_changes)() const) {
        for (const View& view : views()) {
            pictures.push_back(std::make_unique<AllEdges>(mesh, view));
            far.push_back((*pictures.back().*far_from_changes)());
        }
    }
    Count count(int scale, int probes) const {
        Count count;
        for (std::size_t i = 0; i < far.size(); ++i)
            pictures[i]->count(far[i], pictures[i]->look(scale, probes), count);
        return count;
    }
};

constexpr std::pair<int, int> scales_and_probes[] = {{1, 1}, {1, 9}, {2, 1}, {2, 9}, {2, 16}, {3, 1}, {3, 16}};

}  // namespace

TEST(OwnSurface, ConvexMeshesHideNoneOfTheirOutlinesEither) {
    for (const meshes::Mesh& mesh : {meshes::box(), meshes::sphere(8), meshes::sphere(24)}) {
        const Pictures pictures(mesh, &AllEdges::far_on_path);
        for (const auto& [scale, probes] : scales_and_probes) {
            const Count count = pictures.count(scale, probes);
            EXPECT_GT(count.visible, 5000u);
            EXPECT_LE(count.falsely_hidden(), 0.001) << mesh.name << " " << probes << " x " << scale;
            EXPECT_LE(count.falsely_visible(), 0.0001) << mesh.name << " " << probes << " x " << scale;
        }
    }
}

TEST(OwnSurface, BumpsHideTheirLinesOnlyWhereOneIsBeforeAnother) {
    const Pictures pictures(bumps(24), &AllEdges::far_in_image);
    for (const auto& [scale, probes] : scales_and_probes) {
        const Count count = pictures.count(scale, probes);
        EXPECT_GT(count.visible, 20000u);
        EXPECT_GT(count.hidden, 5000u);
        EXPECT_LE(count.falsely_hidden(), 0.001) << probes << " x " << scale;
        EXPECT_LE(count.falsely_visible(), 0.001) << probes << " x " << scale;
    }
}

TEST(OwnSurface, ScaledScenesLookAlike) {
    for (const bool flat : {false, true}) {
        const auto view = [&](double size) {
            const dvec3 eye = size * dvec3(5, -7, 4);
            View seen = flat ? orthographic(eye, dvec3(0), 3.2 * size) : perspective(eye, dvec3(0), 110);
            seen.far_clip *= size;
            return with_near(seen, seen.near_clip * size);
        };
        const Array<float> looked = AllEdges(bumps(24), view(1.0)).look(2, 9);
        for (const double size : {0.001, 1000.0}) {
            const Array<float> other = AllEdges(bumps(24), view(size), size).look(2, 9);
            ASSERT_EQ(other.size(), looked.size());
            std::size_t same = 0;
            for (std::size_t s = 0; s < looked.size(); ++s) same += std::abs(other[s] - looked[s]) < 0.12f;
            EXPECT_GT(double(same), 0.999 * double(looked.size())) << size;
        }
    }
}

TEST(OwnSurface, LinesBehindATiltedPlaneNeverLeak) {
    for (const double tilt : {0.0, 30.0, 60.0, 80.0})
        for (const bool flat : {false, true}) {
            const dvec3 eye = 6.0 * dvec3(0, -std::sin(glm::radians(tilt)), std::cos(glm::radians(tilt)));
            const View view = flat ? orthographic(eye, dvec3(0), 3.2) : perspective(eye, dvec3(0), 80);
            AllEdges edges(meshes::grid(12), view);
            for (float& depth : edges.drawing.clipped.depth) depth -= 2e-5f;
            Array<std::uint8_t> inside = edges.far_in_image();
            const auto at_border = [&](Index i) {
                const vec3 p = edges.drawing.clipped.position_view[i];
                const dvec3 world(glm::inverse(view.world_to_view) * dvec4(dvec3(p), 1.0));
                return std::max(std::abs(world.x), std::abs(world.y)) > 0.99;
            };
            for (Index i = 0; i + 1 < edges.drawing.clipped.px.size(); ++i)
                if (at_border(i) || at_border(i + 1))
                    std::fill_n(inside.begin() + edges.drawing.clipped.sample_start[i],
                                edges.drawing.clipped.sample_count[i], 0);
            // Not the plane's own lines any more.
            for (auto* facets : {&edges.drawing.clipped.facet0, &edges.drawing.clipped.facet1})
                std::fill(facets->begin(), facets->end(), none);
            std::fill(edges.sides.steepness.begin(), edges.sides.steepness.end(), 0.0f);
            for (const auto& [scale, probes] : scales_and_probes) {
                const Array<float> looked = edges.look(scale, probes);
                std::size_t covered = 0, leaks = 0;
                for (std::size_t s = 0; s < looked.size(); ++s) {
                    covered += inside[s];
                    leaks += inside[s] && looked[s] > 0.0f;
                }
                EXPECT_GT(covered, 1000u);
                EXPECT_EQ(leaks, 0u) << tilt << " " << flat << " " << probes << " x " << scale;
            }
        }
}

TEST(OwnSurface, LinesAcrossLargeTrianglesAreHiddenByWhatIsRightBeforeThem) {
    const dmat4 upright = glm::rotate(dmat4(1.0), glm::radians(90.0), dvec3(1, 0, 0));
    const View view = perspective({4, -7, 1}, {0, 0, 0}, 50.0);
    const auto seen = [&](std::vector<Placement> placements) {
        return Drawing(std::move(placements), view, {line_set({"topographic"})}).visible_px(0);
    };
    const Placement wall = place(meshes::grid(1, 9.0f), upright);
    EXPECT_GT(seen({wall}), 500.0);
    for (const double distance : {0.5, 0.1, 0.05})
        EXPECT_EQ(seen({wall, place(meshes::grid(1, 9.0f), moved({0, -distance, 0}) * upright, 2)}), 0.0) << distance;
}
