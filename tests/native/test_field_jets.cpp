// SPDX-License-Identifier: GPL-3.0-or-later
// Curvature by jets against surfaces whose curvature is known.
#include <gtest/gtest.h>

#include <fovea/field/fields.h>

#include "field_errors.h"

using namespace fovea;
using namespace fovea::draw;
using namespace fovea::analytic;

namespace {

Errors jet_errors(const Sample& sample, int degree, int rings) {
    const auto surface = sample.mesh.surface();
    return errors_of(sample,
                     fields_of(*surface, {.estimator = Estimator::jets, .degree = degree, .rings = rings})->curvature);
}

}  // namespace

// Limits: medians and 99th percentiles measured in lines.md 2.4, rounded up a little.
TEST(FieldJets, TorusRegular) {
    expect_below(jet_errors(torus({.n = 64}), 4, 3), .009, .024, .21, .36);
    expect_below(jet_errors(torus({.n = 128}), 4, 3), .0006, .002, .045, .088);
    expect_below(jet_errors(torus({.n = 128}), 3, 2), .010, .013, .0105, .028);
}

TEST(FieldJets, TorusIrregular) {
    expect_below(jet_errors(torus({.n = 64, .irregular = true}), 4, 3), .011, .029, .095, .32);
    expect_below(jet_errors(torus({.n = 128, .irregular = true}), 4, 3), .0007, .003, .019, .065);
    expect_below(jet_errors(torus({.n = 128, .irregular = true}), 3, 2), .010, .013, .11, .25);
}

// Limits: as measured, rounded up a little (lines.md has other subdivisions of an ellipsoid).
TEST(FieldJets, Ellipsoid) {
    expect_below(jet_errors(ellipsoid(6, false), 4, 3), .00006, .0003, .0035, .015);
    expect_below(jet_errors(ellipsoid(6, false), 3, 2), .0007, .002, .0035, .020);
    expect_below(jet_errors(ellipsoid(6, true), 4, 3), .00005, .0003, .0035, .015);
    expect_below(jet_errors(ellipsoid(6, true), 3, 2), .0007, .002, .011, .06);
}

TEST(FieldJets, ErrorsFallWithTheEdge) {
    for (const bool irregular : {false, true}) {
        const Errors coarse = jet_errors(ellipsoid(4, irregular), 4, 3);
        const Errors fine = jet_errors(ellipsoid(5, irregular), 4, 3);
        EXPECT_LT(fine.k_median, coarse.k_median / 8) << "with its fourth power";
        EXPECT_LT(fine.c_median, coarse.c_median / 3) << "with its square";
    }
}
