// SPDX-License-Identifier: GPL-3.0-or-later
// The line definitions once more, as functions of exact curvature in double precision: what is to be found where.
#pragma once

#include <string>

#include <fovea/field/fields.h>
#include <fovea/field/view_curvature.h>

#include "exact_curves.h"
#include "rules.h"

namespace fovea::analytic {
using namespace draw;

/// An eye, or with `orthographic` the direction towards it.
struct Eye {
    dvec3 at;
    bool orthographic = true;

    SeenOf<double> see(const CurvatureD& c, const dvec3& p) const {
        const dvec3 towards = orthographic ? at : at - p;
        const double distance = glm::length(towards);
        return field::see(c, towards / distance, orthographic ? 0.0 : 1.0 / distance);
    }
    SurfaceView view(const Surface& surface) const {
        SurfaceView seen{.surface = surface};
        seen.eye_obj = orthographic ? glm::normalize(at) : at;
        seen.orthographic = orthographic;
        return seen;
    }
};

/// One definition with its thresholds: what is zero, and what is kept (the least of all conditions, positive).
struct ExactLine {
    using Field = std::function<Along(const CurvatureD&, const SeenOf<double>&)>;
    using Condition = std::function<double(const CurvatureD&, const SeenOf<double>&)>;
    Field field;
    Condition kept = [](const CurvatureD&, const SeenOf<double>&) { return 1.0; };
    bool maximum = false;     ///< the value is a derivative along its direction; only where it falls
    double least_bend = 0.0;  ///< by at least so much per length
};

inline ExactLine exact_line(const std::string& name, const Values& values, double feature_size) {
    using C = CurvatureD;
    using S = SeenOf<double>;
    const double unit = 1.0 / feature_size, squared = unit * unit;
    const double sign = name.find("valley") != std::string::npos || name == "suggestive_highlight" ? -1.0 : 1.0;
    const auto value = [&](const char* parameter, double otherwise) {
        const auto& all = definition_called(name).parameters;
        for (std::size_t i = 0; i < all.size(); ++i)
            if (all[i].name == std::string(parameter)) return values[i];
        return otherwise;
    };
    // Lines are found down to the low threshold; which of them stay is hysteresis.
    const double t = value("threshold", 0.0) * value("low", 1.0);
    if (name == "smooth_contour") return {[](const C&, const S& s) { return Along{s.facing}; }};
    if (name == "suggestive_contour" || name == "suggestive_highlight")
        return {[](const C& c, const S& s) { return Along{radial(c, s).scaled}; },
                [=](const C& c, const S& s) {
                    return std::min(sign * radial(c, s).derivative - t * squared * s.facing, s.facing);
                }};
    if (name == "ridge" || name == "valley")
        return {[=](const C& c, const S&) { return Along{sign * c.C[0], c.e1}; },
                [=](const C& c, const S&) { return sign * c.k1 - t * unit; }, true,
                value("sharpness", 0.0) * squared * unit};
    if (name == "principal_highlight_ridge" || name == "principal_highlight_valley")
        return {[](const C& c, const S& s) { return Along{s.u, c.e1}; },
                [=](const C& c, const S& s) {
                    return std::min((c.k1 * c.k1 - c.k2 * c.k2) * s.facing - t * squared, sign * c.k1);
                }};
    if (name == "apparent_ridge")
        return {[](const C& c, const S& s) {
                    const auto v = view_curvature(c, s);
                    const dvec3 a = v.a1 * c.e1 + v.a2 * c.e2;
                    return Along{v.derivative / glm::length(a), a / glm::length(a)};
                },
                [=](const C& c, const S& s) {
                    return std::min(view_curvature(c, s).squared - t * squared, s.facing - 0.1);
                },
                true};
    if (name == "demarcating_curve")
        return {[](const C& c, const S&) {
                    const auto d = demarcating(c);
                    return Along{d.curvature, d.g1 * c.e1 + d.g2 * c.e2, true};
                },
                [=](const C& c, const S&) { return demarcating(c).strength - t * squared; }};
    if (name == "laplacian_line")
        return {[](const C& c, const S& s) { return Along{laplacian(c, s)}; },
                [=](const C& c, const S& s) { return std::min(std::sqrt(gradient2(c, s)) - t * unit, s.facing); }};
    if (name == "parabolic" || name == "zero_mean_curvature")
        return {[=](const C& c, const S&) { return Along{name == "parabolic" ? c.k1 * c.k2 : c.k1 + c.k2}; },
                [=](const C& c, const S&) { return std::abs(c.k1) - t * unit; }};
    throw std::invalid_argument("no exact line is called '" + name + "'");
}

/// Everything of a surface that is such a line.
inline ExactCurves exact_curves(const ExactGrid& grid, const ExactLine& line, const Eye& eye) {
    const auto at = [&](const dvec3& p, const CurvatureD& c) { return line.field(c, eye.see(c, p)); };
    const auto margin = [&](const dvec3& p) {
        const CurvatureD c = grid.sample.exact(p);
        const double kept = line.kept(c, eye.see(c, p));
        if (!line.maximum) return kept;
        constexpr double step = 1e-4;
        const Along here = at(p, c);
        const auto beside = [&](double d) {
            const dvec3 q = p + d * here.direction;
            return at(q, grid.sample.exact(q)).as_at(here);
        };
        const auto before = beside(-step), after = beside(step);
        return before && after ? std::min(kept, (*before - *after) / (2.0 * step) - line.least_bend) : -1.0;
    };
    return ExactTrace(grid, at, margin).run();
}

}  // namespace fovea::analytic
