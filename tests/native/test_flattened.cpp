// SPDX-License-Identifier: GPL-3.0-or-later
// Placements that flatten their surface.
#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <gtest/gtest.h>
#include <numbers>

#include <fovea/scene/flattened.h>

#include "drawing.h"

using namespace fovea;
using namespace fovea::draw;
using namespace fovea::meshes;
using namespace fovea::drawing;

namespace {

const dmat4 tilted = glm::mat4_cast(glm::angleAxis(0.7, glm::normalize(dvec3(1, 2, 3))));

/// The transforms of a unit box, each of rank 2, and its name.
const std::pair<const char*, dmat4> flattening[] = {
    {"x", scaled({0, 1, 1})},
    {"y", scaled({2, 0, 1})},
    {"z", scaled({1, -1, 0})},
    {"turned", moved({3, 1, 2}) * tilted* scaled({1, 0, 1})},
    {"by a parent", scaled({1, 1, 0}) * tilted},
    {"nearly", scaled({1, 1e-8, 1})},
};

double share_seen(const Drawing& drawing) { return drawing.visible_px(0) / drawing.total_px(0); }

}  // namespace

TEST(Flattened, TransformsWithAnInverseStayAsTheyAre) {
    for (const dmat4& map : {dmat4(1.0), scaled({1, 1, 1e-5}), moved({1, 2, 3}) * tilted * scaled({1, -2, 1e3})})
        EXPECT_EQ(with_thickness(map, dvec3(0.5), dvec3(1)), map);
    EXPECT_EQ(with_thickness(scaled({0, 0, 0}), dvec3(0.5), dvec3(1)), scaled({0, 0, 0}));
    const dmat4 broken = scaled({1, 0, NAN});
    EXPECT_TRUE(std::isnan(with_thickness(broken, dvec3(0.5), dvec3(1))[2][2]));
}

TEST(Flattened, FlatOnesGetAnInverseAndMovePointsByLessThanTwoThousandths) {
    const dvec3 center(0.2, -0.4, 0.1), half(1, 2, 3);
    for (const auto& [name, map] : flattening) {
        const dmat4 thick = with_thickness(map, center, half);
        const dmat3 linear(thick);
        EXPECT_GT(glm::determinant(linear), 0.0) << name;
        EXPECT_LT(glm::length((linear * glm::inverse(linear))[0] - dvec3(1, 0, 0)), 1e-9) << name;
        for (int corner = 0; corner < 8; ++corner) {
            const dvec3 side(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
            const dvec4 point(center + side * half, 1.0);
            EXPECT_LT(glm::length(thick * point - map * point), 0.002 * 3 * 2) << name;
        }
    }
}

TEST(Flattened, LinesGetAThicknessTwice) {
    const dmat4 thick = with_thickness(scaled({0, 0, 5}), dvec3(0), dvec3(1));
    EXPECT_GT(glm::determinant(dmat3(thick)), 0.0);
    EXPECT_NEAR(glm::length(dvec3(thick[2])), 5.0, 0.01);
}

TEST(Flattened, NothingOfItIsBelowThePlane) {
    const dmat4 thick = with_thickness(moved({0, 0, 2}) * scaled({1, 1, 0}), dvec3(0, 0, 9), dvec3(1, 1, 4));
    EXPECT_NEAR((thick * dvec4(0, 0, 5, 1)).z, 2.0, 1e-12);
    EXPECT_GT((thick * dvec4(0, 0, 13, 1)).z, 2.001);
}

TEST(Flattened, AMeshThatIsFlatAlreadyStaysInItsPlane) {
    const dmat4 thick = with_thickness(moved({0, 0, 2}) * scaled({1, 1, 0}), dvec3(0), dvec3(1, 1, 0));
    EXPECT_EQ(dvec3(thick * dvec4(1, -1, 0, 1)), dvec3(1, -1, 2));
}

TEST(Flattened, SpheresHaveTheOutlineOfTheirDisk) {
    const View view = orthographic({0, -6, 0}, {0, 0, 0}, 4);
    const Drawing drawing({place(sphere(24), scaled({1, 0, 1}))}, view, {line_set({"contour"})});
    const double around = 2.0 * std::numbers::pi * 640 / 4;  // pixels
    EXPECT_NEAR(drawing.total_px(0), around, 0.01 * around);
    EXPECT_GT(share_seen(drawing), 0.99);
}

TEST(Flattened, BoxesHideTheirBackAndWhatIsBehind) {
    const View view = perspective({0, -6, 1}, {0, 0, 0});
    const Drawing drawing({place(box(), scaled({1, 0, 1})), place(box(), moved({0, 3, 0}) * scaled(dvec3(0.5)), 2)},
                          view, {all_edges()});
    EXPECT_EQ(drawing.visible_px(1), 0.0);
    EXPECT_GT(drawing.visible_px(0), 0.0);
    const auto hit = drawing.tracer.occluder(vec3(view.world_to_view * dvec4(0.1, 3, 0.2, 1)), Ignore());
    ASSERT_TRUE(hit.has_value());
    EXPECT_EQ(hit->placement, 0u);
    EXPECT_NEAR(hit->t, 6.0 / 9.0, 0.01);
}
