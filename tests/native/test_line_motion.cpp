// SPDX-License-Identifier: GPL-3.0-or-later
// How lines move from frame to frame, in closed form.
#include <gtest/gtest.h>

#include <fovea/draw/frame.h>
#include <fovea/draw/line_motion.h>
#include <fovea/style/json.h>

#include "drawing.h"

using namespace fovea;
using namespace fovea::draw;
using namespace fovea::drawing;

namespace {

const View above = orthographic({0, 0, 10}, {0, 0, 0}, 4.0, 400, 400);  // 100 pixels to a unit

std::shared_ptr<const Pose> pose(const std::vector<Placement>& placements, const View& view) {
    return std::make_shared<const Pose>(pose_of(Scene(placements), view));
}

/// A frame with all of its lines, between the poses of two others.
Frame frame_of(const char* definition, const std::vector<Placement>& placements, const View& view,
               std::shared_ptr<const Pose> before, std::shared_ptr<const Pose> after) {
    const std::string set = std::string(R"({"schema": 1, "line_sets": [{"name": "lines", "kinds": {")") + definition +
                            R"(": {}}, "least_length": 0, "pen": {"width": 2}}]})";
    Job job{.scene = std::make_shared<Scene>(Scene(placements)),
            .view = view,
            .style = style::read_style(set),
            .options = {.with_line_vector = true},
            .assets = std::make_shared<Assets>("."),
            .backend = std::make_shared<CpuBackend>(),
            .before = std::move(before),
            .after = std::move(after)};
    return Frame(std::move(job));
}

/// Calls check(place in the image, motion) in places along all lines; returns how many there are.
template <typename Check>
int each_place(Frame& frame, const Check& check) {
    frame.filter();
    const LineMotion motion(frame);
    const ClippedPaths& clipped = *frame.clipped;
    int count = 0;
    for (Index q = 0; q < clipped.pieces.count(); ++q)
        for (double arc = clipped.first_arc(q) + 0.5; arc < clipped.last_arc(q); arc += 3.0, ++count)
            check(dvec2(clipped.place_px(q, arc)), dvec4(motion.at(q, arc)));
    return count;
}

dmat4 turned(double angle, dvec3 axis) { return glm::rotate(dmat4(1.0), angle, axis); }

}  // namespace

TEST(LineMotion, IsNothingWhereNothingMoves) {
    const View view = perspective({3, -5, 4}, {0, 0, 0});
    const dmat4 aside = moved({0.2, 0.1, 0}) * turned(0.3, {0, 0, 1});
    const std::pair<const char*, meshes::Mesh> cases[]{{"contour", meshes::sphere(12)}, {"crease", meshes::box()}};
    for (const auto& [definition, mesh] : cases) {
        const std::vector<Placement> still{place(mesh, aside)};
        Frame frame = frame_of(definition, still, view, pose(still, view), pose(still, view));
        EXPECT_GT(each_place(frame, [](dvec2, dvec4 by) { ASSERT_EQ(by, dvec4(0.0)); }), 50) << definition;
    }
}

TEST(LineMotion, OfLinesOfTheMeshIsThatOfTheirPoints) {
    const auto at = [](double time) {
        return moved({0.2 * time, 0.1, 0}) * turned(0.3 + 0.1 * time, glm::normalize(dvec3(1, 2, 3)));
    };
    const auto eye = [](double time) { return perspective({3 + 0.2 * time, -5, 4 - 0.1 * time}, {0, 0, 0}); };
    const auto boxes = [&](double time) { return std::vector<Placement>{place(meshes::box(), at(time))}; };
    Frame frame = frame_of("crease", boxes(0), eye(0), pose(boxes(-1), eye(-1)), pose(boxes(1), eye(1)));
    // Points close together on the edges of the box, as they are seen in the three frames.
    std::vector<std::array<dvec2, 3>> points;
    for (int axis = 0; axis < 3; ++axis)
        for (const double side : {-1.0, 1.0})
            for (const double other : {-1.0, 1.0})
                for (double along = -1.0; along <= 1.0; along += 1.0 / 512.0) {
                    dvec4 p(1.0);
                    p[axis] = along, p[(axis + 1) % 3] = side, p[(axis + 2) % 3] = other;
                    points.push_back({pixel_of(eye(-1), dvec3(at(-1) * p)), pixel_of(eye(0), dvec3(at(0) * p)),
                                      pixel_of(eye(1), dvec3(at(1) * p))});
                }
    double most = 0.0;
    const int count = each_place(frame, [&](dvec2 px, dvec4 by) {
        double nearest = 1e9;
        for (const auto& [before, now, after] : points) {
            const double off = glm::distance(now, px);
            if (off > 0.5) continue;
            nearest = std::min(nearest, glm::distance(by, dvec4(before - now, now - after)) - 0.3 * off);
            most = std::max(most, glm::length(by));
        }
        ASSERT_LT(nearest, 0.05) << px.x << " " << px.y;
    });
    EXPECT_GT(count, 300);
    EXPECT_GT(most, 20.0);
}

TEST(LineMotion, OfAContourIsThatOfTheOutlineAcrossItself) {
    const auto balls = [](dvec3 at) { return std::vector<Placement>{place(meshes::sphere(64), moved(at))}; };
    Frame frame = frame_of("contour", balls({0, 0, 0}), above, pose(balls({-0.05, 0, 0.3}), above),
                           pose(balls({0.02, 0.04, 0.1}), above));
    const int count = each_place(frame, [](dvec2 px, dvec4 by) {
        const dvec2 out = glm::normalize(px - dvec2(200.0));
        const dvec2 before = glm::dot(dvec2(-5, 0), out) * out, after = glm::dot(dvec2(2, 4), out) * out;
        ASSERT_LT(glm::distance(by, dvec4(before, -after)), 0.25);  // the line is that of a polygon, within 3 degrees
    });
    EXPECT_GT(count, 150);
}

TEST(LineMotion, OfTheContourOfASphereThatSpinsIsNothing) {
    const auto ball = [](double angle) {
        return std::vector<Placement>{place(meshes::sphere(64), turned(angle, glm::normalize(dvec3(1, 2, 0.5))))};
    };
    Frame frame = frame_of("contour", ball(0), above, pose(ball(-0.03), above), pose(ball(0.03), above));
    double inward = 0.0;
    each_place(frame, [&](dvec2, dvec4 by) { inward = std::max(inward, glm::length(by)); });
    EXPECT_LT(inward, 0.35);  // points of it move by 3 pixels
}

TEST(LineMotion, FollowsVerticesThatMove) {
    const meshes::Mesh flat = meshes::grid(8, 1.0f);
    const auto bent = [&](double by) {
        meshes::Mesh mesh = flat;
        for (vec3& p : mesh.positions) p.x += float(by * p.y * p.y);
        return std::vector<Placement>{place(mesh)};
    };
    Frame frame = frame_of("border", bent(0), above, pose(bent(-0.1), above), pose(bent(0.2), above));
    const int count = each_place(frame, [&](dvec2 px, dvec4 by) {
        // Within an edge vertices' motion is mixed.
        const double y = (px.y - 200.0) / 100.0;
        EXPECT_NEAR(by.x, -10.0 * y * y, 0.2);
        EXPECT_NEAR(by.z, -20.0 * y * y, 0.4);
        EXPECT_NEAR(by.y, 0.0, 1e-3);
        EXPECT_NEAR(by.w, 0.0, 1e-3);
    });
    EXPECT_GT(count, 100);
}

TEST(LineMotion, TowardsAFrameWithoutTheObjectOrBehindTheEyeIsNothing) {
    const std::vector<Placement> box{place(meshes::box(), moved({0.5, 0, 0}), 7)};
    const std::vector<Placement> other{place(meshes::box(), moved({0, 0, 0}), 8)};
    const std::vector<Placement> behind{place(meshes::box(), moved({0, -20, 10}), 7)};
    const View view = perspective({3, -5, 4}, {0, 0, 0});
    for (const auto& before : {pose(other, view), pose(behind, view), std::shared_ptr<const Pose>()}) {
        Frame frame = frame_of("crease", box, view, before, pose({place(meshes::box(), moved({0.6, 0, 0}), 7)}, view));
        each_place(frame, [](dvec2, dvec4 by) {
            ASSERT_EQ(dvec2(by), dvec2(0.0));
            ASSERT_GT(glm::length(by), 2.0);
        });
    }
}

TEST(LineMotion, OfAnObjectWithOtherVerticesIsThatOfItsPlacement) {
    const std::vector<Placement> box{place(meshes::box(), dmat4(1.0), 7)};
    const std::vector<Placement> ball{place(meshes::sphere(9), moved({0.1, 0, 0}), 7)};
    Frame frame = frame_of("crease", box, above, pose(ball, above), pose(ball, above));
    each_place(frame, [](dvec2, dvec4 by) { ASSERT_LT(glm::distance(by, dvec4(10, 0, -10, 0)), 1e-3); });
}

TEST(LineMotion, InThePassIsThatOfTheNearestLine) {
    // Two sheets, of which the upper one moves to the right and the lower one upwards.
    const auto sheets = [](double time) {
        return std::vector<Placement>{place(meshes::grid(2, 1.0f), moved({0.05 * time, 0, 1}), 1),
                                      place(meshes::grid(2, 1.0f), moved({0.5, 0.5 + 0.03 * time, 0}), 2)};
    };
    Frame frame = frame_of("border", sheets(0), above, pose(sheets(-1), above), pose(sheets(1), above));
    frame.picture();
    const Picture& p = frame.passes;
    EXPECT_TRUE(p.of_lines.depth.empty());  // it is not requested
    int counts[3] = {};
    for (std::size_t i = 0; i < p.lines.size(); ++i) {
        const dvec4 by(p.of_lines.vector[i]);
        if (p.lines[i].a == 0.0f) {
            ASSERT_EQ(by, dvec4(0.0));
            ++counts[0];
        } else if (glm::distance(by, dvec4(-5, 0, -5, 0)) < 1e-3) {
            ++counts[1];
        } else {
            ASSERT_LT(glm::distance(by, dvec4(0, -3, 0, -3)), 1e-3);
            ++counts[2];
        }
    }
    for (const int count : counts) EXPECT_GT(count, 300);
}
