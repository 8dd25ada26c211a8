// SPDX-License-Identifier: GPL-3.0-or-later
// Conservative bounds of view-dependent quantities over a cluster of triangles.
#pragma once

#include <cmath>

#include <fovea/field/clusters.h>
#include <fovea/line/definition.h>
#include <fovea/line/zero_set.h>

namespace fovea::line {

/// A cluster seen in one placement. Each range contains the values that see_vertex and field/view_curvature.h give at
/// the cluster's vertices, including rounding errors.
class SeenCluster {
   public:
    SeenCluster(const SurfaceView& seen, const ClusterBounds& bounds) : bounds_(bounds) {
        const dvec3 towards(seen.to_viewer(bounds.center));
        const double distance = glm::length(towards);
        towards_ = distance > 0.0 ? towards / distance : dvec3(0.0);
        if (!seen.orthographic) {
            // Chord of the angle that the bounding sphere's radius subtends at the eye.
            const double sine = bounds.radius / distance;
            turn_ = sine < 0.99 ? std::sqrt(2.0 - 2.0 * std::sqrt(1.0 - sine * sine)) : 2.0;
        }
        turn_ += rounding;
    }

    /// Range of n . v.
    Range facing() const {
        const dvec3 normal(bounds_.normal);
        return around(glm::dot(normal, towards_), bounds_.normal_spread + turn_ * glm::length(normal), 1.0);
    }

    /// Range of RadialOf::scaled, the form h applied to the view direction.
    Range radial() const {
        const dvec3 along = times_form(towards_);
        const double spread = bounds_.form_spread + turn_ * (2.0 * glm::length(along) + turn_ * bounds_.curvature);
        return around(glm::dot(along, towards_), spread, bounds_.curvature);
    }

    /// Range of laplacian() of view_curvature.h.
    Range laplacian() const {
        const dvec3 form(bounds_.laplacian);
        const double length = glm::length(form);
        return around(glm::dot(form, towards_), bounds_.laplacian_spread + turn_ * length, length);
    }

    const ClusterBounds& bounds() const { return bounds_; }

   private:
    static constexpr double rounding = 1e-5;

    static Range around(double middle, double spread, double scale) {
        const double reach = spread + rounding * (spread + scale);
        return {static_cast<float>(middle - reach), static_cast<float>(middle + reach)};
    }

    dvec3 times_form(const dvec3& x) const {
        const dvec3 s(bounds_.form[0]), m(bounds_.form[1]);
        return s * x + dvec3(m.x * x.y + m.y * x.z, m.x * x.x + m.z * x.z, m.y * x.x + m.z * x.y);
    }

    const ClusterBounds& bounds_;
    dvec3 towards_;
    double turn_ = 0.0;  // upper bound of |v - v_center| over the vertices' unit view directions v
};

}  // namespace fovea::line
