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
#include <fovea/scene/box_tree.h>
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

/// Some of the occluding triangles.
Array<Index> probed(const Surface& surface) {
    Array<Index> chosen(std::min(probes, surface.occluding_triangles));
    for (std::size_t i = 0; i < chosen.size(); ++i)
        chosen[i] = static_cast<Index>(std::uint64_t(i) * surface.occluding_triangles / chosen.size());
    return chosen;
}

/// In median distances of triangles from their midst, how far the first part reaches; and times that the next ones.
constexpr double first_reach = 128.0, next_reach = 1024.0;

/// The parts of the occluding triangles, by how far each reaches; empty if all are of part 0, which is known of nearly
/// all surfaces by some of their triangles.
Array<std::uint8_t> reach_of_triangles(const Surface& surface) {
    const Array<Index> chosen = probed(surface);
    if (chosen.empty()) return {};
    const auto median = [&](const auto& value) {
        Array<double> values(chosen.size());
        for (std::size_t i = 0; i < chosen.size(); ++i) values[i] = value(chosen[i]);
        std::ranges::nth_element(values, values.begin() + values.size() / 2);
        return values[values.size() / 2];
    };
    dvec3 midst;
    for (int k = 0; k < 3; ++k) midst[k] = median([&](Index t) { return middle(surface, t)[k]; });
    const double usual = first_reach * median([&](Index t) { return glm::distance(dvec3(middle(surface, t)), midst); });
    if (2.0 * surface.radius <= usual || usual == 0.0) return {};
    return parallel_map<std::uint8_t>(surface.occluding_triangles, [&](std::size_t t) {
        double farthest = 0.0;
        for (int k = 0; k < 3; ++k)
            farthest = std::max(farthest, glm::distance(dvec3(surface.positions[surface.triangles[t][k]]), midst));
        std::uint8_t reach = 0;
        for (double within = usual; farthest > within; within *= next_reach) ++reach;
        return reach;
    });
}

Array<Index> neighbors(const Surface& surface) {
    Array<Index> chosen = probed(surface);
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

/// Of the occluding triangles with this reach, or of all, if `reach` is empty. Patches are consecutive triangles, of
/// which each shares corners with one before it. Those of `many` are larger, since rows of quads share corners, but not
/// sides: building takes less of a frame's time then, and rays a little more.
SurfaceBvh::Part::Part(const Surface& surface, In<std::uint8_t> reach, std::uint8_t of) : is_whole(reach.empty()) {
    const bool few = surface.occluding_triangles < many;
    const Index most = few ? 4 : 8;
    const int least_shared = few ? 2 : 1;
    patches = parallel_collect<Patch>(surface.occluding_triangles, 1 << 14, [&](auto begin, auto end, auto& found) {
        for (auto i = static_cast<Index>(begin); i < end; ++i) {
            if (!reach.empty() && reach[i] != of) continue;
            const auto shares = [&](Index j) {
                return shared_corners(surface.triangles[j], surface.triangles[i]) >= least_shared;
            };
            bool belongs = false;
            if (!found.empty() && found.back().end == i && i - found.back().begin < most)
                for (Index j = found.back().begin; j < i && !belongs; ++j) belongs = shares(j);
            if (belongs)
                found.back().end = i + 1;
            else
                found.push_back({i, i + 1});
        }
    });
}

void SurfaceBvh::Part::build(const Surface& surface, bool moves) {
    scene.reset(rtcNewScene(bvh_device()));
    if (moves) rtcSetSceneFlags(scene.get(), RTC_SCENE_FLAG_DYNAMIC);
    geometry = attach_boxes(scene.get(), patches.size(), box_of, meet, this);
    if (moves || surface.occluding_triangles >= some) {
        rtcSetSceneBuildQuality(scene.get(), RTC_BUILD_QUALITY_LOW);  // Embree looks at that of geometries then
        rtcSetGeometryBuildQuality(geometry, moves ? RTC_BUILD_QUALITY_REFIT : RTC_BUILD_QUALITY_LOW);
        rtcCommitGeometry(geometry);
    }
    const Array<RTCBounds> kept = take(surface);
    build_bvh(scene.get(), surface.name());
}

Array<RTCBounds> SurfaceBvh::Part::take(const Surface& surface) {
    const auto around = [&](const Patch& patch) {
        Box box{vec3(infinity), vec3(-infinity)};
        for (Index i = patch.begin; i < patch.end; ++i)
            for (int k = 0; k < 3; ++k) {
                const vec3& corner = surface.positions[surface.triangles[i][k]];
                box = {glm::min(box.low, corner), glm::max(box.high, corner)};
            }
        return box;
    };
    positions = surface.positions.data();
    triangles = surface.triangles.data();
    center = dvec3(surface.center);
    double radius = surface.radius;
    if (!is_whole) {
        Box all{vec3(infinity), vec3(-infinity)};
        for (const Patch& patch : patches) {
            const Box box = around(patch);
            all = {glm::min(all.low, box.low), glm::max(all.high, box.high)};
        }
        center = 0.5 * (dvec3(all.low) + dvec3(all.high));
        radius = 0.5 * glm::distance(dvec3(all.low), dvec3(all.high));
    }
    scale = 1.0 / std::max(radius, std::numeric_limits<double>::min());
    Array<RTCBounds> made = parallel_map<RTCBounds>(patches.size(), [&](std::size_t i) {
        const Box box = around(patches[i]);
        return box_between((dvec3(box.low) - center) * scale, (dvec3(box.high) - center) * scale, 1.0);
    });
    boxes = made.data();
    return made;
}

void SurfaceBvh::build(const Surface& surface) const {
    hash_ = 0;  // of no triangles, until it is built
    parts_.clear();
    const Array<std::uint8_t> reach = reach_of_triangles(surface);
    const int most = reach.empty() ? 0 : *std::ranges::max_element(reach);
    for (int of = 0; of <= most; ++of) {
        parts_.emplace_back(surface, reach, static_cast<std::uint8_t>(of));
        if (parts_.back().patches.empty())
            parts_.pop_back();
        else
            parts_.back().build(surface, moves_);
    }
    if (!moves_) return;
    hash_ = hash_of_triangles(surface);
    neighbors_ = neighbors(surface);
    spread_ = spread(surface, neighbors_);
}

void SurfaceBvh::follow(const Surface& surface) const {
    const std::lock_guard lock(mutex_);
    if (version_ == surface.version()) return;
    // Isolated: a thread that waits for others in here takes no task that waits for this lock.
    tbb::this_task_arena::isolate([&] {
        if (moves_ && hash_of_triangles(surface) == hash_ && spread(surface, neighbors_) <= worst_spread * spread_ &&
            parts_.size() == 1 && parts_.front().is_whole && reach_of_triangles(surface).empty()) {
            Part& all = parts_.front();
            const Array<RTCBounds> boxes = all.take(surface);
            rtcCommitGeometry(all.geometry);
            commit(all.scene.get());
            check_bvh_device(surface.name());
        } else {
            moves_ = true;
            build(surface);
        }
    });
    version_ = surface.version();
}

void SurfaceBvh::lead(RayContext& context) const {
    const dvec3 along = context.local.direction;
    const double longest = std::abs(along[context.local.z]), length_squared = glm::dot(along, along);
    for (const Part& part : parts_) {
        // The ray begins where it can first meet the sphere around the part.
        const dvec3 way = part.center - context.local.origin;
        const double radius = 1.0 / part.scale;
        context.first_t = std::max(context.near_t, glm::dot(way, along) / length_squared - radius / longest);
        context.longest = longest * part.scale;
        RTCRayHit ray = ray_through_boxes((context.first_t * along - way) * part.scale, along * part.scale, 0.0,
                                          context.far_t - context.first_t);
        follow_ray(part.scene.get(), ray, context);
    }
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
    *at->bounds_o = static_cast<const Part*>(at->geometryUserPtr)->boxes[at->primID];
}

void SurfaceBvh::meet(const RTCIntersectFunctionNArguments* at) {
    const Part& of = *static_cast<const Part*>(at->geometryUserPtr);
    auto& context = *static_cast<RayContext*>(at->context);
    const double before = context.far_t;
    const Patch& patch = of.patches[at->primID];
    for (Index i = patch.begin; i < patch.end; ++i) meet(context, of.positions, of.triangles[i], i);
    if (context.far_t != before)
        RTCRayN_tfar(RTCRayHitN_RayN(at->rayhit, 1), 1, 0) =
            end_of_ray(context.far_t - context.first_t, context.longest);
}

}  // namespace fovea::scene
