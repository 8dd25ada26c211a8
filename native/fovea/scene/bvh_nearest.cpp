// SPDX-License-Identifier: GPL-3.0-or-later
// Nearest-point queries, by Embree's point queries.
#include <algorithm>
#include <cmath>

#include <fovea/scene/bvh.h>
#include <fovea/scene/nearest.h>

namespace fovea::scene {
namespace {

/// Widens query radii: bounds of boxes and distances are rounded.
constexpr float wider = 1.0f + 1e-5f;

/// Point of triangle abc nearest to p. Ericson, "Real-Time Collision Detection", 2005, 5.1.5.
dvec3 nearest_in_triangle(const dvec3& p, const dvec3& a, const dvec3& b, const dvec3& c) {
    const dvec3 ab = b - a, ac = c - a, ap = p - a, bp = p - b, cp = p - c;
    const double d1 = glm::dot(ab, ap), d2 = glm::dot(ac, ap);
    if (d1 <= 0 && d2 <= 0) return a;
    const double d3 = glm::dot(ab, bp), d4 = glm::dot(ac, bp);
    if (d3 >= 0 && d4 <= d3) return b;
    const double vc = d1 * d4 - d3 * d2;
    if (vc <= 0 && d1 >= 0 && d3 <= 0) return d1 == d3 ? a : a + d1 / (d1 - d3) * ab;
    const double d5 = glm::dot(ab, cp), d6 = glm::dot(ac, cp);
    if (d6 >= 0 && d5 <= d6) return c;
    const double vb = d5 * d2 - d1 * d6;
    if (vb <= 0 && d2 >= 0 && d6 <= 0) return d2 == d6 ? a : a + d2 / (d2 - d6) * ac;
    const double va = d3 * d6 - d5 * d4;
    if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) {
        const double length = (d4 - d3) + (d5 - d6);
        return length > 0 ? b + (d4 - d3) / length * (c - b) : b;
    }
    const double sum = va + vb + vc;
    return a + vb / sum * ab + vc / sum * ac;
}

}  // namespace

struct NearestPoint::Bvh {
    Array<vec3> positions;
    Array<Triangle> triangles;
    OwnedScene scene = nullptr;

    void build() {
        scene.reset(rtcNewScene(bvh_device()));
        attach_boxes(scene.get(), triangles.size(), box_of, nullptr, this);
        build_bvh(scene.get(), "nearest point");
    }

    static void box_of(const RTCBoundsFunctionArguments* at) {
        const Bvh& of = *static_cast<const Bvh*>(at->geometryUserPtr);
        const Triangle& t = of.triangles[at->primID];
        const dvec3 a(of.positions[t.x]), b(of.positions[t.y]), c(of.positions[t.z]);
        *at->bounds_o = box_between(glm::min(a, glm::min(b, c)), glm::max(a, glm::max(b, c)), 0.0);
    }

    /// State of one query.
    struct Asked {
        const Bvh& bvh;
        dvec3 point;
        double distance = std::numeric_limits<double>::infinity();
        Index triangle = none;
        dvec3 nearest{0.0};

        static bool look(RTCPointQueryFunctionArguments* at) {
            auto& self = *static_cast<Asked*>(at->userPtr);
            const Triangle& t = self.bvh.triangles[at->primID];
            const auto& p = self.bvh.positions;
            const dvec3 there = nearest_in_triangle(self.point, dvec3(p[t[0]]), dvec3(p[t[1]]), dvec3(p[t[2]]));
            const double distance = glm::distance(self.point, there);
            const bool nearer = distance < self.distance;
            if (!nearer && !(distance == self.distance && at->primID < self.triangle)) return false;
            self.distance = distance;
            self.triangle = at->primID;
            self.nearest = there;
            at->query->radius = std::min(at->query->radius, static_cast<float>(distance) * wider);
            return nearer;
        }
    };
};

NearestPoint::NearestPoint(Array<vec3> positions, Array<Triangle> triangles)
    : bvh_(new Bvh{std::move(positions), std::move(triangles)}) {
    if (!bvh_->triangles.empty()) bvh_->build();
}

NearestPoint::~NearestPoint() = default;

std::optional<dvec3> NearestPoint::operator()(const vec3& p, float far) const {
    if (!bvh_->scene || !std::isfinite(p.x + p.y + p.z)) return std::nullopt;
    Bvh::Asked asked{*bvh_, dvec3(p)};
    RTCPointQuery query{p.x, p.y, p.z, 0.0f, far * wider};
    RTCPointQueryContext context;
    rtcInitPointQueryContext(&context);
    rtcPointQuery(bvh_->scene.get(), &query, &context, Bvh::Asked::look, &asked);
    if (static_cast<float>(asked.distance) > far || asked.triangle == none) return std::nullopt;
    return asked.nearest;
}

}  // namespace fovea::scene
