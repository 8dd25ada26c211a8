// SPDX-License-Identifier: GPL-3.0-or-later
// One BVH per surface, refitted or rebuilt when its vertices move.
#include <algorithm>
#include <new>
#include <stdexcept>
#include <string>
#include <tbb/task_arena.h>

#include <fovea/base/cancel.h>
#include <fovea/base/fork_join.h>
#include <fovea/base/hash.h>
#include <fovea/base/morton.h>
#include <fovea/scene/bvh.h>

namespace fovea::scene {
namespace {

/// Number of triangles sampled to judge a refitted BVH, and the factor by which their spread may grow before a rebuild.
constexpr Index probes = 4096;
constexpr double worst_spread = 1.7;

/// Compact whether it is refitted or not: Embree intersects triangles that it stores otherwise by other arithmetic.
const RTCSceneFlags surface_flags = bvh_flags | RTC_SCENE_FLAG_COMPACT;

/// Commits a scene as if no parallel loop called it. An Embree scene keeps the task group of its first commit, and that
/// the context which it began in: the context of a loop ends with the loop, and cancelling anything later would walk
/// over what is left of it. This arena's own lasts; it has a slot for whoever calls, so that none of them hands its
/// call to another thread, in a context that ends with the call.
void commit(RTCScene scene) {
    constexpr int callers = 256;
    static tbb::task_arena arena(tbb::this_task_arena::max_concurrency() + callers, callers);
    arena.execute([&] { rtcCommitScene(scene); });
}

vec3 middle(const Surface& surface, Index triangle) {
    const Triangle& t = surface.triangles[triangle];
    return (surface.positions[t[0]] + surface.positions[t[1]] + surface.positions[t[2]]) / 3.0f;
}

Array<Index> neighbors(const Surface& surface) {
    const Index count = std::min(probes, surface.occluding_triangles);
    Array<Index> chosen(count);
    for (Index i = 0; i < count; ++i)
        chosen[i] = static_cast<Index>(std::uint64_t(i) * surface.occluding_triangles / count);
    const float size = std::max(2.0f * surface.radius, 1e-30f);
    const auto key = [&](Index t) {
        const vec3 share = (middle(surface, t) - surface.center) / size + 0.5f;
        return along_curve(glm::uvec3(glm::clamp(share, 0.0f, 1.0f) * 1023.0f));
    };
    std::sort(chosen.begin(), chosen.end(),
              [&](Index a, Index b) { return std::pair(key(a), a) < std::pair(key(b), b); });
    return chosen;
}

/// Sum of the distances between consecutive triangles of `order`, in units of the surface's radius.
double spread(const Surface& surface, const Array<Index>& order) {
    double sum = 0.0;
    for (std::size_t i = 1; i < order.size(); ++i)
        sum += glm::distance(middle(surface, order[i - 1]), middle(surface, order[i]));
    return surface.radius > 0.0f ? sum / surface.radius : 0.0;
}

/// Hash of the occluding triangles and of the addresses of the borrowed arrays.
std::uint64_t hash_of_triangles(const Surface& surface) {
    const std::uint64_t contents = hash_bytes(surface.triangles.data(), surface.occluding_triangles * sizeof(Triangle));
    return hash_numbers(contents, reinterpret_cast<std::uintptr_t>(surface.triangles.data()),
                        reinterpret_cast<std::uintptr_t>(surface.positions.data()));
}

}  // namespace

RTCDevice bvh_device() {
    // Never released: Embree's threads may still run when statics are destroyed.
    static const RTCDevice shared = [] {
        // Limited to AVX2 so that results do not depend on wider instruction sets: frames of one film are rendered on
        // many machines.
        const RTCDevice made = rtcNewDevice("max_isa=avx2");
        if (!made) throw std::bad_alloc();  // it needs nothing but memory to start
        return made;
    }();
    return shared;
}

void check_bvh_device(const std::string& what) {
    const RTCError error = rtcGetDeviceError(bvh_device());
    if (error == RTC_ERROR_CANCELLED) throw Cancelled();
    if (error == RTC_ERROR_OUT_OF_MEMORY) throw std::bad_alloc();
    if (error != RTC_ERROR_NONE) throw std::runtime_error(what + ": Embree error " + std::to_string(error));
}

void build_bvh(RTCScene scene, const std::string& what) {
    struct Building {
        const Cancel* cancel;
        base::ForkJoin call;
    };
    {
        Building building{Cancelling::current(), {}};
        const auto goes_on = [](void* of, double) {
            const Building& asked = *static_cast<const Building*>(of);
            const base::ForkJoin::Body body(asked.call);
            return !asked.cancel->asked();
        };
        if (building.cancel) rtcSetSceneProgressMonitorFunction(scene, goes_on, &building);
        commit(scene);
    }
    rtcSetSceneProgressMonitorFunction(scene, nullptr, nullptr);
    check_bvh_device(what);
}

void share_triangles(RTCGeometry geometry, const Array<vec3>& positions, Index vertices,
                     const Array<Triangle>& triangles, Index count) {
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, positions.data(), 0,
                               sizeof(vec3), vertices);
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, triangles.data(), 0,
                               sizeof(Triangle), count);
}

SurfaceBvh::SurfaceBvh(const Surface& surface)
    : scene_(rtcNewScene(bvh_device())), geometry_(rtcNewGeometry(bvh_device(), RTC_GEOMETRY_TYPE_TRIANGLE)) {
    take_triangles(surface);
    enable_filters(geometry_);
    rtcCommitGeometry(geometry_);
    rtcAttachGeometry(scene_.get(), geometry_);
    rtcReleaseGeometry(geometry_);
    rtcSetSceneFlags(scene_.get(), surface_flags);
    build_bvh(scene_.get(), surface.name());
    version_ = surface.version();
}

void SurfaceBvh::follow(const Surface& surface) const {
    const std::lock_guard lock(mutex_);
    if (version_ == surface.version()) return;
    const bool same = moves_ && hash_of_triangles(surface) == triangles_;
    if (same && spread(surface, neighbors_) <= worst_spread * spread_) {
        rtcUpdateGeometryBuffer(geometry_, RTC_BUFFER_TYPE_VERTEX, 0);
    } else {
        rtcSetSceneFlags(scene_.get(), surface_flags | RTC_SCENE_FLAG_DYNAMIC);
        rtcSetSceneBuildQuality(scene_.get(), RTC_BUILD_QUALITY_LOW);  // Embree refits in these scenes only
        rtcSetGeometryBuildQuality(geometry_, RTC_BUILD_QUALITY_REFIT);
        take_triangles(surface);  // for other triangles Embree rebuilds the BVH
        moves_ = true;
    }
    rtcCommitGeometry(geometry_);
    commit(scene_.get());  // while it waits there, the thread takes no task that waits for this lock
    version_ = surface.version();
    check_bvh_device(surface.name());
}

void SurfaceBvh::take_triangles(const Surface& surface) const {
    share_triangles(geometry_, surface.positions, surface.vertex_count(), surface.triangles,
                    surface.occluding_triangles);
    triangles_ = hash_of_triangles(surface);
    neighbors_ = neighbors(surface);
    spread_ = spread(surface, neighbors_);
}

}  // namespace fovea::scene
