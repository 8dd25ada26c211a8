// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/field/exact_curvature.h>

#include <fovea/base/parallel.h>
#include <fovea/field/frames.h>

namespace fovea::field {

CurvatureD curvature_of(const ImplicitJet& jet) {
    CurvatureD c{};
    const double length = glm::length(jet.gradient);
    if (!(length > 0.0)) return c;
    const dvec3 n = c.normal = jet.gradient / length;
    const dmat3 hessian = jet.hessian / length;
    const auto h = [&](const dvec3& x, const dvec3& y) { return glm::dot(x, hessian * y); };

    const dvec3 t = any_tangent(n), b = glm::cross(n, t);
    set_principal(c, t, b, h(t, t), h(t, b), h(b, b));

    const auto third = [&](const dvec3& x, const dvec3& y, const dvec3& z) {
        double sum = 0.0;
        for (int i = 0; i < 3; ++i) sum += x[i] * glm::dot(y, jet.third[i] * z);
        return sum / length - h(x, z) * h(n, y) - h(y, z) * h(n, x) - h(x, y) * h(n, z);
    };
    c.C[0] = third(c.e1, c.e1, c.e1);
    c.C[1] = third(c.e1, c.e1, c.e2);
    c.C[2] = third(c.e1, c.e2, c.e2);
    c.C[3] = third(c.e2, c.e2, c.e2);
    return c;
}

CurvatureD mapped(const Curvature& c, const dmat3& inverse) {
    if (c.normal == vec3(0.0f)) return {};
    // F = z + h(x, x) / 2 + C(x, x, x) / 6 over the tangent plane. Column i of `to_frame`: a unit step along coordinate
    // i of the image, in the frame (e1, e2, n).
    const dmat3 to_frame = glm::transpose(dmat3(c.e1, c.e2, c.normal)) * inverse, back = glm::transpose(to_frame);
    const auto form = [&](double xx, double xy, double yy) {
        return back * dmat3(xx, xy, 0, xy, yy, 0, 0, 0, 0) * to_frame;
    };
    ImplicitJet jet;
    jet.gradient = back[2];
    jet.hessian = form(c.k1, 0.0, c.k2);
    const dmat3 along_e1 = form(c.C[0], c.C[1], c.C[2]), along_e2 = form(c.C[1], c.C[2], c.C[3]);
    for (int i = 0; i < 3; ++i) jet.third[i] = to_frame[i].x * along_e1 + to_frame[i].y * along_e2;
    return curvature_of(jet);
}

CurvatureD curvature_of(const HeightJetD& jet) {
    CurvatureD c{};
    c.normal = jet.normal;
    if (jet.normal == dvec3(0.0)) return c;
    set_principal(c, jet.tangent, glm::cross(jet.normal, jet.tangent), -jet.second[0], -jet.second[1], -jet.second[2]);
    const HeightJetD along = turned(jet, jet.normal, c.e1);
    for (int i = 0; i < 4; ++i) c.C[i] = -along.third[i];
    return c;
}

Array<Curvature> curvature_of(const Array<HeightJet>& jets) {
    return parallel_map<Curvature>(jets.size(), [&](std::size_t v) {
        const HeightJet& jet = jets[v];
        HeightJetD exact{};
        // Rounding to float has left them neither unit nor orthogonal.
        const dvec3 n(jet.normal), t(jet.tangent);
        if (n != dvec3(0.0)) {
            exact.normal = glm::normalize(n);
            exact.tangent = glm::normalize(t - glm::dot(t, exact.normal) * exact.normal);
        }
        for (int i = 0; i < 3; ++i) exact.second[i] = jet.second[i];
        for (int i = 0; i < 4; ++i) exact.third[i] = jet.third[i];
        return rounded(curvature_of(exact));
    });
}

}  // namespace fovea::field
