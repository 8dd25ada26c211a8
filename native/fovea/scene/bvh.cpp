// SPDX-License-Identifier: GPL-3.0-or-later
// The BVH over placements, and the nearest hit.
#include <fovea/scene/bvh.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <tuple>

#include <fovea/base/parallel.h>

namespace fovea::scene {
namespace {

/// See box_between. Rays begin within 2 sizes of the boxes' center and end within 2 more; Embree's distances to the
/// sides of a box err by four units in the last place.
constexpr double margin = 0x1p-18;

struct Nearest final : RayContext {
    using RayContext::RayContext;
    std::optional<Hit> found;

    void meet(Index triangle, const TriangleHit& hit) override {
        const bool nearer =
            hit.t < far_t || (found && std::tie(placement, triangle) < std::tie(found->placement, found->triangle));
        if (!nearer || ignored(triangle, hit.t)) return;
        found = Hit{placement, triangle, hit.t, float(hit.u), float(hit.v)};
        far_t = hit.t;
    }
};

/// Ends at the first hit before the end of the ray.
struct Blocked final : RayContext {
    using RayContext::RayContext;
    Blocker found;

    void meet(Index triangle, const TriangleHit& hit) override {
        if (found.triangle != none || hit.t >= far_t || ignored(triangle, hit.t)) return;
        found = {Index(instance - bvh.instances.data()), triangle};
        far_t = near_t;
    }
};

/// A box in view space around a placement.
struct Around {
    dvec3 center, half{0.0};

    Around(const Tracer::Bvh& bvh, Index placement) {
        const Surface& surface = *bvh.scene.placements[placement].surface;
        const dmat4& to_view = bvh.object_to_view[placement];
        center = dvec3(to_view * dvec4(dvec3(surface.center), 1.0));
        for (int k = 0; k < 3; ++k) half += glm::abs(dvec3(to_view[k])) * double(surface.half[k]);
    }
    double farthest() const {
        const dvec3 size = glm::abs(center) + half;
        return std::max({size.x, size.y, size.z});
    }
};

void box_of_instance(const RTCBoundsFunctionArguments* at) {
    const auto& bvh = *static_cast<const Tracer::Bvh*>(at->geometryUserPtr);
    const Around around(bvh, bvh.instances[at->primID].placement);
    const double size = bvh.all_around ? bvh.size : around.farthest();
    *at->bounds_o = box_between(around.center - around.half, around.center + around.half, size);
}

/// Leads the ray through an instance whose box it passes.
void pass_instance(const RTCIntersectFunctionNArguments* at) {
    auto& context = *static_cast<RayContext*>(at->context);
    if (!context.pass(context.bvh.instances[at->primID])) return;
    const dvec3 size = glm::abs(context.direction);
    RTCRayN_tfar(RTCRayHitN_RayN(at->rayhit, 1), 1, 0) = end_of_ray(context.far_t, std::max({size.x, size.y, size.z}));
}

}  // namespace

RTCGeometry attach_boxes(RTCScene scene, std::size_t count, RTCBoundsFunction box, RTCIntersectFunctionN meet,
                         const void* user) {
    const RTCGeometry geometry = rtcNewGeometry(bvh_device(), RTC_GEOMETRY_TYPE_USER);
    rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned>(count));
    rtcSetGeometryUserData(geometry, const_cast<void*>(user));
    rtcSetGeometryBoundsFunction(geometry, box, nullptr);
    if (meet) rtcSetGeometryIntersectFunction(geometry, meet);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene, geometry);
    rtcReleaseGeometry(geometry);
    return geometry;
}

RTCBounds box_between(const dvec3& lower, const dvec3& upper, double size) {
    const vec3 low(lower - margin * size), high(upper + margin * size);
    return {low.x, low.y, low.z, 0.0f, high.x, high.y, high.z, 0.0f};
}

RTCRayHit ray_through_boxes(const dvec3& from, const dvec3& along, double near_t, double far_t) {
    const dvec3 size = glm::abs(along);
    const double longest = std::max({size.x, size.y, size.z});
    const vec3 begin(from), way(along * (1.0 / longest));
    RTCRayHit ray{};
    // Origin, near end; direction, time; far end, mask; id, flags.
    ray.ray = {begin.x, begin.y, begin.z, -end_of_ray(-near_t, longest), way.x,
               way.y,   way.z,   0.0f,    end_of_ray(far_t, longest),    ~0u,
               0,       0};
    ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    ray.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    return ray;
}

float end_of_ray(double t, double longest) {
    constexpr float least = std::numeric_limits<float>::min();  // so that it is at least the next number
    const float end = float(t * longest);
    return end + std::max(std::abs(end) * std::numeric_limits<float>::epsilon(), least);
}

std::shared_ptr<const SurfaceBvh> bvh_of(const Surface& surface) {
    const auto kept = surface.lasting_cache().get<std::unique_ptr<const SurfaceBvh>>(
        0, [&] { return std::make_unique<const SurfaceBvh>(surface); });
    (*kept)->follow(surface);
    return {kept, kept->get()};
}

Tracer::Bvh::Bvh(const Scene& of, bool from_anywhere)
    : scene(of), top(rtcNewScene(bvh_device())), all_around(from_anywhere) {}

void Tracer::Bvh::build(const Array<Index>& hiding) {
    const auto surface_of = [&](Index placement) { return scene.placements[placement].surface.get(); };
    for (const Index i : hiding) surfaces.push_back({surface_of(i), 0, nullptr});
    std::ranges::sort(surfaces, {}, &Version::surface);
    const auto [first, last] = std::ranges::unique(surfaces, {}, &Version::surface);
    surfaces.erase(first, last);
    parallel_for(surfaces.size(), 1, [&](std::size_t i) {
        surfaces[i].bvh = bvh_of(*surfaces[i].surface);
        surfaces[i].version = surfaces[i].surface->version();
    });
    instances.resize(hiding.size());
    parallel_for(hiding.size(), 4096, [&](std::size_t i) {
        const auto at = std::ranges::lower_bound(surfaces, surface_of(hiding[i]), {}, &Version::surface);
        instances[i] = {hiding[i], at->bvh.get(), glm::dmat4x3(glm::inverse(object_to_view[hiding[i]]))};
    });
    if (all_around)
        for (const Index i : hiding) size = std::max(size, Around(*this, i).farthest());
    attach_boxes(top.get(), instances.size(), box_of_instance, pass_instance, this);
    build_bvh(top.get(), "scene");
}

void Tracer::Bvh::lead(RayContext& context) const {
    if (instances.size() == 1) {  // it need not be found among others
        context.pass(instances.front());
        return;
    }
    RTCRayHit ray = ray_through_boxes(context.origin, context.direction, context.near_t, context.far_t);
    follow_ray(top.get(), ray, context);
}

std::optional<Hit> Tracer::Bvh::trace(const Ray& ray, const Ignore& ignore) const {
    Nearest nearest(*this, ray, ignore);
    lead(nearest);
    return nearest.found;
}

bool Tracer::Bvh::is_blocked(Ray ray, const Ignore& ignore, Blocker& last) const {
    // It begins no farther away than where it meets a sphere around all, as boxes are large enough for such rays.
    const double length = glm::length(ray.direction), radius = std::numbers::sqrt3 * size;
    const double first = -glm::dot(ray.origin, ray.direction) / (length * length) - radius / length;
    if (first > ray.near_t) {
        ray.origin += first * ray.direction;
        ray.near_t = 0.0;
        ray.far_t -= first;
    }
    if (!(ray.near_t < ray.far_t)) return false;
    Blocked blocked(*this, ray, ignore);
    if (last.instance != none && blocked.enter(instances[last.instance])) SurfaceBvh::lead_to(last.triangle, blocked);
    if (blocked.found.triangle == none) lead(blocked);
    if (blocked.found.triangle == none) return false;
    last = blocked.found;
    return true;
}

std::optional<Hit> Tracer::Bvh::trace_if_of(Index placement, const Ray& ray, const Ignore& ignore) const {
    const auto own = std::ranges::lower_bound(instances, placement, {}, &Instance::placement);
    if (own == instances.end() || own->placement != placement) return {};
    Nearest nearest(*this, ray, ignore);
    nearest.pass(*own);
    if (nearest.found) lead(nearest);
    return nearest.found;
}

RayContext::RayContext(const Tracer::Bvh& of, const Ray& ray, const Ignore& skipped)
    : bvh(of),
      ignore(skipped),
      origin(ray.origin),
      direction(ray.direction),
      near_t(ray.near_t),
      far_t(ray.far_t),
      reach_t(skipped.reach > 0.0f ? skipped.reach / glm::length(direction) : 0.0) {
    init_context(*this);
}

bool RayContext::enter(const Tracer::Bvh::Instance& entered) {
    instance = &entered;
    placement = entered.placement;
    surface = bvh.scene.placements[placement].surface.get();
    const glm::dmat4x3& to_object = entered.view_to_object;
    // The sums of glm's product of a matrix and a vector, which compilers do not inline.
    const auto turned = [&](const dvec3& v) { return to_object[0] * v.x + to_object[1] * v.y + to_object[2] * v.z; };
    const dvec3 along = turned(direction);
    if (along == dvec3(0.0)) return false;
    local = ShearedRay(turned(origin) + to_object[3], along);
    return true;
}

bool RayContext::pass(const Tracer::Bvh::Instance& entered) {
    if (!enter(entered)) return false;
    const double before = far_t;
    entered.surface->lead(*this);
    return far_t != before;
}

double RayContext::along_normal(Index triangle) const {
    return glm::dot(mesh::area_vector(surface->positions, surface->triangles[triangle]), local.direction);
}

bool RayContext::ignored(Index triangle, double t) const {
    const double before = 1.0 - t;
    if (placement == ignore.placement && std::abs(before) < reach_t &&
        (before < 0.0 || ignore.is_own(surface->triangle_facet[triangle])))
        return true;
    if (triangle >= surface->two_sided_triangles && along_normal(triangle) > 0.0) return true;
    return ignore.holds(placement, *surface, triangle);
}

}  // namespace fovea::scene
