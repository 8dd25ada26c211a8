#include "field/implicit.h"

#include "field/principal.h"

namespace fovea {

CurvatureD curvature_of(const ImplicitJet& jet) {
    CurvatureD c;
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

}  // namespace fovea
