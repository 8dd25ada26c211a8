// SPDX-License-Identifier: GPL-3.0-or-later
// Smooth contours against their own mesh (scene/tracer.h, Ignore): how much of what the smooth surface shows is hidden
// by the mesh that stands for it, or broken, and whether that flickers when the camera moves.
#include <functional>
#include <gtest/gtest.h>

#include "analytic.h"
#include "drawing.h"

using namespace fovea;
using namespace fovea::draw;
using namespace fovea::drawing;

namespace {

/// A mesh and the smooth surface that it stands for.
struct Body {
    const char* name;
    meshes::Mesh mesh;
    std::function<double(const dvec3&)> distance;  ///< to the surface, negative inside
};

double to_sphere(const dvec3& p) { return glm::length(p) - 1.0; }
double to_torus(const dvec3& p) { return glm::length(dvec2(glm::length(dvec2(p)) - 1.0, p.z)) - 0.4; }

std::vector<Body> bodies() {
    std::vector<Body> all;
    for (const bool irregular : {false, true}) {
        all.push_back({"coarse sphere", analytic::icosphere(2, irregular), to_sphere});
        all.push_back({"fine sphere", analytic::icosphere(4, irregular), to_sphere});
        all.push_back({"coarse torus", analytic::torus({.n = 64, .irregular = irregular}).mesh, to_torus});
        all.push_back({"fine torus", analytic::torus({.n = 192, .irregular = irregular}).mesh, to_torus});
    }
    return all;
}

enum Truth { hidden, seen, unsure };

/// Whether the smooth body hides a point of its contour: it does where the way to the eye leads through it, and not
/// where that rises from the surface and stays clear of it. In between, and near cusps, where it rises slowly, nothing
/// is said.
Truth truth_of(const Body& body, dvec3 point, const dvec3& eye) {
    constexpr double clear = 0.02, grazing = 0.004, step = 0.004, soon = 0.35;
    for (int i = 0; i < 3; ++i) {
        dvec3 slope;
        for (int k = 0; k < 3; ++k) {
            dvec3 beside = point;
            beside[k] += 1e-5;
            slope[k] = (body.distance(beside) - body.distance(point)) / 1e-5;
        }
        point -= body.distance(point) * slope;
    }
    const dvec3 way = glm::normalize(eye - point);
    bool risen = false, sure = true;
    for (double s = step; s < 4.0; s += step) {
        const double d = body.distance(point + s * way);
        if (d < -clear) return hidden;
        if (d < (risen ? clear : -grazing) || (!risen && s > soon)) sure = false;
        risen = risen || d > clear;
    }
    return sure ? seen : unsure;
}

/// What one frame says of a body's contour. Places: along the contour, 720 each way around.
struct Measured {
    double seen_px = 0.0, lost_px = 0.0, hidden_px = 0.0, leaked_px = 0.0;
    int breaks = 0;
    std::map<int, std::pair<Truth, bool>> at;  // place -> truth, whether it is drawn

    Measured(const Body& body, const std::shared_ptr<const Surface>& surface, const View& view) {
        const Drawing drawing({{surface, dmat4(1.0), 1}}, view, {line_set({"smooth_contour"})});
        const ClippedPaths& clipped = drawing.clipped;
        const Array<float> visible = samples_from_runs(clipped, drawing.runs);
        const dmat4 to_world = glm::inverse(view.world_to_view);
        const dvec3 eye(to_world[3]);
        for (Index q = 0; q < clipped.pieces.count(); ++q) {
            bool before = false;  // seen, and drawn
            for (Index i = clipped.pieces.begin(q); i + 1 < clipped.pieces.end(q); ++i)
                for (Index j = 0; j < clipped.sample_count[i]; ++j) {
                    const float s = (j + 0.5f) / clipped.sample_count[i];
                    const vec3 in_view = glm::mix(clipped.position_view[i], clipped.position_view[i + 1], s);
                    const dvec3 point(to_world * dvec4(dvec3(in_view), 1.0));
                    const double px = (clipped.arc_px[i + 1] - clipped.arc_px[i]) / clipped.sample_count[i];
                    const Truth truth = truth_of(body, point, eye);
                    const bool drawn = visible[clipped.sample_start[i] + j] > 0.5f;
                    if (truth == seen) (drawn ? seen_px : lost_px) += px;
                    if (truth == hidden) (drawn ? leaked_px : hidden_px) += px;
                    breaks += before && truth == seen && !drawn;
                    before = truth == seen && drawn;
                    at[place(body, point, in_view, view)] = {truth, drawn};
                }
        }
    }

    /// Around the middle of the image, or around the torus: inside, outside, above, below.
    static int place(const Body& body, const dvec3& p, const vec3& in_view, const View& view) {
        const bool round = body.distance(dvec3(1, 0, 0)) == 0.0;
        const dvec3 middle(view.world_to_view[3]);
        const dvec2 from = round ? dvec2(in_view) - dvec2(middle) : dvec2(p);
        const int angle = static_cast<int>((std::atan2(from.y, from.x) / std::numbers::pi + 1.0) * 360.0);
        return angle + (round ? 0 : 1000 * (1 + (glm::length(dvec2(p)) > 1.0) + 2 * (p.z > 0.0)));
    }
};

/// Over an orbit of 20 small steps.
struct Orbit {
    double lost = 0.0, leaked = 0.0;  ///< shares of what the smooth surface shows, and hides
    double breaks = 0.0;              ///< per 1000 px
    double flicker = 0.0;             ///< share of places that change though the smooth surface does not

    explicit Orbit(const Body& body) {
        const auto surface = body.mesh.surface();
        double seen_px = 0.0, hidden_px = 0.0;
        int compared = 0, changed = 0;
        std::map<int, std::pair<Truth, bool>> last;
        for (int k = 0; k < 20; ++k) {
            const double turn = 0.3 + 0.005 * k;
            const Measured measured(body, surface,
                                    perspective({4 * std::cos(turn), 4 * std::sin(turn), 2.6}, {0, 0, 0}, 50));
            seen_px += measured.seen_px + measured.lost_px;
            hidden_px += measured.hidden_px + measured.leaked_px;
            lost += measured.lost_px;
            leaked += measured.leaked_px;
            breaks += measured.breaks;
            for (const auto& [where, now] : measured.at) {
                const auto then = last.find(where);
                if (then == last.end() || now.first == unsure || then->second.first != now.first) continue;
                ++compared;
                changed += then->second.second != now.second;
            }
            last = measured.at;
        }
        EXPECT_GT(seen_px, 20 * 500.0) << body.name;
        EXPECT_GT(compared, 20 * 100) << body.name;
        lost /= seen_px;
        leaked /= std::max(hidden_px, 1.0);
        breaks /= seen_px / 1000.0;
        flicker = double(changed) / compared;
    }
};

}  // namespace

TEST(ContourVisibility, TheMeshHidesNothingOfWhatTheSmoothSurfaceShows) {
    for (const Body& body : bodies()) {
        const Orbit orbit(body);
        EXPECT_LT(orbit.lost, 0.001) << body.name;
        EXPECT_LT(orbit.leaked, 0.001) << body.name;
        EXPECT_LT(orbit.breaks, 0.05) << body.name;
        EXPECT_LT(orbit.flicker, 0.001) << body.name;
    }
}

TEST(ContourVisibility, AnotherSolidOfTheSameMeshHidesAContourAsAnotherObjectDoes) {
    // Two balls that stick into each other, 16 segments around: their sides are half as long as the way that a
    // contour's own solid is ignored for.
    const meshes::Mesh ball = meshes::sphere(8);
    meshes::Mesh both = ball;
    const vec3 by(0.9f, -0.5f, 0.4f);
    for (const vec3& p : ball.positions) both.positions.push_back(0.7f * p + by);
    for (std::size_t f = 0; f + 1 < ball.polygon_offsets.size(); ++f) {
        std::vector<int> verts(ball.corner_verts.begin() + ball.polygon_offsets[f],
                               ball.corner_verts.begin() + ball.polygon_offsets[f + 1]);
        for (int& v : verts) v += int(ball.positions.size());
        both.add_polygon(verts);
    }
    const View view = perspective({0, -6, 0}, dvec3(0));
    const std::vector<LineSet> sets{line_set({"smooth_contour"})};
    const Drawing one({place(both)}, view, sets);
    const Drawing two({place(ball), place(ball, moved(dvec3(by)) * scaled(dvec3(0.7)), 2)}, view, sets);
    const double apart = two.visible_px(0) + two.visible_px(1);
    EXPECT_LT(apart, 0.9 * (two.total_px(0) + two.total_px(1))) << "they hide nothing of each other";
    EXPECT_NEAR(one.visible_px(0), apart, 0.01 * apart);
}
