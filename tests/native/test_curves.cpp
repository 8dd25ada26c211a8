// SPDX-License-Identifier: GPL-3.0-or-later
// Lines of the field against exact curves on surfaces whose curvature is known.
#include <gtest/gtest.h>

#include <fovea/field/view_curvature.h>
#include <fovea/path/chain_curves.h>

#include "analytic.h"
#include "drawing.h"
#include "rules.h"

using namespace fovea;
using namespace fovea::draw;
using namespace fovea::analytic;
using namespace fovea::drawing;

namespace {

const dvec3 view = glm::normalize(dvec3(.8, .5, 1));

SurfaceView seen_from(const Surface& surface, const dvec3& eye, bool orthographic) {
    SurfaceView seen{.surface = surface};
    seen.eye_obj = eye;
    seen.orthographic = orthographic;
    return seen;
}

/// With default parameters, but for the first when `threshold` is given.
Curves find(const Surface& surface, const char* name, const dvec3& towards = dvec3(.8, .5, 1), double threshold = -1) {
    Values values = defaults(name);
    if (threshold >= 0) values[0] = threshold;
    return rule_of<CurveRule>(name).find(seen_from(surface, glm::normalize(towards), true), values);
}

/// Away from the border of a grid over [-1, 1]^2, where neighborhoods are one-sided.
Curves inner(const Curves& curves) {
    Curves kept;
    for (const CurvePiece& p : curves)
        if (std::max(std::abs(p.point[0].x), std::abs(p.point[0].y)) < 0.95f) kept.push_back(p);
    return kept;
}

double length(const Curves& curves) {
    double sum = 0.0;
    for (const CurvePiece& p : curves) sum += glm::distance(dvec3(p.point[0]), dvec3(p.point[1]));
    return sum;
}

/// Distance of the pieces' middles from the zero set of `value`, to first order, in edge lengths: half and nine tenths
/// of the length lie nearer.
template <typename Value>
std::pair<double, double> distances(const Sample& sample, const Curves& curves, double edge, const Value& value) {
    std::vector<std::pair<double, double>> found;  // distance, length
    double total = 0.0;
    for (const CurvePiece& piece : curves) {
        const dvec3 p = 0.5 * (dvec3(piece.point[0]) + dvec3(piece.point[1]));
        const CurvatureD c = sample.exact(p);
        const double here = value(p, c.e1), step = 1e-5;
        dvec2 gradient;
        for (int i = 0; i < 2; ++i) {
            const dvec3 q = p + step * (i ? c.e2 : c.e1), r = p - step * (i ? c.e2 : c.e1);
            gradient[i] = (value(q, c.e1) - value(r, c.e1)) / (2 * step);
        }
        const double length = glm::distance(dvec3(piece.point[0]), dvec3(piece.point[1]));
        found.push_back({std::abs(here) / glm::length(gradient) / edge, length});
        total += length;
    }
    std::sort(found.begin(), found.end());
    double sum = 0.0, half = -1, most = -1;
    for (const auto& [distance, length] : found) {
        sum += length;
        if (half < 0 && sum >= 0.5 * total) half = distance;
        if (most < 0 && sum >= 0.9 * total) most = distance;
    }
    return {half, most};
}

}  // namespace

class WavesCurves : public testing::TestWithParam<bool> {
   protected:
    const Sample sample = waves({.n = 256, .irregular = GetParam()});
    const std::shared_ptr<Surface> surface = sample.mesh.surface();
    const double edge = 2.0 / 256;

    template <typename Value>
    void near(const char* name, const Value& value, const dvec3& towards = view, double threshold = -1) {
        const Curves curves = inner(find(*surface, name, towards, threshold));
        const auto [half, most] = distances(sample, curves, edge, value);
        std::printf("[ figure ] %s, %s: %.3f / %.3f edges, length %.3f\n", name, GetParam() ? "irregular" : "regular",
                    half, most, length(curves));
        EXPECT_GT(length(curves), 1.0) << name;
        EXPECT_LE(half, .02) << name;
        EXPECT_LE(most, .07) << name;
    }
};

TEST_P(WavesCurves, SmoothContour) {
    const dvec3 low = glm::normalize(dvec3(.9, .3, .25));
    near("smooth_contour", [&](const dvec3& p, const dvec3&) { return glm::dot(sample.exact(p).normal, low); }, low);
}
TEST_P(WavesCurves, SuggestiveContour) {
    near("suggestive_contour", [&](const dvec3& p, const dvec3&) {
        const CurvatureD c = sample.exact(p);
        return radial(c, see(c, view, 0.0)).scaled;
    });
}
TEST_P(WavesCurves, SuggestiveHighlight) {
    near(
        "suggestive_highlight",
        [&](const dvec3& p, const dvec3&) {
            const CurvatureD c = sample.exact(p);
            return radial(c, see(c, view, 0.0)).scaled;
        },
        view, 0.0);
}
TEST_P(WavesCurves, Ridge) {
    near("ridge", [&](const dvec3& p, const dvec3& e1) {
        const CurvatureD c = sample.exact(p);
        return glm::dot(c.e1, e1) < 0 ? -c.C[0] : c.C[0];
    });
}
TEST_P(WavesCurves, Valley) {
    near("valley", [&](const dvec3& p, const dvec3& e1) {
        const CurvatureD c = sample.exact(p);
        return glm::dot(c.e1, e1) < 0 ? -c.C[0] : c.C[0];
    });
}
TEST_P(WavesCurves, ApparentRidge) {
    // The sign of a is that which agrees with a at a place nearby.
    dvec3 last(0);
    near(
        "apparent_ridge",
        [&](const dvec3& p, const dvec3& e1) {
            const CurvatureD c = sample.exact(p);
            const auto v = view_curvature(c, see(c, view, 0.0));
            const dvec3 a = v.a1 * c.e1 + v.a2 * c.e2;
            (void)e1;
            if (glm::dot(a, last) < 0) return -v.derivative / glm::length(a);
            last = a;
            return v.derivative / glm::length(a);
        },
        view, 0.0);
}
TEST_P(WavesCurves, Demarcating) {
    near(
        "demarcating_curve", [&](const dvec3& p, const dvec3&) { return demarcating(sample.exact(p)).curvature; }, view,
        0.0);
}
TEST_P(WavesCurves, Laplacian) {
    near("laplacian_line", [&](const dvec3& p, const dvec3&) {
        const CurvatureD c = sample.exact(p);
        return laplacian(c, see(c, view, 0.0));
    });
}
TEST_P(WavesCurves, Parabolic) {
    near("parabolic", [&](const dvec3& p, const dvec3&) {
        const CurvatureD c = sample.exact(p);
        return c.k1 * c.k2;
    });
}
TEST_P(WavesCurves, ZeroMeanCurvature) {
    near("zero_mean_curvature", [&](const dvec3& p, const dvec3&) {
        const CurvatureD c = sample.exact(p);
        return c.k1 + c.k2;
    });
}
INSTANTIATE_TEST_SUITE_P(Grids, WavesCurves, testing::Bool(),
                         [](const auto& info) { return info.param ? "Irregular" : "Regular"; });

TEST(Curves, TheSmoothContourOfARoundBodyIsSeenWhole) {
    // Its points lie before or behind the edges where the mesh turns away, yet its own surface does not hide it.
    const auto seen_share = [](const meshes::Mesh& mesh, const dvec3& eye) {
        const Drawing drawing({place(mesh)}, perspective(eye, dvec3(0)), {line_set({"smooth_contour"})});
        return drawing.visible_px(0) / drawing.total_px(0);
    };
    for (const dvec3& eye : {dvec3(4, -5, 3), dvec3(0.3, 6, 1), dvec3(5, 0.2, 0.1)}) {
        EXPECT_GT(seen_share(meshes::sphere(16), eye), 0.999);
        EXPECT_GT(seen_share(meshes::sphere(48), eye), 0.999);
    }
    // Seen from above at a slant, a torus hides no more than the far part of its inner contour.
    const double share = seen_share(torus({.n = 96, .irregular = true}).mesh, dvec3(4, -5, 5));
    EXPECT_GT(share, 0.95);
}

TEST(Curves, TorusAndSphereHaveNoCrests) {
    for (const bool irregular : {false, true}) {
        const auto surface = torus({.n = 128, .irregular = irregular}).mesh.surface();
        EXPECT_EQ(length(find(*surface, "ridge")), 0.0) << irregular;
        EXPECT_EQ(length(find(*surface, "valley")), 0.0) << irregular;
    }
    const auto ball = meshes::sphere(64).surface();
    for (const char* name : {"ridge", "valley", "suggestive_contour", "suggestive_highlight"})
        EXPECT_EQ(length(find(*ball, name)), 0.0) << name;
    EXPECT_NEAR(length(find(*ball, "smooth_contour")), 2 * M_PI, 0.02);
}
