// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/scene/bvh.h>

#include <cmath>

namespace fovea::scene {
namespace {

void skip_ignored(const RTCFilterFunctionNArguments* at) {
    if (static_cast<const RayContext*>(at->context)->ignored(*at)) at->valid[0] = 0;
}

}  // namespace

std::shared_ptr<const SurfaceBvh> bvh_of(const Surface& surface) {
    const auto kept = surface.lasting_cache().get<std::unique_ptr<const SurfaceBvh>>(
        0, [&] { return std::make_unique<const SurfaceBvh>(surface); });
    (*kept)->follow(surface);
    return {kept, kept->get()};
}

Tracer::Bvh::Bvh() : top(rtcNewScene(bvh_device())) { rtcSetSceneFlags(top.get(), bvh_flags); }

void Tracer::Bvh::add(const Scene& scene, Index placement) {
    const Surface& surface = *scene.placements[placement].surface;
    surfaces.push_back(bvh_of(surface));
    const RTCGeometry instance = rtcNewGeometry(bvh_device(), RTC_GEOMETRY_TYPE_INSTANCE);
    rtcSetGeometryInstancedScene(instance, surfaces.back()->scene());
    rtcSetGeometryTimeStepCount(instance, 1);
    const mat4 transform(object_to_view[placement]);
    rtcSetGeometryTransform(instance, 0, RTC_FORMAT_FLOAT4X4_COLUMN_MAJOR, &transform[0][0]);
    rtcCommitGeometry(instance);
    rtcAttachGeometryByID(top.get(), instance, static_cast<unsigned>(placement_of_instance.size()));
    rtcReleaseGeometry(instance);
    placement_of_instance.push_back(placement);
    any_one_sided |= surface.two_sided_triangles < surface.occluding_triangles;
    versions.push_back(surface.version());
}

void Tracer::Bvh::commit() { build_bvh(top.get(), "scene"); }

std::optional<Hit> Tracer::Bvh::trace(const Scene& scene, const Ray& ray, const Ignore& ignore) const {
    RayContext context(scene, placement_of_instance, ray, ignore);
    RTCRayHit found{embree_ray(ray), {}};
    found.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    found.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    find_nearest(top.get(), found, context, ignore.placement != none || any_one_sided ? skip_ignored : nullptr);
    if (found.hit.geomID == RTC_INVALID_GEOMETRY_ID) return {};
    return Hit{placement_of_instance[found.hit.instID[0]], found.hit.primID, found.ray.tfar, found.hit.u, found.hit.v};
}

RayContext::RayContext(const Scene& of, const Array<Index>& placements, const Ray& ray, const Ignore& skipped)
    : scene(of),
      placement_of_instance(placements),
      ignore(skipped),
      reach_t(skipped.reach > 0.0f ? skipped.reach / glm::length(ray.direction) : 0.0f) {
    init_context(*this);
}

bool RayContext::ignored(const RTCFilterFunctionNArguments& at) const {
    const Index hit = placement(at);
    const float before = 1.0f - RTCRayN_tfar(at.ray, 1, 0);
    const Surface& surface = *scene.placements[hit].surface;
    const Index triangle = RTCHitN_primID(at.hit, 1, 0);
    if (hit == ignore.placement && std::abs(before) < reach_t &&
        (before < 0.0f || ignore.is_own(surface.triangle_facet[triangle])))
        return true;
    if (triangle >= surface.two_sided_triangles && along_normal(at) > 0.0f) return true;
    return ignore.holds(hit, surface, triangle);
}

float along_normal(const RTCFilterFunctionNArguments& at) {
    return RTCHitN_Ng_x(at.hit, 1, 0) * RTCRayN_dir_x(at.ray, 1, 0) +
           RTCHitN_Ng_y(at.hit, 1, 0) * RTCRayN_dir_y(at.ray, 1, 0) +
           RTCHitN_Ng_z(at.hit, 1, 0) * RTCRayN_dir_z(at.ray, 1, 0);
}

RTCRay embree_ray(const Ray& ray) {
    const vec3 &from = ray.origin, &along = ray.direction;
    // Origin, near end; direction, time; far end, mask; id, flags.
    return {from.x, from.y, from.z, ray.near_t, along.x, along.y, along.z, 0.0f, ray.far_t, ~0u, 0, 0};
}

}  // namespace fovea::scene
