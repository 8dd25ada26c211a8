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

    /// Returns S(u, v) and writes all derivatives up to third order to `jet`.
    dvec3 at(double u, double v, ParametricJet& jet) const {
        dvec3 along_v[4][4];  // per derivative by v: coefficients of the powers of u
        for (int i = 0; i < 4; ++i) {
            const dvec3(&a)[4] = c[i];
            along_v[0][i] = a[0] + v * (a[1] + v * (a[2] + v * a[3]));
            along_v[1][i] = a[1] + v * (2.0 * a[2] + v * 3.0 * a[3]);
            along_v[2][i] = 2.0 * a[2] + v * 6.0 * a[3];
            along_v[3][i] = 6.0 * a[3];
        }
        const auto value = [&](int d) {
            const dvec3(&a)[4] = along_v[d];
            return a[0] + u * (a[1] + u * (a[2] + u * a[3]));
        };
        const auto first = [&](int d) {
            const dvec3(&a)[4] = along_v[d];
            return a[1] + u * (2.0 * a[2] + u * 3.0 * a[3]);
        };
        const auto second = [&](int d) { return 2.0 * along_v[d][2] + u * 6.0 * along_v[d][3]; };
        jet.u = first(0);
        jet.v = value(1);
        jet.uu = second(0);
        jet.uv = first(1);
        jet.vv = value(2);
        jet.uuu = 6.0 * along_v[0][3];
        jet.uuv = second(1);
        jet.uvv = first(2);
        jet.vvv = value(3);
        return value(0);
    }
};

}  // namespace fovea::mesh
