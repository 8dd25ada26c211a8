// What a view can see of a cluster of triangles at most.
#pragma once

#include <cmath>

#include "field/clusters.h"
#include "line/definition.h"
#include "line/zero_set.h"

namespace fovea {

/// A cluster as one placement of it is seen. Every range holds what vertices of the cluster get from see_vertex and
/// field/view_curvature.h, rounding included.
class SeenCluster {
   public:
    SeenCluster(const SurfaceView& seen, const ClusterBounds& bounds) : bounds_(bounds) {
        const vec3 towards = seen.to_viewer(bounds.center);
        const float distance = glm::length(towards);
        towards_ = distance > 0.0f ? towards / distance : vec3(0.0f);
        if (!seen.orthographic) {
            // The chord of the angle under which the sphere is seen from the eye.
            const float sine = bounds.radius / distance;
            turn_ = sine < 0.99f ? std::sqrt(2.0f - 2.0f * std::sqrt(1.0f - sine * sine)) : 2.0f;
        }
        turn_ += rounding;
    }

    /// n . v.
    Range facing() const {
        return around(glm::dot(bounds_.normal, towards_), bounds_.normal_spread + turn_ * glm::length(bounds_.normal), 1.0f);
    }

    /// RadialOf::scaled, the form h of the view direction.
    Range radial() const {
        const vec3 along = times_form(towards_);
        const float middle = glm::dot(along, towards_);
        const float spread = bounds_.form_spread + turn_ * (2.0f * glm::length(along) + turn_ * bounds_.curvature);
        return around(middle, spread, bounds_.curvature);
    }

    /// laplacian().
    Range laplacian() const {
        const float length = glm::length(bounds_.laplacian);
        return around(glm::dot(bounds_.laplacian, towards_), bounds_.laplacian_spread + turn_ * length, length);
    }

    const ClusterBounds& bounds() const { return bounds_; }

   private:
    static constexpr float rounding = 1e-5f;

    static Range around(float middle, float spread, float scale) {
        const float reach = spread + rounding * (spread + scale);
        return {middle - reach, middle + reach};
    }

    vec3 times_form(const vec3& x) const {
        const vec3 &s = bounds_.form[0], &m = bounds_.form[1];
        return {s.x * x.x + m.x * x.y + m.y * x.z, m.x * x.x + s.y * x.y + m.z * x.z, m.y * x.x + m.z * x.y + s.z * x.z};
    }

    const ClusterBounds& bounds_;
    vec3 towards_;
    float turn_ = 0.0f;  // the view direction of no vertex is farther from that of the centre
};

}  // namespace fovea
