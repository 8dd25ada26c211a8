// SPDX-License-Identifier: GPL-3.0-or-later
// Forks at ends of contours (runs/forks.h), and the runs that pass a place (runs/touches.h).
#include <numbers>

#include <fovea/runs/forks.h>
#include <fovea/runs/touches.h>

#include "line_filters.h"

using namespace fovea;
using namespace fovea::draw;
using namespace fovea::line_filters;

namespace {

constexpr double spoke_px = 20.0;
constexpr ForkOptions options{2.0, 15.0, 2.0};

/// Six triangles around a vertex at the middle of the picture, whose edges from there are contours, as paths; seen
/// from above, and in each run so many pixels from the middle.
struct Fan {
    Scene scene;
    Paths paths;
    ClippedPaths clipped;
    Runs runs;

    /// `away`: of the middle of the picture, which is a tip if that is nearer than the others, at 4. The second three
    /// spokes belong to a fan of their own, at `others_away`.
    explicit Fan(const std::vector<double>& seen_px, double away = 4.0, double others_away = 4.0,
                 std::uint8_t of_view = 1) {
        std::vector<vec3> positions;
        meshes::Polygons polygons;
        for (const double back : {0.0, others_away - 4.0}) {
            const int middle = int(positions.size());
            positions.push_back(vec3(at(320, 240, away + back)));
            for (int k = 0; k < 6; ++k) {
                const double turn = k * std::numbers::pi / 3.0;
                positions.push_back(
                    vec3(at(320 + spoke_px * std::cos(turn), 240 + spoke_px * std::sin(turn), 4.0 + back)));
                polygons.push_back({middle, middle + 1 + k, middle + 1 + (k + 1) % 6});
            }
        }
        meshes::Mesh mesh = meshes::of_polygons("fan", positions, polygons);
        for (std::size_t k = 0; k < seen_px.size(); ++k) {
            const int middle = k < 3 || others_away == 4.0 ? 0 : 7;
            for (const int vertex : {middle, middle + 1 + int(k % 6)}) {
                paths.points_obj.push_back(mesh.positions[vertex]);
                paths.arc_obj.push_back(double(paths.arc_obj.size() % 2));
                paths.place.push_back(Index(mesh.edge(middle, middle + 1 + int(k % 6))));
                paths.edge_t.push_back(0.0f);
                paths.kinds.push_back(1);
                paths.strength.push_back(1.0f);
            }
            paths.closed.push_back(0);
            paths.id.push_back(k);
            paths.placement.push_back(0);
            paths.line_set.push_back(0);
            paths.free_ends.push_back(0);
            paths.of_view.push_back(of_view);
            paths.rows.offsets.push_back(Index(paths.points_obj.size()));
        }
        scene = Scene({drawing::place(mesh)});
        clipped = project::project(paths, scene, camera(), {}, Cancel());
        for (Index q = 0; q < clipped.path.size(); ++q)
            runs.push(q, clipped.first_arc(q), clipped.first_arc(q) + seen_px[q]);
    }

    /// Lengths of what is left, by spoke.
    std::vector<double> left() const {
        const Runs kept = without_forks(clipped, runs, paths, scene, options);
        std::vector<double> lengths(clipped.path.size(), 0.0);
        for (std::size_t r = 0; r < kept.size(); ++r) lengths[kept.piece[r]] = kept.end_px[r] - kept.start_px[r];
        for (double& length : lengths) length = std::round(length);
        return lengths;
    }
};

using Lengths = std::vector<double>;

}  // namespace

TEST(Forks, KeepTheLineAndTheLongestArm) {
    EXPECT_EQ(Fan({20, 8, 12, 10}).left(), (Lengths{20, 0, 12, 0}));
    EXPECT_EQ(Fan({20, 12}).left(), (Lengths{20, 12})) << "a line that goes on is no fork";
}

TEST(Forks, LoseAllArmsBesideALineThatGoesOn) { EXPECT_EQ(Fan({20, 8, 12, 20}).left(), (Lengths{20, 0, 0, 20})); }

TEST(Forks, AreNotWhereALineIsDrawnTwice) {
    EXPECT_EQ(Fan({20, 0, 0, 12, 0, 0, 20}).left(), (Lengths{20, 0, 0, 12, 0, 0, 20}));
}

TEST(Forks, AreNotWhereThreeLinesMeet) { EXPECT_EQ(Fan({20, 20, 20}).left(), (Lengths{20, 20, 20})); }

TEST(Forks, AreNotAtTheEdgesOfAPointedSurface) {
    EXPECT_EQ(Fan({20, 8, 12, 10}, 3.0).left(), (Lengths{20, 8, 12, 10}));
}

TEST(Forks, AreNotWhereALineIsHiddenBehindAnother) {
    EXPECT_EQ(Fan({20, 8, 0.5, 20}, 4.0, 4.0).left()[1], 0.0);
    EXPECT_EQ(Fan({20, 8, 0.5, 20}, 4.0, 12.0).left()[1], 8.0);
}

TEST(Forks, AreOfContoursAlongMeshEdges) {
    for (const std::uint8_t of_view : {std::uint8_t(0), ends_at_cusps})
        EXPECT_EQ(Fan({20, 8, 12, 10}, 4.0, 4.0, of_view).left(), (Lengths{20, 8, 12, 10})) << int(of_view);
}

TEST(Touches, AreOfRunsWithThePlacesKeyWithinADistance) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> x(20.0, 600.0), y(20.0, 460.0);
    std::vector<std::vector<dvec3>> lines;
    for (int k = 0; k < 40; ++k) lines.push_back({at(x(random), y(random)), at(x(random), y(random))});
    const ClippedPaths clipped = Wires(lines).project(camera());
    const Runs runs = whole(clipped);
    Array<Place> places;
    Array<Index> keys, own;
    for (Index k = 0; k < 600; ++k) places.push_back({{x(random), y(random)}, k % 2});
    for (Index r = 0; r < runs.size(); ++r) keys.push_back(r % 3 == 2 ? none : r % 3);
    for (Index k = 0; k < places.size(); ++k) own.push_back(k % Index(runs.size()));
    const Array<Touch> found = touches_of(clipped, runs, places, keys, 5.0);
    const Array<std::uint8_t> touched = touched_by_others(clipped, runs, places, own, 5.0);
    std::size_t expected = 0;
    for (Index k = 0; k < places.size(); ++k) {
        bool any = false;
        for (Index r = 0; r < runs.size(); ++r) {
            const dvec2 a(clipped.px[2 * r]), way = dvec2(clipped.px[2 * r + 1]) - a, px = places[k].px;
            const double t = std::clamp(glm::dot(px - a, way) / glm::dot(way, way), 0.0, 1.0);
            if (glm::distance(px, a + t * way) > 5.0) continue;
            any |= r != own[k];
            if (keys[r] != places[k].key) continue;
            ASSERT_LT(expected, found.size());
            const Touch& touch = found[expected++];
            EXPECT_EQ(touch.place, k);
            EXPECT_EQ(touch.run, r);
            EXPECT_NEAR(touch.arc, clipped.first_arc(r) + t * glm::length(way), 1e-3);
        }
        EXPECT_EQ(touched[k], any) << k;
    }
    EXPECT_EQ(found.size(), expected);
    EXPECT_GT(expected, 50u);
}
