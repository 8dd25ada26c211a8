// SPDX-License-Identifier: GPL-3.0-or-later
// What is seen of intersections: not hidden by the two surfaces they lie on, and not seen through them.
#include <gtest/gtest.h>

#include <fovea/visibility/own_sides.h>
#include <fovea/visibility/sampled.h>

#include "intersections.h"

using namespace fovea;
using namespace fovea::draw;
using namespace fovea::intersections;

namespace {

std::vector<View> views() {
    std::vector<View> all;
    for (const dvec3 eye : {dvec3(5, -7, 4), dvec3(-6, 3, 5), dvec3(1.3, 8, -3), dvec3(0.5, -8, 0.4)}) {
        all.push_back(perspective(eye, dvec3(0), 50, 800, 600));
        all.push_back(orthographic(eye, dvec3(0), 6, 800, 600));
    }
    return all;
}

/// Intersections alone, and what ought to be seen of them: of convex bodies, where both facets face the viewer; a sheet
/// is seen from both sides.
struct Seen {
    Drawing drawing;
    OwnSides sides;
    Array<float> exact, sampled, expected;

    Seen(std::vector<Placement> placements, const View& view, Index sheet = none)
        : drawing(std::move(placements), view, {line_set({"intersection"})}),
          sides(own_sides(drawing.clipped, drawing.scene, view)),
          exact(samples_from_runs(drawing.clipped, drawing.runs)) {
        const DepthOptions options;
        const DepthBuffer buffer =
            draw_depth(depth_layout(view, options), view, depth_meshes(drawing.scene, view, options.margin));
        sampled = sampled_visibility(drawing.clipped, sides, buffer, {});
        expected.assign(exact.size(), -1.0f);
        const ClippedPaths& clipped = drawing.clipped;
        for (Index q = 0; q < clipped.pieces.count(); ++q)
            for (Index i = clipped.pieces.begin(q); i + 1 < clipped.pieces.end(q); ++i)
                for (Index j = 0; j < clipped.sample_count[i]; ++j)
                    expected[clipped.sample_start[i] + j] =
                        faces(clipped.facet0[i], sheet) && faces(clipped.facet1[i], sheet);
    }

    bool faces(Index facet, Index sheet) const {
        const Scene& scene = drawing.scene;
        Index p = static_cast<Index>(scene.placements.size()) - 1;
        while (scene.facet_base[p] > facet) --p;
        if (p == sheet) return true;
        const dvec4 plane(scene.placements[p].surface->facet_plane[facet - scene.facet_base[p]]);
        const View& view = drawing.view;
        const dmat4 to_object = glm::inverse(view.world_to_view * scene.placements[p].object_to_world);
        const dvec4 eye = to_object * (view.orthographic ? dvec4(0, 0, 1, 0) : dvec4(0, 0, 0, 1));
        return glm::dot(dvec3(plane), dvec3(eye)) > plane.w * eye.w;
    }

    /// Shares of samples that are not as expected: lines with gaps, and lines that show through.
    struct Wrong {
        double gaps = 0, through = 0, visible = 0, hidden = 0;
    };
    Wrong wrong(const Array<float>& seen) const {
        Wrong w;
        for (std::size_t s = 0; s < seen.size(); ++s) {
            if (expected[s] < 0.0f) continue;
            (expected[s] > 0.5f ? w.visible : w.hidden) += 1;
            if (expected[s] > 0.5f && seen[s] < 0.5f) w.gaps += 1;
            if (expected[s] < 0.5f && seen[s] >= 0.5f) w.through += 1;
        }
        return w;
    }
};

void expect_right(const std::vector<Placement>& placements, Index sheet, double sampled_share, const char* what) {
    int k = 0;
    double visible = 0, hidden = 0;
    for (const View& view : views()) {
        const Seen seen(placements, view, sheet);
        const auto exact = seen.wrong(seen.exact), sampled = seen.wrong(seen.sampled);
        const double all = exact.visible + exact.hidden;
        visible += exact.visible;
        hidden += exact.hidden;
        EXPECT_GT(all, 200) << what << ", view " << k;
        EXPECT_LE(exact.gaps, 0.002 * all) << what << ", view " << k << " of " << exact.visible;
        EXPECT_LE(exact.through, 0.002 * all) << what << ", view " << k << " of " << exact.hidden;
        EXPECT_LE(sampled.gaps, sampled_share * all) << what << ", sampled, view " << k;
        EXPECT_LE(sampled.through, sampled_share * all) << what << ", sampled, view " << k;
        ++k;
    }
    EXPECT_GT(visible, 600) << what;
    EXPECT_GT(hidden, 300) << what;
}

}  // namespace

TEST(IntersectionSeen, OfBoxesIsWhereBothFaceTheViewer) {
    expect_right({place(box(), dmat4(1.0), 1), place(box(), moved({0.7, -0.5, 0.6}) * turned(0.5, {1, 2, 3}), 2)}, none,
                 0.01, "boxes");
    expect_right({place(box(), dmat4(1.0), 1), place(box(), scaled({0.5, 0.5, 1.5}), 2)}, none, 0.01,
                 "a box through a box");
}

TEST(IntersectionSeen, OfSpheresIsWhereBothFaceTheViewer) {
    expect_right({place(sphere(40), moved({-0.6, 0.3, 0}), 1),
                  place(sphere(40), moved({0.6, 0, 0.2}) * turned(0.5, {1, 2, 3}), 2)},
                 none, 0.03, "spheres");
}

TEST(IntersectionSeen, OfASphereInASheetIsSeenFromBothSides) {
    expect_right({place(grid(1, 2.5f), turned(0.1, {1, 0, 0}), 1), place(sphere(40), moved({0, 0, 0.3}), 2)}, 0, 0.03,
                 "a sphere in one large square");
    expect_right({place(sphere(40), moved({0, 0, 0.3}), 1), place(grid(40, 2.5f), turned(0.1, {1, 0, 0}), 2)}, 1, 0.03,
                 "a sphere in a sheet of many");
}

TEST(IntersectionSeen, WithinOneObjectAsBetweenTwo) {
    const dmat4 other = moved({0.7, -0.5, 0.6}) * turned(0.5, {1, 2, 3});
    const Mesh both = joined({{box(), dmat4(1.0)}, {box(), other}});
    expect_right({place(both)}, none, 0.01, "boxes in one object");
    for (const View& view : views()) {
        const Seen one({place(both)}, view), two({place(box(), dmat4(1.0), 1), place(box(), other, 2)}, view);
        EXPECT_NEAR(one.drawing.visible_px(0), two.drawing.visible_px(0), 0.5);
    }
}

TEST(IntersectionSeen, AThirdObjectHidesThem) {
    const std::vector<Placement> boxes = {place(box(), dmat4(1.0), 1), place(box(), scaled({0.5, 0.5, 1.5}), 2)};
    const View view = perspective({0, -9, 4}, {0, 0, 0});
    std::vector<Placement> behind = boxes;
    behind.push_back(place(box(), moved({0, -4, 2}) * scaled({2, 0.1, 2}), 3));
    EXPECT_GT(Drawing(boxes, view, {line_set({"intersection"})}).visible_px(0), 50.0);
    EXPECT_EQ(Drawing(behind, view, {line_set({"intersection"})}).visible_px(0), 0.0);
}

TEST(IntersectionSeen, ATipThatPokesThroughASurfaceIsASpeckWhereItIsSmall) {
    const Mesh floor = box({-2, -2, -1}, {2, 2, 0});
    for (const double corner : {60.0, 180.0})
        for (const float half : {0.02f, 0.03f}) {  // square posts of 16 and 24 px around
            const Mesh post = box({-half, -half, -0.5f}, {half, half, 0.5f});
            const auto px = [&](const char* definition, double least) {
                const Drawing drawing({place(floor), place(post, dmat4(1.0), 2)},
                                      orthographic({0, 0, 5}, dvec3(0), 6.4), {line_set({definition}, corner)},
                                      {.least_length_px = {least}});
                return drawing.total_px(0) + drawing.total_px(1);
            };
            EXPECT_NEAR(px("intersection", 0.0), 800 * half, 0.5);
            EXPECT_NEAR(px("intersection", 60.0), half < 0.025f ? 0.0 : 800 * half, 0.5) << corner;
            EXPECT_EQ(px("crease", 60.0), px("crease", 0.0)) << "edges of a body that is far away";
        }
}
