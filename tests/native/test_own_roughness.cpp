// SPDX-License-Identifier: GPL-3.0-or-later
// Gaps of smooth contours that only their own mesh makes (runs/own_roughness.h).
#include <gtest/gtest.h>

#include <fovea/runs/own_roughness.h>

#include "drawing.h"
#include "intersections.h"

using namespace fovea;
using namespace fovea::draw;
using namespace fovea::drawing;

namespace {

const View view = perspective({0, -5, 0}, dvec3(0));

/// The contour of a ball, with a gap of so many pixels in the middle of its longest run, and what is left of that.
std::size_t runs_with_gap(double gap_px, const std::vector<Placement>& others = {}) {
    std::vector<Placement> all{place(meshes::sphere(32))};
    all.insert(all.end(), others.begin(), others.end());
    const Drawing drawing(all, view, {line_set({"smooth_contour"})});
    EXPECT_EQ(drawing.paths.count(), 1u);
    Runs runs;
    const double middle = 0.5 * (drawing.clipped.first_arc(0) + drawing.clipped.last_arc(0));
    runs.push(0, drawing.clipped.first_arc(0), middle - 0.5 * gap_px);
    runs.push(0, middle + 0.5 * gap_px, drawing.clipped.last_arc(0));
    return without_own_roughness(drawing.clipped, drawing.paths, drawing.tracer, runs, 30.0).size();
}

/// Whether gaps of ten pixels in the middle of all lines of a kind are closed; all, or none must be.
bool closes_gaps(const meshes::Mesh& mesh, const char* definition) {
    const Drawing drawing({place(mesh)}, perspective({1, -4, 3}, dvec3(0)), {line_set({definition})});
    const ClippedPaths& clipped = drawing.clipped;
    Runs runs;
    for (Index q = 0; q < clipped.path.size(); ++q) {
        const double first = clipped.first_arc(q), last = clipped.last_arc(q), middle = 0.5 * (first + last);
        if (last - first < 20.0) continue;
        runs.push(q, first, middle - 5.0);
        runs.push(q, middle + 5.0, last);
    }
    const std::size_t left = without_own_roughness(clipped, drawing.paths, drawing.tracer, runs, 30.0).size();
    EXPECT_GT(runs.size(), 0u);
    EXPECT_TRUE(left == runs.size() || 2 * left == runs.size());
    return left < runs.size();
}

/// A plate so far before the ball that covers the picture.
std::vector<Placement> plate(double before) {
    return {place(meshes::box(), moved({0, -before, 0}) * scaled(dvec3(3, 0.01, 3)), 2, usage_occlude)};
}

}  // namespace

TEST(OwnRoughness, MakesNoGap) {
    EXPECT_EQ(runs_with_gap(20.0), 1u);
    EXPECT_EQ(runs_with_gap(40.0), 2u) << "too long";
}

TEST(OwnRoughness, HidesLinesOfTheViewOnSmoothSurfacesAlone) {
    const meshes::Mesh torus = intersections::torus(1.0, 0.4, 64, 32);
    EXPECT_TRUE(closes_gaps(torus, "suggestive_contour"));
    EXPECT_FALSE(closes_gaps(torus, "contour")) << "along mesh edges";
    EXPECT_FALSE(closes_gaps(meshes::box(), "crease")) << "a line of the surface";
}

TEST(OwnRoughness, IsNotWhatAnotherObjectHides) {
    EXPECT_EQ(runs_with_gap(20.0, plate(2.0)), 2u);
    EXPECT_EQ(runs_with_gap(20.0, plate(-2.0)), 1u) << "it is behind";
}
