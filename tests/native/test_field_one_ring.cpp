// SPDX-License-Identifier: GPL-3.0-or-later
// Curvature from one-rings, on the regular meshes it is good at.
#include <gtest/gtest.h>

#include <fovea/field/fields.h>

#include "field_errors.h"

using namespace fovea;
using namespace fovea::draw;
using namespace fovea::analytic;

namespace {

Array<Curvature> one_rings(const Surface& surface) {
    return fields_of(surface, {.estimator = Estimator::one_ring})->curvature;
}

}  // namespace

// Limits: medians and 99th percentiles as first measured, rounded up a little; both fall with the square of the edge.
// Errors of k are the greater of both curvatures'; over k1 and k2 alike their medians are .0017 and .0004.
TEST(FieldOneRing, TorusRegular) {
    for (const auto& [n, k, k99, c, c99] :
         {std::array{64., .0035, .011, .017, .037}, {128., .0009, .003, .0045, .009}}) {
        const Sample sample = torus({.n = int(n)});
        expect_below(errors_of(sample, one_rings(*sample.mesh.surface())), k, k99, c, c99);
    }
}

TEST(FieldOneRing, Ellipsoid) {
    const auto errors = [](const Sample& sample) { return errors_of(sample, one_rings(*sample.mesh.surface())); };
    expect_below(errors(ellipsoid(6, false)), .0006, .015, .014, .9);
    expect_below(errors(ellipsoid(6, true)), .012, .085, .45, 3.8);
}

TEST(FieldOneRing, TorusIrregularKeepsTheCurvatureButNotItsDerivative) {
    const Sample sample = torus({.n = 128, .irregular = true});
    expect_below(errors_of(sample, one_rings(*sample.mesh.surface())), .026, .12, .55, 2.2);
}
