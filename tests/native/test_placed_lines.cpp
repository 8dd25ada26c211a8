// SPDX-License-Identifier: GPL-3.0-or-later
// Lines of surfaces under uneven scales, shears and mirrorings: those of the same surface with the transform baked in.
#include <glm/gtc/quaternion.hpp>
#include <gtest/gtest.h>

#include <fovea/field/fields.h>
#include <fovea/mesh/stretch.h>

#include "analytic.h"
#include "drawing.h"
#include "rules.h"

using namespace fovea;
using namespace fovea::draw;
using namespace fovea::analytic;
using namespace fovea::drawing;

namespace {

dmat4 turned(double angle, dvec3 axis) { return glm::mat4_cast(glm::angleAxis(angle, glm::normalize(axis))); }

dmat4 sheared(double by) {
    dmat4 shear(1.0);
    shear[2][0] = by;
    return shear;
}

struct Case {
    const char* name;
    dmat4 placed;
    /// Whether the stretch before the motion is all there is to it, and the bounding box stays aligned.
    bool aligned;
};

const Case cases[] = {
    {"squashed", moved({.2, .1, 0}) * scaled({1, 1, .5}), true},
    {"stretched", scaled({1.4, .8, 1.2}), true},
    {"sheared", sheared(.7), false},
    {"mirrored", moved({.1, 0, 0}) * scaled({-1, 1, 1}), true},
    {"turned, squashed, mirrored", turned(.8, {1, 2, 3}) * scaled({1, -.6, 1.1}) * turned(.5, {1, 0, 1}), false},
};

/// The vertices where the placement has them; outside stays outside.
Mesh baked(const Mesh& mesh, const dmat4& placed) {
    Mesh result = glm::determinant(dmat3(placed)) < 0.0 ? meshes::flipped(mesh, [](int) { return true; }) : mesh;
    for (vec3& p : result.positions) p = vec3(placed * dvec4(dvec3(p), 1.0));
    result.material = mesh.material;
    result.edge_mark = mesh.edge_mark;
    return result;
}

/// Segments of all paths, in the world.
struct Lines {
    std::vector<std::array<dvec3, 2>> segments;
    double length = 0.0;

    Lines(const std::shared_ptr<const Surface>& surface, const dmat4& placed, const View& view, const LineSet& set) {
        const Scene scene({{surface, placed}});
        const Tracer tracer(scene, view);
        const Paths paths = extract_paths(scene, view, {set}, tracer, Cancel());
        for (Index p = 0; p < paths.count(); ++p)
            for (Index i = paths.rows.begin(p); i + 1 < paths.rows.end(p); ++i) {
                const dmat4 here = paths.placement[p] == none ? glm::inverse(view.world_to_view) : placed;
                const auto at = [&](Index k) { return dvec3(here * dvec4(dvec3(paths.points_obj[k]), 1.0)); };
                segments.push_back({at(i), at(i + 1)});
                length += glm::distance(at(i), at(i + 1));
            }
    }

    double distance(const dvec3& p) const {
        double least = 1e30;
        for (const auto& [a, b] : segments) {
            const dvec3 along = b - a;
            const double squared = glm::dot(along, along);
            const double t = squared > 0.0 ? std::clamp(glm::dot(p - a, along) / squared, 0.0, 1.0) : 0.0;
            least = std::min(least, glm::distance(p, a + t * along));
        }
        return least;
    }

    /// Distance from `other` that all but a twentieth of these lines keep to.
    double distance_from(const Lines& other) const {
        std::vector<double> found;
        const std::size_t step = std::max<std::size_t>(1, segments.size() / 400);
        for (std::size_t i = 0; i < segments.size(); i += step)
            found.push_back(other.distance(0.5 * (segments[i][0] + segments[i][1])));
        if (found.empty()) return 0.0;
        std::sort(found.begin(), found.end());
        return found[std::size_t(0.95 * double(found.size() - 1))];
    }
};

Mesh marked_torus() {
    Mesh mesh = torus({.n = 192}).mesh;
    for (std::size_t f = 0; f + 1 < mesh.polygon_offsets.size(); ++f) mesh.material.push_back(f % 384 < 60);
    mesh.edge_mark.assign(mesh.edge_verts.size(), 0);
    for (std::size_t e = 0; e < 200; ++e) mesh.edge_mark[e] = 1;
    return mesh;
}

/// With the smallest error on a mesh this regular: what is asked here is not how good an estimator is.
std::shared_ptr<const Surface> surface_of(const Mesh& mesh) {
    const auto surface = mesh.surface();
    surface->set_field_options({.estimator = Estimator::jets, .degree = 4, .rings = 2});
    return surface;
}

/// The torus, and for each case what it is with the transform baked in; made once, as they keep their fields.
struct Shaped {
    std::shared_ptr<const Surface> torus;
    std::vector<std::shared_ptr<const Surface>> flat;

    Shaped() {
        const Mesh mesh = marked_torus();
        torus = surface_of(mesh);
        for (const Case& c : cases) flat.push_back(surface_of(baked(mesh, c.placed)));
    }
};

}  // namespace

class PlacedLines : public testing::TestWithParam<const LineDefinition*> {};

TEST_P(PlacedLines, AreThoseOfTheBakedSurface) {
    static const Shaped surfaces;
    constexpr double edge = 0.05;
    LineSet set = line_set({GetParam()->name});
    set.kinds[0].values = quick_values(*GetParam());
    if (std::string(GetParam()->name) == "crease") set.kinds[0].values[0] = 5.0;
    // Without hysteresis, whose yes or no to a whole line may hang on the last digit.
    for (std::size_t i = 0; has_rule<CurveRule>(*GetParam()) && i < GetParam()->parameters.size(); ++i) {
        const std::string parameter = GetParam()->parameters[i].name;
        if (parameter == "low") set.kinds[0].values[i] = 1.0;
        if (parameter == "length") set.kinds[0].values[i] = 0.0;
    }
    // Shading bends so little on the inside that Laplacian lines hang on the last digits of the fields.
    const double near = (std::string(GetParam()->name) == "laplacian_line" ? 0.4 : 0.2) * edge;
    const bool by_box = std::string(GetParam()->name) == "topographic";  // whose range is the bounding box's
    const View views[] = {perspective({3, -4, 3}, {0, 0, 0}), orthographic({3, -4, 3}, {0, 0, 0}, 5)};
    for (std::size_t i = 0; i < std::size(cases); ++i)
        for (const View& view : views) {
            const Case& c = cases[i];
            if (by_box && !c.aligned) continue;
            const Lines placed(surfaces.torus, c.placed, view, set), flat(surfaces.flat[i], dmat4(1.0), view, set);
            EXPECT_NEAR(placed.length, flat.length, 0.03 * flat.length + edge) << c.name;
            EXPECT_LT(placed.distance_from(flat), near) << c.name;
            EXPECT_LT(flat.distance_from(placed), near) << c.name;
        }
}

INSTANTIATE_TEST_SUITE_P(Registry, PlacedLines, testing::ValuesIn(line_definitions()),
                         [](const auto& info) { return std::string(info.param->name); });

TEST(Stretch, IsWhatAnglesFeel) {
    const dmat3 turn(turned(.7, {1, 2, -1})), even(3.0), mirror(scaled({1, -1, 1}));
    const dmat3 single(glm::mat3_cast(glm::angleAxis(.3f, glm::normalize(vec3(1, 1, 2)))));  // as Blender has it
    const dmat3 flat(scaled({1, 1, 0}));
    for (const dmat3& keeps : {dmat3(1.0), turn, even, mirror, turn * even * mirror, single, dmat3(0.0), flat})
        EXPECT_EQ(stretch_of(keeps), dmat3(1.0));
    const dmat3 squash(scaled({1, 1, .5})), found = stretch_of(turn * even * squash);
    EXPECT_EQ(found, stretch_of(squash)) << "the same while an object turns and grows";
    EXPECT_EQ(found, stretch_of(mirror * squash)) << "and is mirrored";
    EXPECT_NEAR(found[2][2] / found[0][0], 0.5, 1e-5);
    const dmat3 shear(sheared(.7)), of_shear = stretch_of(shear);
    const dmat3 metric = glm::transpose(shear) * shear, of_metric = glm::transpose(of_shear) * of_shear;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            EXPECT_NEAR(metric[i][j] / metric[0][0], of_metric[i][j] / of_metric[0][0], 2e-5) << "lengths and angles";
}

TEST(Stretch, SurfacesAreSharedWhereAnglesStay) {
    const std::shared_ptr<const Surface> surface = torus({.n = 16}).mesh.surface();
    EXPECT_EQ(as_placed(surface, moved({1, 2, 3}) * scaled({-2, 2, 2})), surface);
    const auto squashed = as_placed(surface, scaled({1, 1, .5}));
    EXPECT_NE(squashed, surface);
    EXPECT_EQ(as_placed(surface, turned(1, {0, 1, 0}) * scaled({2, 2, 1})), squashed) << "kept";
    EXPECT_EQ(squashed->triangles.size(), surface->triangles.size());
    for (Index f = 0; f < squashed->facet_count(); ++f) {
        const Triangle& t = squashed->triangles[f];
        const vec3 p = squashed->positions[t.x], q = squashed->positions[t.y], r = squashed->positions[t.z];
        const vec3 n = glm::normalize(glm::cross(q - p, r - p));
        EXPECT_LT(glm::distance(n, vec3(squashed->facet_plane[squashed->triangle_facet[f]])), 1e-4f);
    }
}

TEST(Stretch, MapsCurvatureExactly) {
    // A sphere becomes an ellipsoid.
    const dvec3 axes(1.5, 1.1, .7);
    for (const dvec3 p : {dvec3(.6, .48, .64), dvec3(-.36, .48, .8), dvec3(.28, -.96, 0)}) {
        const CurvatureD sphere = curvature_of(ellipsoid_jet(p, dvec3(1)));
        const CurvatureD found = mapped(rounded(sphere), glm::inverse(dmat3(scaled(axes))));
        const CurvatureD exact = curvature_of(ellipsoid_jet(p * axes, axes));
        EXPECT_NEAR(found.k1, exact.k1, 1e-6);
        EXPECT_NEAR(found.k2, exact.k2, 1e-6);
        EXPECT_LT(glm::distance(found.normal, exact.normal), 1e-6);
        const double same = glm::dot(found.e1, exact.e1);
        EXPECT_NEAR(std::abs(same), 1.0, 1e-6);
        for (int i = 0; i < 4; ++i) EXPECT_NEAR(found.C[i] * same, exact.C[i], 1e-5);
    }
    // A torus, sheared: F of the image is F of what it came from.
    const dmat3 shear(sheared(.7)), back = glm::inverse(shear);
    const dvec3 p(1.2, .3, std::sqrt(.16 - std::pow(std::hypot(1.2, .3) - 1, 2)));
    const ImplicitJet torus = torus_jet(p, 1.0);
    ImplicitJet image{glm::transpose(back) * torus.gradient, glm::transpose(back) * torus.hessian * back};
    for (int i = 0; i < 3; ++i)
        for (int a = 0; a < 3; ++a) image.third[i] += back[i][a] * (glm::transpose(back) * torus.third[a] * back);
    const CurvatureD exact = curvature_of(image), found = mapped(rounded(curvature_of(torus)), back);
    const double same = glm::dot(found.e1, exact.e1);
    EXPECT_NEAR(found.k1, exact.k1, 1e-5);
    EXPECT_NEAR(found.k2, exact.k2, 1e-5);
    for (int i = 0; i < 4; ++i) EXPECT_NEAR(found.C[i] * same, exact.C[i], 2e-5);
}

TEST(Stretch, FeatureSizesAreThoseOfTheBakedSurface) {
    const Mesh mesh = torus({.n = 96}).mesh;
    const std::shared_ptr<const Surface> surface = mesh.surface();
    for (const Case& c : cases) {
        const float flat = fields_of(*baked(mesh, c.placed).surface())->feature_size;
        const auto placed = as_placed(surface, c.placed);
        // Without its size, a placement keeps the ratio to any length: here, to the square root of the area.
        const auto area = [](const Surface& s) {
            double sum = 0.0;
            for (const Triangle& t : s.triangles) {
                const dvec3 p(s.positions[t.x]);
                sum += glm::length(glm::cross(dvec3(s.positions[t.y]) - p, dvec3(s.positions[t.z]) - p));
            }
            return sum;
        };
        const double scale = std::sqrt(area(*baked(mesh, c.placed).surface()) / area(*placed));
        EXPECT_NEAR(fields_of(*placed)->feature_size * scale, flat, 0.01 * flat) << c.name;
    }
}

TEST(Stretch, OtherOptionsOtherLines) {
    const auto surface = torus({.n = 32}).mesh.surface();
    const auto size = [&](const FieldOptions& options) {
        surface->set_field_options(options);
        return fields_of(*surface)->reason + " " + fields_of(*as_placed(surface, scaled({1, 1, .5})))->reason;
    };
    EXPECT_EQ(fields_reason(*surface), "") << "nobody asked";
    EXPECT_EQ(size({.estimator = Estimator::one_ring}), "fast (one-rings) as asked for fast (one-rings) as asked for");
    EXPECT_NE(size({.degree = 3, .rings = 5}).find("degree 3, radius 5"), std::string::npos);
    EXPECT_EQ(fields_reason(*surface), fields_of(*surface)->reason);
    EXPECT_THROW(surface->set_field_options({.degree = 7}), std::invalid_argument);
    EXPECT_THROW(surface->set_field_options({.rings = -1}), std::invalid_argument);
    EXPECT_THROW(surface->set_field_options({.smoothing = 9}), std::invalid_argument);
}
