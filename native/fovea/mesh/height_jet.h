// SPDX-License-Identifier: GPL-3.0-or-later
// Local shape of a smooth surface: derivatives of its height over the tangent plane at a point.
#pragma once

#include <cmath>

#include <fovea/base/types.h>

namespace fovea::mesh {

/// z = f(x, y) over the tangent plane at the point, x along `tangent`, y along normal x tangent, z along the outward
/// unit normal; f and its first derivatives are zero at the point. Units: second derivatives 1 / length, third 1 /
/// length^2. All zero where the surface is unknown. Without values unless it is given some, as field::CurvatureOf.
template <typename Real>
struct HeightJetOf {
    using Vec3 = glm::vec<3, Real>;
    Vec3 normal, tangent;
    Real second[3];  ///< f_xx, f_xy, f_yy
    Real third[4];   ///< f_xxx, f_xxy, f_xyy, f_yyy
};

using HeightJet = HeightJetOf<float>;    ///< as stored per vertex
using HeightJetD = HeightJetOf<double>;  ///< as computed

/// Derivatives of a parametric surface S(u, v) at a point.
struct ParametricJet {
    dvec3 u{0.0}, v{0.0};
    dvec3 uu{0.0}, uv{0.0}, vv{0.0};
    dvec3 uuu{0.0}, uuv{0.0}, uvv{0.0}, vvv{0.0};
};

/// Exact conversion for any parameterization; the outward normal is along u x v. All zero if u and v are parallel (sine
/// of their angle <= 1e-9) or zero.
HeightJetD height_jet(const ParametricJet& jet);

/// The jet in another frame. `normal` and `tangent`: orthogonal unit vectors. The jet is carried along by the smallest
/// rotation from its own normal to `normal`.
HeightJetD turned(const HeightJetD& jet, const dvec3& normal, const dvec3& tangent);

/// An arbitrary unit tangent for the unit normal n.
inline dvec3 any_tangent(const dvec3& n) {
    const dvec3 axis = std::abs(n.x) < 0.6 ? dvec3(1, 0, 0) : std::abs(n.y) < 0.6 ? dvec3(0, 1, 0) : dvec3(0, 0, 1);
    return glm::normalize(glm::cross(axis, n));
}

}  // namespace fovea::mesh
