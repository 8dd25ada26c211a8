// SPDX-License-Identifier: GPL-3.0-or-later
// Smooth contours and silhouettes: where they end, who has them, and nothing drawn twice.
#include <bit>
#include <gtest/gtest.h>
#include <set>

#include <fovea/field/view_curvature.h>
#include <fovea/line/zero_set.h>
#include <fovea/path/doubles.h>
#include <fovea/path/find_curves.h>

#include "analytic.h"
#include "drawing.h"
#include "rules.h"

using namespace fovea;
using namespace fovea::draw;
using namespace fovea::drawing;

namespace {

const dvec3 oblique = glm::normalize(dvec3(0.2, -1, 0.5));

CurveChains contour_of(const Surface& surface, double end_at_cusps) {
    SurfaceView seen{.surface = surface};
    seen.eye_obj = oblique;
    seen.orthographic = true;
    return curves_of(rule_of<CurveRule>("smooth_contour"), seen, {end_at_cusps});
}

/// Half a sphere of radius 1 above z = 0, of 4 n segments and n rings, with a wall as far in as a radius `inside`.
meshes::Mesh bell(int n, float inside) {
    std::vector<vec3> points;
    for (const float radius : {1.0f, inside})
        for (int ring = 0; ring < n; ++ring)
            for (int i = 0; i < 4 * n; ++i) {
                const double up = M_PI / 2 * ring / n, around = M_PI / 2 * i / n;
                points.push_back(radius *
                                 vec3(std::cos(up) * std::cos(around), std::cos(up) * std::sin(around), std::sin(up)));
            }
    points.insert(points.end(), {vec3(0, 0, 1), vec3(0, 0, inside)});
    meshes::Mesh mesh("bell", points);
    const int within = 4 * n * n;
    for (int i = 0; i < 4 * n; ++i) {
        const int j = (i + 1) % (4 * n);
        mesh.add_polygon({j, i, within + i, within + j});
        for (int ring = 0; ring < n; ++ring) {
            const bool top = ring + 1 == n;
            const int a = 4 * n * ring + i, b = 4 * n * ring + j, c = b + 4 * n, d = a + 4 * n;
            mesh.add_polygon(top ? std::vector{a, b, 2 * within} : std::vector{a, b, c, d});
            mesh.add_polygon(top ? std::vector{within + b, within + a, 2 * within + 1}
                                 : std::vector{within + b, within + a, within + d, within + c});
        }
    }
    return mesh;
}

/// Kinds of all segments of a drawing, and the triangles of each line set's curves.
struct Drawn {
    std::map<Kinds, int> kinds;
    std::map<int, std::multiset<Index>> triangles;

    explicit Drawn(const Drawing& drawing) {
        const Paths& paths = drawing.paths;
        const Surface& surface = *drawing.scene.placements[0].surface;
        for (Index p = 0; p < paths.count(); ++p)
            for (Index i = paths.rows.begin(p); i + 1 < paths.rows.end(p); ++i) {
                ++kinds[paths.kinds[i]];
                if (!surface.is_edge(paths.place[i]))
                    triangles[paths.line_set[p]].insert(surface.triangle_at(paths.place[i]));
            }
    }
};

}  // namespace

TEST(SmoothContour, EndsAtTheCuspsOfATorus) {
    for (const bool irregular : {false, true}) {
        const analytic::Sample sample = analytic::torus({.n = 192, .irregular = irregular});
        const auto surface = sample.mesh.surface();
        const double edge = 2 * M_PI * 1.4 / 192;
        const auto k_r = [&](const vec3& p) {
            const CurvatureD c = sample.exact(dvec3(p));
            return radial(c, see(c, oblique, 0.0)).curvature;
        };
        const CurveChains whole = contour_of(*surface, 0), ended = contour_of(*surface, 1);
        ASSERT_EQ(whole.rows.count(), 2u);
        for (Index c = 0; c < 2; ++c) EXPECT_TRUE(whole.closed[c]);
        // The inner contour has four cusps: what lies behind them is hidden by the torus itself.
        std::size_t ends = 0;
        for (Index c = 0; c < ended.rows.count(); ++c) {
            for (Index i = ended.rows.begin(c); i < ended.rows.end(c); ++i)
                EXPECT_GT(k_r(ended.point[i]), -0.1) << irregular;
            if (ended.closed[c]) continue;
            for (const Index i : {ended.rows.begin(c), ended.rows.end(c) - 1}) {
                ++ends;
                EXPECT_NEAR(k_r(ended.point[i]), 0.0, 0.1) << irregular;
            }
        }
        EXPECT_EQ(ends, 4u);
        double lost = 0.0, hidden = 0.0;
        for (const auto* chains : {&whole, &ended})
            for (Index c = 0; c < chains->rows.count(); ++c)
                for (Index i = chains->rows.begin(c); i + 1 < chains->rows.end(c); ++i) {
                    const double length = glm::distance(chains->point[i], chains->point[i + 1]);
                    lost += chains == &whole ? length : -length;
                    if (chains == &whole && k_r(0.5f * (chains->point[i] + chains->point[i + 1])) < 0) hidden += length;
                }
        EXPECT_GT(hidden, 10 * edge);
        EXPECT_NEAR(lost, hidden, 4 * edge) << "what goes is what is hidden";
    }
}

TEST(SmoothContour, PartsThatAreInsideOutHideNothingOfTheirOwn) {
    const meshes::Mesh torus = analytic::torus({.n = 96}).mesh;
    const Index own = torus.polygon_offsets.size() - 1;
    const auto surface = meshes::with_another(torus, meshes::flipped(torus, [](int) { return true; })).surface();
    const CurveChains ended = contour_of(*surface, 1);
    int open = 0, closed = 0;
    for (Index c = 0; c < ended.rows.count(); ++c) {
        const bool second = surface->triangle_facet[ended.triangle[ended.rows.begin(c)]] >= own;
        EXPECT_EQ(ended.closed[c] != 0, second || ended.rows.size(c) > 200u);
        (ended.closed[c] ? closed : open) += second;
    }
    EXPECT_EQ(closed, 2);
    EXPECT_EQ(open, 0);
}

TEST(SmoothContour, NothingThatIsSeenGoesAtCusps) {
    const auto visible = [](double end_at_cusps) {
        const Drawing drawing({place(analytic::torus({.n = 128, .irregular = true}).mesh)},
                              perspective(6.0 * oblique, dvec3(0)), {line_set_with("smooth_contour", {end_at_cusps})});
        return drawing.visible_px(0);
    };
    EXPECT_NEAR(visible(1), visible(0), 0.02 * visible(0));
}

TEST(SmoothContour, TakesThePlaceOfTheMeshContour) {
    const View view = perspective({4, -5, 3}, dvec3(0));
    for (const auto& mesh : {meshes::sphere(32), analytic::torus({.n = 96, .irregular = true}).mesh}) {
        const Drawing drawing({place(mesh)}, view, {line_set({"contour", "smooth_contour"})});
        EXPECT_GT(Drawn(drawing).kinds.at(bit_of("smooth_contour")), 50) << mesh.name;
        // Behind cusps, where the smooth one ends, that of the mesh remains, and is hidden.
        double seen = 0.0;
        for (const auto& [edge, kinds] : drawing.lines())
            if (kinds == bit_of("contour")) seen += drawing.length_of(edge).visible;
        EXPECT_LT(seen, 0.02 * drawing.visible_px(0)) << mesh.name;
    }
    const Drawn alone(Drawing({place(meshes::sphere(32))}, view, {line_set({"contour"})}));
    EXPECT_GT(alone.kinds.at(bit_of("contour")), 30) << "where there is no other";
}

TEST(SmoothContour, HardEdgesKeepTheMeshContour) {
    const Drawing drawing({place(meshes::box())}, perspective({4, -5, 3}, dvec3(0)),
                          {line_set({"contour", "smooth_contour"})});
    std::size_t edges = 0;
    for (const auto& [at, kinds] : drawing.lines()) edges += kinds == bit_of("contour");
    EXPECT_EQ(edges, 6u);
}

TEST(SmoothContour, NoOtherLineRunsAlongIt) {
    // On a sphere: a parallel of the contour close by goes, a circle across it stays, and so does a parallel far away.
    const auto surface = meshes::sphere(48).surface();
    SurfaceView seen{.surface = *surface};
    seen.eye_obj = oblique;
    seen.orthographic = true;
    const auto near = near_smooth_contour(seen);
    const dvec3 aside = glm::normalize(glm::cross(oblique, dvec3(0, 0, 1)));
    const auto circle = [&](const dvec3& normal, double offset) {
        const auto one = [](auto) { return 1.0f; };
        const auto height = [&](Index v) { return float(glm::dot(normal, dvec3(surface->positions[v])) - offset); };
        return chain_curves(trace_zero_set(*surface, height, one, one));
    };
    ASSERT_EQ(circle(oblique, 0.03).rows.count(), 1u);
    EXPECT_EQ(without_doubles(circle(oblique, 0.03), *surface, near).rows.count(), 0u);
    for (const CurveChains& chains : {circle(aside, 0.01), circle(oblique, 0.4)}) {
        const CurveChains left = without_doubles(chains, *surface, near);
        ASSERT_EQ(left.rows.count(), 1u);
        EXPECT_TRUE(left.closed[0]);
        EXPECT_EQ(left.point.size(), chains.point.size());
    }
}

TEST(SmoothSilhouette, IsTheOuterBoundaryAndNothingTwice) {
    // So low that the torus's own far side lies behind its hole.
    const auto mesh = analytic::torus({.n = 128, .irregular = true}).mesh;
    const View view = perspective({5, -2, 1.2}, dvec3(0));
    const Drawing drawing({place(mesh)}, view, {line_set({"smooth_silhouette"}), line_set({"smooth_contour"})});
    const Drawn drawn(drawing);
    const auto &outer = drawn.triangles.at(0), &inner = drawn.triangles.at(1);
    EXPECT_GT(outer.size(), 100u);
    EXPECT_GT(inner.size(), 10u);
    for (Index t : inner) EXPECT_EQ(outer.count(t), 0u) << "drawn twice";
    const Drawn contour(Drawing({place(mesh)}, view, {line_set_with("smooth_contour", {1})}));
    std::set<Index> both(outer.begin(), outer.end());
    both.insert(inner.begin(), inner.end());
    for (Index t : contour.triangles.at(0)) EXPECT_TRUE(both.count(t)) << "missing";
}

TEST(SmoothSilhouette, TheInsideOfAThickBellHasNone) {
    const meshes::Mesh mesh = bell(4, 0.8f);  // as coarse as the wall is thick
    for (const double height : {1.0, 2.5, 4.0}) {
        const Drawing drawing({place(mesh)}, perspective({1, -5, height}, dvec3(0)), {line_set({"smooth_silhouette"})});
        const auto outer = Drawn(drawing).triangles[0];
        EXPECT_GT(outer.size(), 10u) << height;
        const Surface& surface = *drawing.scene.placements[0].surface;
        for (const Index t : outer) {
            const auto is_inside = [&](int k) {
                const vec3& p = surface.positions[surface.triangles[t][k]];
                return p.z > 0.0f && glm::length(p) < 0.9f;  // above the rim
            };
            EXPECT_FALSE(is_inside(0) && is_inside(1) && is_inside(2)) << height;
        }
    }
}

TEST(SmoothSilhouette, TheContourGoesOnWhereItEnds) {
    const auto mesh = analytic::torus({.n = 128, .irregular = true}).mesh;
    const auto free_ends = [&](const std::vector<LineSet>& sets) {
        std::map<int, int> count;
        const Drawing drawing({place(mesh)}, perspective({5, -2, 1.2}, dvec3(0)), sets);
        for (Index p = 0; p < drawing.paths.count(); ++p)
            count[drawing.paths.line_set[p]] += std::popcount(drawing.paths.free_ends[p]);
        return count;
    };
    const LineSet outer = line_set({"smooth_silhouette"}), whole = line_set({"smooth_contour"});
    EXPECT_GT(free_ends({outer})[0], 0) << "alone, nothing does";
    auto both = free_ends({outer, whole});
    EXPECT_EQ(both[0], 0);
    EXPECT_LE(both[1], free_ends({whole})[0]) << "at most its cusps";
}

TEST(SmoothSilhouette, OfMeshEdgesStandsForIt) {
    // Drawn thick along mesh edges, it has no thin smooth contour beside it.
    const View view = perspective({4, -5, 3}, dvec3(0));
    const Drawn drawn(
        Drawing({place(meshes::sphere(32))}, view, {line_set({"silhouette"}), line_set({"smooth_contour"})}));
    EXPECT_EQ(drawn.triangles.size(), 0u);
    EXPECT_GT(drawn.kinds.at(bit_of("silhouette")), 30);
}

TEST(SmoothSilhouette, BesideThatOfMeshEdgesIsDrawnAsAlone) {
    const View view = perspective({4, -5, 3}, dvec3(0));
    const auto drawn = [&](const std::vector<LineSet>& sets) {
        return Drawn(Drawing({place(meshes::sphere(32))}, view, sets));
    };
    const Drawn alone = drawn({line_set({"smooth_silhouette"})});
    ASSERT_GT(alone.triangles.at(0).size(), 30u);
    for (const auto& beside : {drawn({line_set({"silhouette", "smooth_silhouette"})}),
                               drawn({line_set({"smooth_silhouette"}), line_set({"silhouette"})}),
                               drawn({line_set({"smooth_silhouette"}), line_set({"silhouette", "smooth_contour"})})}) {
        EXPECT_EQ(beside.triangles.at(0), alone.triangles.at(0));
        EXPECT_EQ(beside.kinds, alone.kinds);
    }
}

TEST(SmoothSilhouette, AnObjectBeforeAnotherHasItsOwn) {
    const Drawing drawing({place(meshes::sphere(32), moved({2, -2.5, 1.5}) * scaled(dvec3(0.3)), 1),
                           place(meshes::sphere(32), dmat4(1.0), 2)},
                          perspective({6, -7.5, 4.5}, dvec3(0)),
                          {line_set({"smooth_silhouette"}), line_set({"smooth_contour"})});
    ASSERT_EQ(drawing.paths.count(), 2u) << "a circle each";
    for (Index p = 0; p < 2; ++p) {
        EXPECT_EQ(drawing.paths.line_set[p], 0);
        EXPECT_TRUE(drawing.paths.closed[p]);
    }
}
