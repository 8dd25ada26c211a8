// SPDX-License-Identifier: GPL-3.0-or-later
// Bevels have one line where they are narrow on paper.
#include <gtest/gtest.h>

#include <fovea/field/strips.h>
#include <fovea/runs/narrow_strips.h>

#include "drawing.h"

using namespace fovea;
using namespace fovea::draw;
using namespace fovea::meshes;
using namespace fovea::drawing;

namespace {

constexpr float width = 0.1f;

/// A side (x = -1), a bevel, and a top (z = 0), in `rows` rows along y. Vertex 4 j + i: point i of the profile in row
/// j.
Mesh bevelled(int rows = 4, bool triangles = false) {
    std::vector<vec3> points;
    for (int j = 0; j <= rows; ++j) {
        const float y = -1.0f + 2.0f * float(j) / float(rows);
        for (const vec2 p : {vec2(-1, -1), vec2(-1, -width), vec2(-1 + width, 0), vec2(1, 0)})
            points.push_back({p.x, y, p.y});
    }
    Mesh mesh("bevelled", points);
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < 3; ++i) {
            const int a = 4 * j + i, b = a + 1, c = b + 4, d = a + 4;
            if (triangles) {
                mesh.add_polygon({a, c, b});
                mesh.add_polygon({a, d, c});
            } else {
                mesh.add_polygon({a, d, c, b});
            }
        }
    return mesh;
}

/// Pixels of the two edges of the bevel, from outside to inside, that are left at this distance.
std::pair<double, double> left(const Mesh& mesh, double distance, const LineSet& set = line_set({"crease"})) {
    const double s = distance / std::sqrt(3.0);
    const Drawing drawn({place(mesh)}, perspective({-s, -s, s}, {-1, 0, 0}), {set});
    const Array<float> least(drawn.paths.count(), 6.0f);
    const Runs kept = without_narrow_strips(drawn.clipped, drawn.runs, drawn.paths, drawn.scene, drawn.view, least);
    std::pair<double, double> sum(0.0, 0.0);
    for (std::size_t r = 0; r < kept.size(); ++r) {
        const Index i = drawn.paths.rows.begin(drawn.clipped.path[kept.piece[r]]);
        if (drawn.paths.kinds[i] != bit_of("crease")) continue;
        (drawn.paths.points_obj[i].z < -0.5f * width ? sum.first : sum.second) += kept.end_px[r] - kept.start_px[r];
    }
    return sum;
}

TEST(Strips, JoinTheTwoEdgesOfABevel) {
    for (const bool triangles : {false, true}) {
        const Mesh mesh = bevelled(4, triangles);
        const auto surface = mesh.surface();
        const auto strips = strips_of(*surface);
        Index joined = 0;
        for (Index e = 0; e < strips->size(); ++e)
            if (const Index other = (*strips)[e]; other != none) {
                ++joined;
                EXPECT_EQ((*strips)[other], e);
            }
        EXPECT_EQ(joined, 8u);
    }
}

TEST(Strips, EdgesInARowAreNone) {
    Mesh roof(
        "roof",
        {{-6, -3, 0}, {0, -3, 0}, {6, -3, 0}, {-6, 0, 1}, {0, 0, 1}, {6, 0, 1}, {-6, 3, 0}, {0, 3, 0}, {6, 3, 0}});
    for (const int a : {0, 1, 3, 4}) roof.add_polygon({a, a + 1, a + 4, a + 3});
    EXPECT_TRUE(strips_of(*roof.surface())->empty());
}

TEST(Strips, BoardsAreNone) { EXPECT_TRUE(strips_of(*box({-1, -1, -0.01f}, {1, 1, 0.01f}).surface())->empty()); }

TEST(NarrowStrips, HaveTwoLinesWhereTheyAreWideOnPaper) {
    const auto [outer, inner] = left(bevelled(), 3.0);
    EXPECT_GT(outer, 100.0);
    EXPECT_GT(inner, 100.0);
}

TEST(NarrowStrips, HaveOneLineWhereTheyAreNarrowOnPaper) {
    for (const bool triangles : {false, true}) {
        const auto [outer, inner] = left(bevelled(4, triangles), 40.0);
        EXPECT_GT(std::max(outer, inner), 5.0);
        EXPECT_EQ(std::min(outer, inner), 0.0);
    }
}

TEST(NarrowStrips, KeepALineThatIsAlone) {
    Mesh mesh = bevelled();
    std::vector<int> outer_edges;
    for (int j = 0; j < 4; ++j) outer_edges.push_back(mesh.edge(4 * j + 1, 4 * j + 5));
    mesh.sharp = mesh.edge_flags(outer_edges);
    const auto [outer, inner] = left(mesh, 40.0, line_set_with("crease", {50.0}));
    EXPECT_GT(outer, 5.0);
    EXPECT_EQ(inner, 0.0) << "it turns by less";
}

TEST(NarrowStrips, LeaveBoardsTheirTwoEdges) {
    const Drawing drawn({place(box({-1, -1, -0.02f}, {1, 1, 0.0f}))}, perspective({-12, -12, 12}, {0, 0, 0}),
                        {line_set({"crease"})});
    const Array<float> least(drawn.paths.count(), 6.0f);
    const Runs kept = without_narrow_strips(drawn.clipped, drawn.runs, drawn.paths, drawn.scene, drawn.view, least);
    EXPECT_EQ(kept.piece, drawn.runs.piece);
    EXPECT_EQ(kept.end_px, drawn.runs.end_px);
}

}  // namespace
