// SPDX-License-Identifier: GPL-3.0-or-later
// Lines of the shaded image: where they lie, to fractions of a pixel, and that they are those of the scene alone.
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <fovea/image/gaussian.h>
#include <fovea/image/local_fit.h>
#include <fovea/line/image_curves.h>
#include <fovea/visibility/depth.h>
#include <fovea/visibility/sampled.h>

#include "drawing.h"
#include "wires.h"

using namespace fovea;
using namespace fovea::draw;
using namespace fovea::meshes;
using namespace fovea::drawing;

namespace {

/// A definition with its defaults, but for those given by name.
LineSet with(const char* name, const std::map<std::string, double>& changes) {
    LineSet set = line_set({name});
    const auto& parameters = definition_called(name).parameters;
    for (std::size_t i = 0; i < parameters.size(); ++i)
        if (const auto it = changes.find(parameters[i].name); it != changes.end()) set.kinds[0].values[i] = it->second;
    return set;
}

/// 80 pixels a unit; x of the world to the right.
const View from_above = orthographic({0, 0, 10}, {0, 0, 0}, 8);
const View from_front = orthographic({0, -10, 0}, {0, 0, 0}, 8);

struct Point {
    dvec2 px;
    double strength;
};

/// All points of the drawing, in pixels.
std::vector<Point> points_of(const Drawing& drawing) {
    std::vector<Point> points;
    for (std::size_t i = 0; i < drawing.clipped.px.size(); ++i)
        points.push_back({dvec2(drawing.clipped.px[i]), drawing.paths.strength[drawing.clipped.source[i]]});
    return points;
}

/// x of the points whose y is within so many pixels of the middle of the picture.
std::vector<double> x_of_middle(const Drawing& drawing, double rows = 40) {
    std::vector<double> x;
    for (const Point& p : points_of(drawing))
        if (std::abs(p.px.y - 0.5 * drawing.view.height) < rows) x.push_back(p.px.x);
    return x;
}

/// Where a tone over a line, under the Gaussian of 2 px, has its greatest slope (order 1) or its deepest valley (2)
/// within `range` of `near`. Independent of the lattice: in steps of 1/50 px.
template <typename Tone>
double extremum(const Tone& tone, double near, double range, int order) {
    const auto smooth = [&](double x) {
        double sum = 0.0, weights = 0.0;
        for (double s = -8.0; s <= 8.0; s += 0.02) {
            const double w = std::exp(-s * s / 8.0);
            sum += w * tone(x + s);
            weights += w;
        }
        return sum / weights;
    };
    double best = -1e9, at = near;
    for (double x = near - range; x <= near + range; x += 0.02) {
        const double value = order == 1 ? std::abs(smooth(x + 0.5) - smooth(x - 0.5)) : -smooth(x);
        if (value > best) {
            best = value;
            at = x;
        }
    }
    return at;
}

/// Tone of a sphere or cylinder of radius 80 px, lit from the eye, on a background.
auto round_tone(double background) {
    return [=](double r) { return std::abs(r) < 80.0 ? std::sqrt(1.0 - r * r / 6400.0) : background; };
}

/// Strips along y through a profile of (x, z).
Mesh profile(const std::vector<dvec2>& points) {
    Mesh mesh("profile", {});
    for (const dvec2& p : points)
        for (const float y : {-2.0f, 2.0f}) mesh.positions.push_back({float(p.x), y, float(p.y)});
    for (int i = 0; i + 1 < int(points.size()); ++i) mesh.add_polygon({2 * i, 2 * i + 2, 2 * i + 3, 2 * i + 1});
    return mesh;
}

constexpr double px = 1.0 / 80.0;

}  // namespace

TEST(Gaussian, KeepsConstantsAndAddsVariances) {
    const int n = 81;
    const Buffer flat(n * n, 0.7f);
    for (const float v : gaussian(flat, n, n, 2.0)) EXPECT_NEAR(v, 0.7f, 1e-6);
    Buffer point(n * n, 0.0f);
    point[40 * n + 40] = 1.0f;
    const Buffer spread = gaussian(point, n, n, 2.0);
    double sum = 0, variance = 0;
    for (int y = 0; y < n; ++y)
        for (int x = 0; x < n; ++x) {
            sum += spread[y * n + x];
            variance += spread[y * n + x] * (x - 40.0) * (x - 40.0);
        }
    EXPECT_NEAR(sum, 1.0, 1e-5);
    EXPECT_NEAR(variance, 4.0, 0.05) << "less what is cut off";
}

TEST(Lattice, OfAnAxisFarOutsideOfTheImageHasNodesAllOverIt) {
    for (const double shift : {0.0, 1e3, 1e12, 1e25}) {
        View view = drawing::orthographic({0, 0, 5}, {0, 0, 0}, 2.0, 40, 30);
        view.view_to_clip[3].x = shift;
        const image::Lattice lattice = image::lattice_over(view, 1.0, 3);
        EXPECT_GE(lattice.width, 40 + 6) << shift;
        EXPECT_GE(lattice.height, 30 + 6) << shift;
        EXPECT_LT(lattice.size(), 10000u) << shift;
    }
}

TEST(Lattice, OfAFewPixelsIsSmall) {
    View view = drawing::orthographic({0, 0, 5}, {0, 0, 0}, 2.0, 16, 1);
    view.reference_scale = 1.0 / reference_height;
    EXPECT_LT(image::lattice_over(view, 1.5, 3).size(), 3000u);
}

TEST(LocalFit, IsExactOnQuadratics) {
    const Lattice lattice{{0, 0}, 1.0, 5, 5};
    Buffer values(25);
    for (int y = 0; y < 5; ++y)
        for (int x = 0; x < 5; ++x) {
            const double u = x - 2, v = y - 2;
            values[lattice.at(x, y)] = float(2 + 3 * u - v + 0.5 * 4 * u * u + 1.5 * u * v + 0.5 * 0 * v * v);
        }
    const LocalFit fit = fit_at(values, lattice, 2, 2);
    EXPECT_NEAR(fit.gradient.x, 3, 1e-5);
    EXPECT_NEAR(fit.gradient.y, -1, 1e-5);
    EXPECT_NEAR(fit.xx, 4, 1e-5);
    EXPECT_NEAR(fit.xy, 1.5, 1e-5);
    EXPECT_NEAR(fit.yy, 0, 1e-5);
    // Eigenvalues of (4 1.5; 1.5 0) are 4.5 and -0.5.
    const Bend valley = greatest_bend(fit, 1.0f), ridge = greatest_bend(fit, -1.0f);
    EXPECT_NEAR(valley.curvature, 4.5, 1e-5);
    EXPECT_NEAR(ridge.curvature, 0.5, 1e-5);
    EXPECT_NEAR(glm::dot(valley.direction, ridge.direction), 0, 1e-6);
    EXPECT_NEAR(std::abs(glm::dot(valley.direction, glm::normalize(vec2(3, 1)))), 1, 1e-6);
}

TEST(Hysteresis, KeepsWholeCurvesThatAreStrongSomewhereAndLong) {
    const auto piece = [](Index a, Index b, float x, float strength) {
        return CurvePiece{0, {a, b}, {{x, 0, 0}, {x + 1, 0, 0}}, {strength, strength}};
    };
    // 1-2-3 is strong at its end, 5-6-7 weak, 8-9 strong but short.
    const Curves curves = {piece(1, 2, 0, 0.1f), piece(5, 6, 0, 0.9f), piece(8, 9, 0, 1), piece(6, 7, 1, 0.9f),
                           piece(2, 3, 1, 1)};
    const Curves kept = keep_strong(curves, 1.5);
    ASSERT_EQ(kept.size(), 2u);
    EXPECT_EQ(kept[0].side[0], 1u);
    EXPECT_EQ(kept[1].side[1], 3u);
    EXPECT_EQ(keep_strong(curves, 0.0).size(), 3u);
    EXPECT_TRUE(keep_strong({}, 0.0).empty());
}

TEST(ImageEdge, OfAStepIsStraightAndWhereTheStepIs) {
    // A square lit from the side, gray on a light background.
    for (const double shift : {0.0, 0.13, 0.37, 0.5, 0.71})
        for (const double turn : {0.0, 3.0, 20.0}) {
            const dmat4 at = moved({shift * px, 0, 0}) * glm::rotate(dmat4(1.0), glm::radians(turn), dvec3(0, 0, 1));
            const Drawing drawing({place(grid(4), at)}, from_above, {with("image_edge", {{"light_right", 60}})});
            int sides[2] = {0, 0};
            const dvec2 normal(std::cos(glm::radians(turn)), std::sin(glm::radians(turn)));
            for (const Point& p : points_of(drawing)) {
                const dvec2 from_middle = p.px - dvec2(320 + shift, 240);
                const double across = glm::dot(from_middle, normal);
                const double along = glm::dot(from_middle, dvec2(-normal.y, normal.x));
                if (std::abs(along) > 50) continue;
                EXPECT_NEAR(std::abs(across), 80, 0.05) << "shift " << shift << ", turned " << turn;
                EXPECT_EQ(p.strength, 1.0);
                ++sides[across > 0];
            }
            EXPECT_GT(sides[0], 100);
            EXPECT_GT(sides[1], 100);
        }
}

TEST(ImageEdge, ContrastIsThatOfTheStep) {
    // Two faces of a box, turned to the eye by 0.6 and by a right angle less.
    const auto found = [](double threshold) {
        const Drawing drawing({place(box(), glm::rotate(dmat4(1.0), 0.6, dvec3(0, 0, 1)))}, from_front,
                              {with("image_edge", {{"outline", 0}, {"threshold", threshold}})});
        return drawing.paths.count();
    };
    const double contrast = std::cos(0.6) - std::sin(0.6);
    EXPECT_EQ(found(contrast - 0.01), 1u);
    EXPECT_EQ(found(contrast + 0.01), 0u);
}

TEST(ImageEdge, OfTheOutlineHasFullContrast) {
    const Drawing white({place(grid(4))}, from_above, {with("image_edge", {{"threshold", 0.95}})});
    ASSERT_EQ(white.paths.count(), 1u) << "a square that faces the lamp";
    EXPECT_TRUE(white.paths.closed[0]);
}

TEST(ImageEdge, OfASphereIsACircle) {
    const double radius = extremum(round_tone(2), 80, 4, 1);
    const Drawing drawing({place(sphere(96))}, from_front, {line_set({"image_edge"})});
    ASSERT_EQ(drawing.paths.count(), 1u);
    EXPECT_TRUE(drawing.paths.closed[0]);
    for (const Point& p : points_of(drawing)) EXPECT_NEAR(glm::distance(p.px, dvec2(320, 240)), radius, 0.15);
    EXPECT_NEAR(radius, 80, 1.0) << "the outline itself";
}

TEST(ImageEdge, OfASphereInPerspectiveIsACircle) {
    const View view = perspective({0, -5, 0}, {0, 0, 0});
    const double pixels = 640 * 50.0 / 36.0 / std::sqrt(24.0);  // tan of the angle from its center to its contour
    const Drawing drawing({place(sphere(96))}, view, {line_set({"image_edge"})});
    ASSERT_EQ(drawing.paths.count(), 1u);
    double low = 1e9, high = 0;
    for (const Point& p : points_of(drawing)) {
        low = std::min(low, glm::distance(p.px, dvec2(320, 240)));
        high = std::max(high, glm::distance(p.px, dvec2(320, 240)));
    }
    EXPECT_LT(high - low, 0.2);
    EXPECT_NEAR(high, pixels, 1.0);
    // Points lie on the sphere as it is seen: on its near side.
    for (const dvec3 point : drawing.paths.points_obj) {
        EXPECT_GT(point.z, -5.0 - 0.01);
        EXPECT_LT(point.z, -4.0);
    }
}

TEST(ImageEdge, OfTheOutlineIsASwitch) {
    const LineSet without = with("image_edge", {{"outline", 0}, {"threshold", 0.2}});
    EXPECT_EQ(Drawing({place(sphere(96))}, from_front, {without}).paths.count(), 0u);
    // What is not the outline stays: two faces of a box.
    const Drawing box_drawing({place(box(), glm::rotate(dmat4(1.0), 0.6, dvec3(0, 0, 1)))}, from_front, {without});
    const double corner = 320 + 80 * std::sqrt(2.0) * std::sin(0.6 - std::numbers::pi / 4);
    const auto x = x_of_middle(box_drawing);
    ASSERT_GT(x.size(), 50u);
    for (const double found : x) EXPECT_NEAR(found, corner, 0.1);
}

TEST(AbstractedShading, FollowsAGrooveAndARidge) {
    for (const double shift : {0.0, 0.3, 0.5, 0.85}) {
        const double s = shift * px, w = 2 * px;
        const Mesh groove = profile({{-2, 0}, {s - w, 0}, {s, -w}, {s + w, 0}, {2, 0}});
        const Mesh ridge = profile({{-2, -2 + w}, {s - w, s}, {s + w, s}, {2, -2 + w + 2 * s}});
        const Drawing dark({place(groove)}, from_above, {line_set({"abstracted_shading"})});
        const Drawing light({place(ridge)}, from_above,
                            {with("abstracted_shading", {{"valleys", 0}, {"ridges", 1}, {"outline", 0}})});
        for (const Drawing* drawing : {&dark, &light}) {
            const auto x = x_of_middle(*drawing);
            ASSERT_GT(x.size(), 50u) << shift;
            for (const double found : x) EXPECT_NEAR(found, 320 + shift, 0.05);
        }
        const Drawing neither({place(groove)}, from_above, {with("abstracted_shading", {{"valleys", 0}})});
        EXPECT_EQ(neither.paths.count(), 0u);
    }
}

TEST(AbstractedShading, OfACylinderIsItsDarkRims) {
    const double valley = extremum(round_tone(1), 79, 4, 2);
    const Placement pillar = place(cylinder(256), scaled({1, 1, 9}));  // its ends are outside the picture
    const Drawing drawing({pillar}, from_front, {with("abstracted_shading", {{"sigma", 2}})});
    const auto x = x_of_middle(drawing);
    ASSERT_GT(x.size(), 100u);
    for (const double found : x) EXPECT_NEAR(std::abs(found - 320), valley, 0.15);
    EXPECT_LT(valley, 80) << "inside the outline";
    const Drawing without({pillar}, from_front, {with("abstracted_shading", {{"outline", 0}})});
    EXPECT_EQ(without.paths.count(), 0u);
}

TEST(ImageLines, FadeWhereTheyEnd) {
    // A crease that flattens out along x.
    Mesh mesh("fan", {{-1, -1, 0}, {-1, 0, 0.8f}, {-1, 1, 0}, {1.5f, -1, 0}, {1.5f, 0, 0}, {1.5f, 1, 0}});
    mesh.add_polygon({0, 3, 4, 1});
    mesh.add_polygon({1, 4, 5, 2});
    const Drawing drawing({place(mesh)}, from_above,
                          {with("image_edge", {{"outline", 0}, {"light_up", 45}, {"threshold", 0.3}})});
    ASSERT_GE(drawing.paths.count(), 1u);
    float least = 1, most = 0;
    for (const float s : drawing.paths.strength) {
        EXPECT_TRUE(s >= 0.0f && s <= 1.0f);
        least = std::min(least, s);
        most = std::max(most, s);
    }
    EXPECT_EQ(most, 1.0f);
    EXPECT_LT(least, 0.05f);
}

TEST(ImageLines, AreTheSameAtEverySizeOfThePicture) {
    for (const char* name : {"image_edge", "abstracted_shading"}) {
        View full = perspective({3, -5, 2}, {0, 0, 0}), half = full;
        half.width /= 2;
        half.height /= 2;
        half.reference_scale = 0.5;
        const std::vector<Placement> scene = {place(box()), place(sphere(48), moved({1, -1.5, 0.3}), 2)};
        const Drawing large(scene, full, {line_set({name})}), small(scene, half, {line_set({name})});
        ASSERT_GT(large.paths.count(), 0u);
        ASSERT_EQ(large.paths.count(), small.paths.count()) << name;
        ASSERT_EQ(large.paths.points_obj.size(), small.paths.points_obj.size());
        for (std::size_t i = 0; i < large.paths.points_obj.size(); ++i)
            EXPECT_LT(glm::distance(large.paths.points_obj[i], small.paths.points_obj[i]), 1e-4f);
    }
}

TEST(ImageLines, InABorderAreThoseOfTheFullFrame) {
    const View full = perspective({4, -7, 3}, {0, 0, 0});
    const int x0 = 171, y0 = 20, x1 = 320, y1 = 333;
    const View crop = wires::cropped(full, x0, y0, x1, y1);
    const std::vector<Placement> scene = {place(box()), place(sphere(48), moved({1, -1.5, 0.3}), 2)};
    for (const char* name : {"image_edge", "abstracted_shading"}) {
        const Drawing whole(scene, full, {line_set({name})}), part(scene, crop, {line_set({name})});
        const auto expected = points_of(whole);
        int compared = 0;
        for (const Point& p : points_of(part)) {
            if (p.px.x < 1 || p.px.y < 1 || p.px.x > crop.width - 1 || p.px.y > crop.height - 1) continue;
            double nearest = 1e9;
            for (const Point& q : expected) nearest = std::min(nearest, glm::distance(q.px, p.px + dvec2(x0, y0)));
            EXPECT_LT(nearest, 1e-3) << name;
            ++compared;
        }
        EXPECT_GT(compared, 200);
        // They go on beyond the border.
        bool outside = false;
        for (const Point& p : points_of(part)) outside = outside || p.px.x < -5 || p.px.x > crop.width + 5;
        EXPECT_TRUE(outside);
    }
}

TEST(ImageLines, AreHiddenByNothing) {
    for (const bool ortho : {false, true}) {
        const View view = ortho ? orthographic({3, -5, 2}, {0, 0, 0}, 6) : perspective({3, -5, 2}, {0, 0, 0});
        const std::vector<LineSet> sets = {line_set({"image_edge", "abstracted_shading", "crease"})};
        const Drawing drawing({place(box()), place(sphere(48), moved({1, -1.5, 0.3}), 2)}, view, sets);
        const Array<float> exact = samples_from_runs(drawing.clipped, drawing.runs);
        const DepthOptions depth;
        const DepthBuffer buffer =
            draw_depth(depth_layout(view, depth), view, depth_meshes(drawing.scene, view, depth.margin));
        const OwnSides sides = own_sides(drawing.clipped, drawing.scene, view);
        const Array<float> sampled = sampled_visibility(drawing.clipped, sides, buffer, {});
        const ClippedPaths& clipped = drawing.clipped;
        int in_image = 0, hidden = 0;
        for (Index q = 0; q < clipped.pieces.count(); ++q)
            for (Index i = clipped.pieces.begin(q); i < clipped.pieces.end(q); ++i)
                for (Index s = clipped.sample_start[i]; s < clipped.sample_start[i] + clipped.sample_count[i]; ++s) {
                    if (drawing.paths.placement[clipped.path[q]] != none) {
                        hidden += exact[s] < 0.5f;
                        continue;
                    }
                    EXPECT_GT(exact[s], 0.9999f);
                    EXPECT_EQ(sampled[s], 1.0f);
                    ++in_image;
                }
        EXPECT_GT(in_image, 500);
        EXPECT_GT(hidden, 10) << "other lines are hidden as ever";
    }
}

TEST(ImageLines, AreNotOfWhatIsNotDrawn) {
    const LineSet set = line_set({"image_edge", "abstracted_shading"});
    EXPECT_EQ(Drawing({}, from_front, {set}).paths.count(), 0u);
    EXPECT_EQ(Drawing({place(box(), moved({0, -50, 0}))}, from_front, {set}).paths.count(), 0u) << "behind the camera";
    EXPECT_EQ(Drawing({place(box(), dmat4(1.0), 1, usage_occlude)}, from_front, {set}).paths.count(), 0u);
    // A plate that is not drawn covers the right half of a sphere: no line where it begins.
    const Placement plate = place(box(vec3(0, -3, -3), vec3(3, -2.9f, 3)), dmat4(1.0), 2, usage_occlude);
    const Drawing covered({place(sphere(96)), plate}, from_front, {line_set({"image_edge"})});
    ASSERT_GT(covered.paths.count(), 0u);
    for (const Point& p : points_of(covered)) {
        EXPECT_LT(p.px.x, 322);
        EXPECT_NEAR(glm::distance(p.px, dvec2(320, 240)), 80, 2);
    }
}

TEST(ImageLines, DoNotDependOnTheNumberOfThreads) {
    const std::vector<Placement> scene = {place(box()), place(sphere(48), moved({1, -1.5, 0.3}), 2)};
    const std::vector<LineSet> sets = {line_set({"image_edge", "abstracted_shading"})};
    const View view = perspective({3, -5, 2}, {0, 0, 0});
    const Drawing many(scene, view, sets);
    tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    const Drawing single(scene, view, sets);
    ASSERT_EQ(many.paths.points_obj.size(), single.paths.points_obj.size());
    EXPECT_TRUE(
        std::equal(many.paths.points_obj.begin(), many.paths.points_obj.end(), single.paths.points_obj.begin()));
    EXPECT_TRUE(std::equal(many.paths.strength.begin(), many.paths.strength.end(), single.paths.strength.begin()));
    EXPECT_TRUE(std::equal(many.paths.id.begin(), many.paths.id.end(), single.paths.id.begin()));
}

TEST(ImageLines, BelongToTheFirstSetThatAsksForThem) {
    const Drawing drawing({place(box())}, perspective({3, -5, 2}, {0, 0, 0}),
                          {line_set({"contour"}), line_set({"image_edge"}), line_set({"image_edge"})});
    int of_set[3] = {0, 0, 0};
    for (Index p = 0; p < drawing.paths.count(); ++p) ++of_set[drawing.paths.line_set[p]];
    EXPECT_GT(of_set[0], 0);
    EXPECT_GT(of_set[1], 0);
    EXPECT_EQ(of_set[2], 0);
    std::set<std::uint64_t> ids(drawing.paths.id.begin(), drawing.paths.id.end());
    EXPECT_EQ(ids.size(), drawing.paths.id.size());
}
