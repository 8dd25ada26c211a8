// SPDX-License-Identifier: GPL-3.0-or-later
// A bicubic polynomial patch, with all its derivatives.
#pragma once

#include <fovea/mesh/height_jet.h>

namespace fovea::mesh {

/// Position and derivatives at one corner of a patch over [0,1]^2.
struct PatchCorner {
    dvec3 p{0.0}, u{0.0}, v{0.0}, uv{0.0};
};

/// S(u, v) = sum of c[i][j] u^i v^j.
struct Bicubic {
    dvec3 c[4][4];

    /// The patch that interpolates the given corners, in the order (0,0), (1,0), (0,1), (1,1).
    static Bicubic through(const PatchCorner (&corner)[4]) {
        // Cubic Hermite interpolation of values and slopes at 0 and 1, first along v on each side of u, then along u.
        const auto cubic = [](const dvec3& p0, const dvec3& p1, const dvec3& d0, const dvec3& d1, dvec3(&out)[4]) {
            out[0] = p0;
            out[1] = d0;
            out[2] = 3.0 * (p1 - p0) - 2.0 * d0 - d1;
            out[3] = 2.0 * (p0 - p1) + d0 + d1;
        };
        dvec3 value[2][4], slope[2][4];
        for (int i = 0; i < 2; ++i) {
            const PatchCorner &low = corner[i], &high = corner[2 + i];
            cubic(low.p, high.p, low.v, high.v, value[i]);
            cubic(low.u, high.u, low.uv, high.uv, slope[i]);
        }
        Bicubic result;
        for (int j = 0; j < 4; ++j) {
            dvec3 column[4];
            cubic(value[0][j], value[1][j], slope[0][j], slope[1][j], column);
            for (int i = 0; i < 4; ++i) result.c[i][j] = column[i];
        }
        return result;
    }

    /// The derivative, of an order up to 3, of a[0] + a[1] x + a[2] x^2 + a[3] x^3.
    template <int order>
    static dvec3 derivative(const dvec3 (&a)[4], double x) {
        if constexpr (order == 0) return a[0] + x * (a[1] + x * (a[2] + x * a[3]));
        if constexpr (order == 1) return a[1] + x * (2.0 * a[2] + x * 3.0 * a[3]);
        if constexpr (order == 2) return 2.0 * a[2] + x * 6.0 * a[3];
        return 6.0 * a[3];
    }

    /// Returns S(u, v) and writes all derivatives up to third order to `jet`.
    dvec3 at(double u, double v, ParametricJet& jet) const {
        dvec3 by_v[4][4];  // per derivative by v: coefficients of the powers of u
        for (int i = 0; i < 4; ++i) {
            by_v[0][i] = derivative<0>(c[i], v);
            by_v[1][i] = derivative<1>(c[i], v);
            by_v[2][i] = derivative<2>(c[i], v);
            by_v[3][i] = derivative<3>(c[i], v);
        }
        jet.u = derivative<1>(by_v[0], u);
        jet.v = derivative<0>(by_v[1], u);
        jet.uu = derivative<2>(by_v[0], u);
        jet.uv = derivative<1>(by_v[1], u);
        jet.vv = derivative<0>(by_v[2], u);
        jet.uuu = derivative<3>(by_v[0], u);
        jet.uuv = derivative<2>(by_v[1], u);
        jet.uvv = derivative<1>(by_v[2], u);
        jet.vvv = derivative<0>(by_v[3], u);
        return derivative<0>(by_v[0], u);
    }
};

}  // namespace fovea::mesh
