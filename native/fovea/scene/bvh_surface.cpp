// SPDX-License-Identifier: GPL-3.0-or-later
// One BVH per surface, refitted or rebuilt when its vertices move.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <new>
#include <stdexcept>
#include <string>
#include <tbb/task_arena.h>

#include <fovea/base/cancel.h>
#include <fovea/base/fork_join.h>
#include <fovea/base/hash.h>
#include <fovea/base/morton.h>
#include <fovea/base/parallel.h>
#include <fovea/scene/bvh.h>

namespace fovea::scene {
namespace {

/// Number of triangles sampled to judge a refitted BVH, and the factor by which their spread may grow before a rebuild.
constexpr Index probes = 4096;
constexpr double worst_spread = 1.7;

/// Numbers of triangles from which building takes longer than the rays of a frame gain by a BVH of default quality, at
/// worst a sixth of their time, instead of one by Morton order, which takes a third of the time to build; and by
/// smaller patches.
constexpr Index some = 1 << 17, many = 1 << 18;

/// How many corners two triangles share.
int shared_corners(const Triangle& a, const Triangle& b) {
    int shared = 0;
    for (int i = 0; i < 3; ++i) shared += a[i] == b[0] || a[i] == b[1] || a[i] == b[2];
    return shared;
}

/// Patches of the occluding triangles: each is consecutive triangles, of which each shares corners with one before it.
/// Those of `many` are larger, since rows of quads share corners, but not sides: building takes less of a frame's time
/// then, and rays a little more. The number of the first triangle of each patch, and at last that of all triangles.
Array<Index> patches(const Surface& surface) {
    const auto& triangles = surface.triangles;
    const bool few = surface.occluding_triangles < many;
    const Index most = few ? 4 : 8;
    const int least_shared = few ? 2 : 1;
    const auto fill = [&](std::size_t begin, std::size_t end, Array<Index>& first) {
        for (auto i = static_cast<Index>(begin); i < end; ++i) {
            const auto belongs = [&](Index j) { return shared_corners(triangles[j], triangles[i]) >= least_shared; };
            bool found = false;
            if (i > begin && i - first.back() < most)
                for (Index j = first.back(); j < i && !found; ++j) found = belongs(j);
            if (!found) first.push_back(i);
        }
    };
    Array<Index> first = parallel_collect<Index>(surface.occluding_triangles, 1 << 14, fill);
    first.push_back(surface.occluding_triangles);
    return first;
}

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
        // FOVEA_EMBREE: further options of Embree, for tests, as "max_isa=sse2".
        const char* more = std::getenv("FOVEA_EMBREE");
        const RTCDevice made = rtcNewDevice((std::string("ignore_config_files=1,") + (more ? more : "")).c_str());
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

SurfaceBvh::SurfaceBvh(const Surface& surface) {
    build(surface);
    version_ = surface.version();
}

void SurfaceBvh::build(const Surface& surface) const {
    hash_ = 0;  // of no triangles, until it is built
    patches_ = patches(surface);
    take(surface);
    scene_.reset(rtcNewScene(bvh_device()));
    if (moves_) rtcSetSceneFlags(scene_.get(), RTC_SCENE_FLAG_DYNAMIC);
    const bool quick = surface.occluding_triangles >= some;
    if (moves_ || quick)
        rtcSetSceneBuildQuality(scene_.get(), RTC_BUILD_QUALITY_LOW);  // Embree looks at that of geometries then
    geometry_ = attach_boxes(scene_.get(), patches_.size() - 1, box_of, meet, &triangles_);
    if (moves_ || quick) {
        rtcSetGeometryBuildQuality(geometry_, moves_ ? RTC_BUILD_QUALITY_REFIT : RTC_BUILD_QUALITY_LOW);
        rtcCommitGeometry(geometry_);
    }
    const Array<RTCBounds> boxes = take_boxes();
    build_bvh(scene_.get(), surface.name());
    if (!moves_) return;
    hash_ = hash_of_triangles(surface);
    neighbors_ = neighbors(surface);
    spread_ = spread(surface, neighbors_);
}

void SurfaceBvh::take(const Surface& surface) const {
    triangles_ = {surface.positions.data(),
                  surface.triangles.data(),
                  patches_.data(),
                  dvec3(surface.center),
                  1.0 / std::max(double(surface.radius), std::numeric_limits<double>::min()),
                  nullptr};
}

Array<RTCBounds> SurfaceBvh::take_boxes() const {
    Array<RTCBounds> boxes = parallel_map<RTCBounds>(patches_.size() - 1, [&](std::size_t patch) {
        vec3 lower(infinity), upper(-infinity);
        for (Index i = patches_[patch]; i < patches_[patch + 1]; ++i)
            for (int k = 0; k < 3; ++k) {
                const vec3& corner = triangles_.positions[triangles_.triangles[i][k]];
                lower = glm::min(lower, corner);
                upper = glm::max(upper, corner);
            }
        const dvec3& center = triangles_.center;
        return box_between((dvec3(lower) - center) * triangles_.scale, (dvec3(upper) - center) * triangles_.scale, 1.0);
    });
    triangles_.boxes = boxes.data();
    return boxes;
}

void SurfaceBvh::follow(const Surface& surface) const {
    const std::lock_guard lock(mutex_);
    if (version_ == surface.version()) return;
    // Isolated: a thread that waits for others in here takes no task that waits for this lock.
    tbb::this_task_arena::isolate([&] {
        if (moves_ && hash_of_triangles(surface) == hash_ && spread(surface, neighbors_) <= worst_spread * spread_) {
            take(surface);
            const Array<RTCBounds> boxes = take_boxes();
            rtcCommitGeometry(geometry_);
            commit(scene_.get());
            check_bvh_device(surface.name());
        } else {
            moves_ = true;
            build(surface);
        }
    });
    version_ = surface.version();
}

void SurfaceBvh::lead(RayContext& context) const {
    // The ray begins where it can first meet the sphere around the surface.
    const dvec3 along = context.local.direction, way = triangles_.center - context.local.origin;
    const double longest = std::abs(along[context.local.z]), radius = 1.0 / triangles_.scale;
    context.first_t = std::max(context.near_t, glm::dot(way, along) / glm::dot(along, along) - radius / longest);
    context.longest = longest * triangles_.scale;
    RTCRayHit ray = ray_through_boxes((context.first_t * along - way) * triangles_.scale, along * triangles_.scale, 0.0,
                                      context.far_t - context.first_t);
    follow_ray(scene_.get(), ray, context);
}

void SurfaceBvh::lead_to(Index triangle, RayContext& context) {
    meet(context, context.surface->positions.data(), context.surface->triangles[triangle], triangle);
}

void SurfaceBvh::meet(RayContext& context, const vec3* p, const Triangle& t, Index triangle) {
    TriangleHit hit;
    if (meets(context.local, p[t.x], p[t.y], p[t.z], hit) && hit.t > context.near_t && hit.t <= context.far_t)
        context.meet(triangle, hit);
}

void SurfaceBvh::box_of(const RTCBoundsFunctionArguments* at) {
    *at->bounds_o = static_cast<const Triangles*>(at->geometryUserPtr)->boxes[at->primID];
}

void SurfaceBvh::meet(const RTCIntersectFunctionNArguments* at) {
    const Triangles& of = *static_cast<const Triangles*>(at->geometryUserPtr);
    auto& context = *static_cast<RayContext*>(at->context);
    const double before = context.far_t;
    for (Index i = of.patches[at->primID]; i < of.patches[at->primID + 1]; ++i)
        meet(context, of.positions, of.triangles[i], i);
    if (context.far_t != before)
        RTCRayN_tfar(RTCRayHitN_RayN(at->rayhit, 1), 1, 0) =
            end_of_ray(context.far_t - context.first_t, context.longest);
}

}  // namespace fovea::scene
