// SPDX-License-Identifier: GPL-3.0-or-later
// Contours of bumps that are too small to be seen as such (runs/dots.h).
#include <fovea/runs/dots.h>

#include "line_filters.h"

using namespace fovea;
using namespace fovea::draw;
using namespace fovea::line_filters;

namespace {

/// A large triangle and one beside it that is not connected to it, seen from above, with lines on either.
struct DotDrawing {
    meshes::Mesh mesh = meshes::of_polygons("parts",
                                            {vec3(at(100, 100)), vec3(at(500, 100)), vec3(at(100, 400)),
                                             vec3(at(600, 100)), vec3(at(602, 100)), vec3(at(600, 102))},
                                            {{0, 1, 2}, {3, 4, 5}});
    Paths paths;

    void line(int triangle, const std::vector<dvec3>& points, bool closed, std::uint8_t of_view) {
        for (std::size_t i = 0; i < points.size(); ++i) {
            paths.points_obj.push_back(vec3(points[i]));
            paths.arc_obj.push_back(double(i));
            paths.place.push_back(Index(6 + triangle));  // six edges
            paths.edge_t.push_back(0.0f);
            paths.kinds.push_back(1);
            paths.strength.push_back(1.0f);
        }
        paths.closed.push_back(closed);
        paths.id.push_back(paths.id.size());
        paths.placement.push_back(0);
        paths.line_set.push_back(0);
        paths.free_ends.push_back(0);
        paths.of_view.push_back(of_view);
        paths.rows.offsets.push_back(Index(paths.points_obj.size()));
    }
    void loop(int triangle, dvec2 from, double size, std::uint8_t of_view = 1) {
        const auto corner = [&](double x, double y) { return at(from.x + x * size, from.y + y * size); };
        line(triangle, {corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1), corner(0, 0)}, true, of_view);
    }

    /// The paths that are left with dots of up to 3 pixels, of the last of which so much is hidden.
    std::vector<Index> left(double hidden_px = 0.0) const {
        const Scene scene({drawing::place(mesh)});
        const ClippedPaths clipped = project::project(paths, scene, camera(), {}, Cancel());
        Runs runs = whole(clipped);
        runs.end_px.back() -= hidden_px;
        std::vector<Index> numbers;
        const Runs kept = without_dots(clipped, runs, paths, scene, 3.0);
        for (const Index piece : kept.piece) numbers.push_back(clipped.path[piece]);
        return numbers;
    }
};

}  // namespace

TEST(BumpDots, ALoopOfAPixelOnALargerFigureIsRemoved) {
    DotDrawing drawing;
    drawing.line(0, {at(110, 110), at(300, 110)}, false, 1);
    drawing.loop(0, {200, 150}, 1.5);
    EXPECT_EQ(drawing.left(), (std::vector<Index>{0}));
    drawing.loop(0, {200, 170}, 5.0);
    EXPECT_EQ(drawing.left(), (std::vector<Index>{0, 2})) << "larger than a dot";
}

TEST(BumpDots, StayWhereTheyAreAllThatIsSeenOfAConnectedPart) {
    DotDrawing drawing;
    drawing.line(0, {at(110, 110), at(300, 110)}, false, 1);
    drawing.loop(1, {600, 100}, 0.7);
    EXPECT_EQ(drawing.left(), (std::vector<Index>{0, 1})) << "a part of its own";
    DotDrawing alone;
    alone.loop(0, {200, 150}, 1.5);
    EXPECT_EQ(alone.left(), (std::vector<Index>{0}));
}

TEST(BumpDots, AreClosedContoursThatAreSeenAsAWhole) {
    const auto with_line = [] {
        DotDrawing drawing;
        drawing.line(0, {at(110, 110), at(300, 110)}, false, 1);
        return drawing;
    };
    DotDrawing marks = with_line();
    marks.loop(0, {200, 150}, 1.5, 0);
    EXPECT_EQ(marks.left().size(), 2u) << "a line of the surface";
    DotDrawing hidden = with_line();
    hidden.loop(0, {200, 150}, 1.5);
    EXPECT_EQ(hidden.left().size(), 1u);
    EXPECT_EQ(hidden.left(1.0).size(), 2u) << "something hides a part of it";
    DotDrawing open = with_line();
    open.line(0, {at(200, 150), at(202.5, 150)}, false, 1);
    EXPECT_EQ(open.left().size(), 2u) << "open";
}
