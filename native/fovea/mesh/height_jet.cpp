// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/mesh/height_jet.h>

namespace fovea::mesh {
namespace {

/// Sine of the angle between u and v at or below which they count as parallel.
constexpr double least_sine = 1e-9;

/// Symmetric bilinear and trilinear forms on 2D vectors, given by their coefficients.
double form(const double (&a)[3], const dvec2& p, const dvec2& q) {
    return a[0] * p.x * q.x + a[1] * (p.x * q.y + p.y * q.x) + a[2] * p.y * q.y;
}

double form(const double (&a)[4], const dvec2& p, const dvec2& q, const dvec2& r) {
    return p.x * (a[0] * q.x * r.x + a[1] * (q.x * r.y + q.y * r.x) + a[2] * q.y * r.y) +
           p.y * (a[1] * q.x * r.x + a[2] * (q.x * r.y + q.y * r.x) + a[3] * q.y * r.y);
}

/// Coefficients of the forms in the basis (p, q) instead of the axes.
void change_basis(const double (&second)[3], const double (&third)[4], const dvec2& p, const dvec2& q,
                  HeightJetD& out) {
    out.second[0] = form(second, p, p);
    out.second[1] = form(second, p, q);
    out.second[2] = form(second, q, q);
    out.third[0] = form(third, p, p, p);
    out.third[1] = form(third, p, p, q);
    out.third[2] = form(third, p, q, q);
    out.third[3] = form(third, q, q, q);
}

}  // namespace

HeightJetD height_jet(const ParametricJet& s) {
    HeightJetD result{};
    const dvec3 area = glm::cross(s.u, s.v);
    const double size = glm::length(area);
    if (!(size > least_sine * glm::length(s.u) * glm::length(s.v))) return result;
    const dvec3 n = result.normal = area / size;
    const dvec3 t = result.tangent = glm::normalize(s.u), b = glm::cross(n, t);
    const auto in_plane = [&](const dvec3& d) { return dvec2(glm::dot(d, t), glm::dot(d, b)); };
    const auto height = [&](const dvec3& d) { return glm::dot(d, n); };

    // z(u, v) = f(x(u, v), y(u, v)). As f_x = f_y = 0, its second derivatives are f'' applied to (x_u, y_u) and (x_v,
    // y_v). p and q are the steps (du, dv) that move by one along x and along y.
    const dvec2 u = in_plane(s.u), v = in_plane(s.v);
    const double determinant = u.x * v.y - u.y * v.x;
    const dvec2 p = dvec2(v.y, -u.y) / determinant, q = dvec2(-v.x, u.x) / determinant;
    const double second[3] = {height(s.uu), height(s.uv), height(s.vv)};
    const double no_third[4] = {0, 0, 0, 0};
    change_basis(second, no_third, p, q, result);

    // Third order: z_abc = f3(a, b, c) + f2(ab, c) + f2(ac, b) + f2(bc, a).
    const auto f2 = [&](const dvec2& a, const dvec2& c) { return form(result.second, a, c); };
    const dvec2 uu = in_plane(s.uu), uv = in_plane(s.uv), vv = in_plane(s.vv);
    const double third[4] = {height(s.uuu) - 3 * f2(uu, u), height(s.uuv) - f2(uu, v) - 2 * f2(uv, u),
                             height(s.uvv) - f2(vv, u) - 2 * f2(uv, v), height(s.vvv) - 3 * f2(vv, v)};
    change_basis(second, third, p, q, result);
    return result;
}

HeightJetD turned(const HeightJetD& jet, const dvec3& normal, const dvec3& tangent) {
    HeightJetD result{};
    result.normal = normal;
    result.tangent = tangent;
    // The new axes, expressed in the jet's own frame. For opposite normals the smallest rotation is not unique; they
    // are then projected onto the old tangent plane.
    const dvec3 sum = jet.normal + normal;
    const double length2 = glm::dot(sum, sum);
    const dvec3 across = glm::cross(jet.normal, jet.tangent);
    const auto back = [&](const dvec3& d) {
        const dvec3 turned_back = length2 > 1e-12 ? d - (2.0 * glm::dot(d, sum) / length2) * sum : d;
        // Reflecting across the plane orthogonal to `sum` maps the new normal to minus the old one; within the tangent
        // plane it equals the inverse of the smallest rotation.
        return dvec2(glm::dot(turned_back, jet.tangent), glm::dot(turned_back, across));
    };
    change_basis(jet.second, jet.third, back(tangent), back(glm::cross(normal, tangent)), result);
    return result;
}

}  // namespace fovea::mesh
