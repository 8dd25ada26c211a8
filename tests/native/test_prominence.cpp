// SPDX-License-Identifier: GPL-3.0-or-later
// Crests beside which curvature falls: those of rounded edges stay, ripples of tubes go.
#include <gtest/gtest.h>

#include "drawing.h"

using namespace fovea;
using namespace fovea::draw;
using namespace fovea::drawing;
using namespace fovea::meshes;

namespace {

/// A tube around z of length 4, in `n` steps around; radius(angle).
template <typename Radius>
Mesh tube(int n, const Radius& radius) {
    const int rows = 24;
    Mesh mesh("tube", {});
    for (int j = 0; j <= rows; ++j)
        for (int i = 0; i < n; ++i) {
            const double a = 2.0 * std::numbers::pi * i / n;
            mesh.positions.push_back(
                vec3(dvec3(radius(a) * std::cos(a), radius(a) * std::sin(a), 4.0 * j / rows - 2.0)));
        }
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < n; ++i) {
            const int next = (i + 1) % n;
            mesh.add_polygon({j * n + i, j * n + next, (j + 1) * n + next, (j + 1) * n + i});
        }
    return mesh;
}

/// Length of the ridges of a mesh.
double ridges(Mesh mesh, double prominence) {
    mesh.shape = Shape::smooth;
    const Drawing drawing({place(mesh)}, perspective({9, -12, 7}, {0, 0, 0}, 30),
                          {line_set_with("ridge", {0.01, 0.5, 0.0, 0.0, prominence})});
    const Paths& paths = drawing.paths;
    double length = 0.0;
    for (Index p = 0; p < paths.count(); ++p)
        for (Index i = paths.rows.begin(p) + 1; i < paths.rows.end(p); ++i)
            length += glm::distance(dvec3(paths.points_obj[i]), dvec3(paths.points_obj[i - 1]));
    return length;
}

}  // namespace

TEST(Prominence, RipplesOfATubeAreNoRidges) {
    const Mesh rippled = tube(128, [](double a) { return 1.0 + 4e-4 * std::cos(16.0 * a); });
    EXPECT_GT(ridges(rippled, 0.0), 40.0) << "sixteen of length 4, but for their ends";
    EXPECT_EQ(ridges(rippled, 0.3), 0.0);
}

TEST(Prominence, RoundedEdgesAreRidges) {
    // A square with rounded corners.
    const Mesh rounded = tube(256, [](double a) {
        return std::pow(std::pow(std::abs(std::cos(a)), 8.0) + std::pow(std::abs(std::sin(a)), 8.0), -1.0 / 8.0);
    });
    const double all = ridges(rounded, 0.0);
    EXPECT_GT(all, 14.0) << "four of length 4, but for their ends";
    EXPECT_NEAR(ridges(rounded, 0.3), all, 0.1);
}
