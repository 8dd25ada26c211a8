// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/field/limit_curvature.h>

#include <fovea/base/parallel.h>
#include <fovea/field/principal.h>

namespace fovea {

CurvatureD curvature_of(const HeightJetD& jet) {
    CurvatureD c;
    c.normal = jet.normal;
    if (jet.normal == dvec3(0.0)) return c;
    set_principal(c, jet.tangent, glm::cross(jet.normal, jet.tangent), -jet.second[0], -jet.second[1], -jet.second[2]);
    const HeightJetD along = turned(jet, jet.normal, c.e1);
    for (int i = 0; i < 4; ++i) c.C[i] = -along.third[i];
    return c;
}

Array<Curvature> curvature_of(const Array<HeightJet>& jets) {
    Array<Curvature> result(jets.size());
    parallel_for(jets.size(), [&](std::size_t v) {
        const HeightJet& jet = jets[v];
        HeightJetD exact;
        // Rounded to floats they are neither unit nor at right angles any more.
        const dvec3 n(jet.normal), t(jet.tangent);
        if (n != dvec3(0.0)) {
            exact.normal = glm::normalize(n);
            exact.tangent = glm::normalize(t - glm::dot(t, exact.normal) * exact.normal);
        }
        for (int i = 0; i < 3; ++i) exact.second[i] = jet.second[i];
        for (int i = 0; i < 4; ++i) exact.third[i] = jet.third[i];
        result[v] = rounded(curvature_of(exact));
    });
    return result;
}

}  // namespace fovea
