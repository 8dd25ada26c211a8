// SPDX-License-Identifier: GPL-3.0-or-later
// Conservative bounds of view-dependent quantities over a cluster of triangles.
#pragma once

#include <cmath>

#include <fovea/field/clusters.h>
#include <fovea/line/definition.h>
#include <fovea/line/zero_set.h>

namespace fovea::line {

/// A cluster as one placement of it is seen. Every range holds what vertices of the cluster get from see_vertex and
/// field/view_curvature.h, rounding included.
class SeenCluster {
   public:
    SeenCluster(const SurfaceView& seen, const ClusterBounds& bounds) : bounds_(bounds) {
        const dvec3 towards(seen.to_viewer(bounds.center));
        const double distance = glm::length(towards);
        towards_ = distance > 0.0 ? towards / distance : dvec3(0.0);
        if (!seen.orthographic) {
            // The chord of the angle under which the sphere is seen from the eye.
            const double sine = bounds.radius / distance;
            turn_ = sine < 0.99 ? std::sqrt(2.0 - 2.0 * std::sqrt(1.0 - sine * sine)) : 2.0;
        }
        turn_ += rounding;
    }

    /// n . v.
    Range facing() const {
        const dvec3 normal(bounds_.normal);
        return around(glm::dot(normal, towards_), bounds_.normal_spread + turn_ * glm::length(normal), 1.0);
    }

    /// RadialOf::scaled, the form h of the view direction.
    Range radial() const {
        const dvec3 along = times_form(towards_);
        const double spread = bounds_.form_spread + turn_ * (2.0 * glm::length(along) + turn_ * bounds_.curvature);
        return around(glm::dot(along, towards_), spread, bounds_.curvature);
    }

    /// laplacian().
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
    double turn_ = 0.0;  // the view direction of no vertex is farther from that of the center
};

}  // namespace fovea::line
