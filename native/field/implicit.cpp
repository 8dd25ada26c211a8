#include "field/implicit.h"

#include <cmath>

namespace fovea {

CurvatureD curvature_of(const ImplicitJet& jet) {
    CurvatureD c;
    const double length = glm::length(jet.gradient);
    if (!(length > 0.0)) return c;
    const dvec3 n = c.normal = jet.gradient / length;
    const dmat3 hessian = jet.hessian / length;
    const auto h = [&](const dvec3& x, const dvec3& y) { return glm::dot(x, hessian * y); };

    // Any tangent frame, turned by the angle that makes h diagonal.
    const dvec3 any = std::abs(n.x) < 0.6 ? dvec3(1, 0, 0) : std::abs(n.y) < 0.6 ? dvec3(0, 1, 0) : dvec3(0, 0, 1);
    const dvec3 t = glm::normalize(any - n * glm::dot(n, any)), b = glm::cross(n, t);
    const double angle = 0.5 * std::atan2(2.0 * h(t, b), h(t, t) - h(b, b));
    c.e1 = std::cos(angle) * t + std::sin(angle) * b;
    c.e2 = glm::cross(n, c.e1);
    c.k1 = h(c.e1, c.e1);
    c.k2 = h(c.e2, c.e2);
    if (std::abs(c.k1) < std::abs(c.k2)) {
        std::swap(c.k1, c.k2);
        const dvec3 first = c.e1;
        c.e1 = c.e2;
        c.e2 = -first;
    }

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
