// SPDX-License-Identifier: GPL-3.0-or-later
// The nearest triangle, by Embree's point queries.
#include <cmath>
#include <limits>

#include <fovea/base/check.h>
#include <fovea/base/parallel.h>
#include <fovea/mesh/nearest.h>
#include <fovea/scene/bvh.h>
#include <fovea/scene/distance.h>

namespace fovea {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

/// A hair more than the radius asked for: bounds of boxes are rounded.
constexpr float wider = 1.0f + 1e-5f;

}  // namespace

/// All triangles in one piece, in view space: distances do not survive placements that stretch.
struct SurfaceDistance::Bvh {
    Array<vec3> positions;  // one spare at the end (Embree reads 16 bytes)
    Array<Triangle> triangles;
    RTCScene scene = nullptr;

    Bvh() = default;
    ~Bvh() { rtcReleaseScene(scene); }
    Bvh(const Bvh&) = delete;
    Bvh& operator=(const Bvh&) = delete;

    void add(const Surface& surface, const dmat4& object_to_view) {
        const std::size_t vertex = positions.size(), triangle = triangles.size();
        positions.resize(vertex + surface.vertex_count());
        parallel_for(surface.vertex_count(), [&](std::size_t i) {
            positions[vertex + i] = vec3(object_to_view * dvec4(dvec3(surface.positions[i]), 1.0));
        });
        triangles.resize(triangle + surface.triangles.size());
        parallel_for(surface.triangles.size(), [&](std::size_t i) {
            triangles[triangle + i] = surface.triangles[i] + static_cast<Index>(vertex);
        });
    }

    void commit() {
        positions.push_back(vec3(0.0f));
        scene = rtcNewScene(bvh_device());
        rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
        const RTCGeometry geometry = rtcNewGeometry(bvh_device(), RTC_GEOMETRY_TYPE_TRIANGLE);
        rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, positions.data(), 0,
                                   sizeof(vec3), positions.size() - 1);
        rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, triangles.data(), 0,
                                   sizeof(Triangle), triangles.size());
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(scene, geometry);
        rtcReleaseGeometry(geometry);
        rtcCommitScene(scene);
        check_bvh_device("distance");
    }
};

namespace {

/// A question, and the answer so far.
template <typename Bvh>
struct Asked {
    const Bvh& bvh;
    dvec3 point;
    float nearest;

    static bool look(RTCPointQueryFunctionArguments* at) {
        auto& self = *static_cast<Asked*>(at->userPtr);
        const Triangle& t = self.bvh.triangles[at->primID];
        const auto& p = self.bvh.positions;
        const dvec3 there = nearest_in_triangle(self.point, dvec3(p[t[0]]), dvec3(p[t[1]]), dvec3(p[t[2]]));
        const auto distance = static_cast<float>(glm::distance(self.point, there));
        if (!(distance < self.nearest)) return false;
        self.nearest = distance;
        at->query->radius = distance * wider;
        return true;
    }
};

}  // namespace

SurfaceDistance::SurfaceDistance(const Scene& scene, const View& view, In<Index> placements) {
    auto bvh = std::make_shared<Bvh>();
    for (const Index placement : placements) {
        check(placement < scene.placements.size(), "distance: there is no such placement");
        const Placement& placed = scene.placements[placement];
        bvh->add(*placed.surface, view.world_to_view * placed.object_to_world);
    }
    if (!bvh->triangles.empty()) bvh->commit();
    bvh_ = std::move(bvh);
}

float SurfaceDistance::operator()(const vec3& position_view, float far) const {
    const vec3& p = position_view;
    if (!bvh_->scene || !std::isfinite(p.x + p.y + p.z)) return infinity;
    Asked<Bvh> asked{*bvh_, dvec3(p), infinity};
    RTCPointQuery query{p.x, p.y, p.z, 0.0f, far * wider};
    RTCPointQueryContext context;
    rtcInitPointQueryContext(&context);
    rtcPointQuery(bvh_->scene, &query, &context, Asked<Bvh>::look, &asked);
    return asked.nearest <= far ? asked.nearest : infinity;
}

}  // namespace fovea
