#include "scene/bvh.h"

#include <cmath>
#include <stdexcept>
#include <string>

namespace fovea {
namespace {

RTCDevice device() {
    // Lives as long as the process: Embree's threads may still run when statics are torn down.
    static const RTCDevice shared = [] {
        // The same instructions wherever there are wider ones, too: frames of one film are rendered on many machines.
        const RTCDevice made = rtcNewDevice("max_isa=avx2");
        if (!made) throw std::runtime_error("Embree could not be started on this machine");
        return made;
    }();
    return shared;
}

void check_device(const std::string& what) {
    const RTCError error = rtcGetDeviceError(device());
    if (error != RTC_ERROR_NONE) throw std::runtime_error(what + ": Embree error " + std::to_string(error));
}

/// Robust: no ray slips between two triangles that share a side.
const RTCSceneFlags scene_flags = RTC_SCENE_FLAG_FILTER_FUNCTION_IN_ARGUMENTS | RTC_SCENE_FLAG_ROBUST;

void skip_ignored(const RTCFilterFunctionNArguments* at) {
    if (static_cast<const RayContext*>(at->context)->ignored(*at)) at->valid[0] = 0;
}

}  // namespace

SurfaceBvh::SurfaceBvh(const Surface& surface) : scene(rtcNewScene(device())) {
    const RTCGeometry geometry = rtcNewGeometry(device(), RTC_GEOMETRY_TYPE_TRIANGLE);
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, surface.positions.data(), 0,
                               sizeof(vec3), surface.vertex_count());
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, surface.triangles.data(), 0,
                               sizeof(Triangle), surface.occluding_triangles);
    rtcSetGeometryEnableFilterFunctionFromArguments(geometry, true);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene, geometry);
    rtcReleaseGeometry(geometry);
    rtcSetSceneFlags(scene, scene_flags | RTC_SCENE_FLAG_COMPACT);
    rtcCommitScene(scene);
    check_device(surface.name());
}
Tracer::Bvh::Bvh() : top(rtcNewScene(device())) { rtcSetSceneFlags(top, scene_flags); }

void Tracer::Bvh::add(const Scene& scene, Index placement) {
    const Surface& surface = *scene.placements[placement].surface;
    surfaces.push_back(surface.cache().get<SurfaceBvh>(0, [&] { return SurfaceBvh(surface); }));
    const RTCGeometry instance = rtcNewGeometry(device(), RTC_GEOMETRY_TYPE_INSTANCE);
    rtcSetGeometryInstancedScene(instance, surfaces.back()->scene);
    rtcSetGeometryTimeStepCount(instance, 1);
    const mat4 transform(object_to_view[placement]);
    rtcSetGeometryTransform(instance, 0, RTC_FORMAT_FLOAT4X4_COLUMN_MAJOR, &transform[0][0]);
    rtcCommitGeometry(instance);
    rtcAttachGeometryByID(top, instance, static_cast<unsigned>(placement_of_instance.size()));
    rtcReleaseGeometry(instance);
    placement_of_instance.push_back(placement);
    versions.push_back(surface.version());
}

void Tracer::Bvh::commit() {
    rtcCommitScene(top);
    check_device("scene");
}

std::optional<Hit> Tracer::Bvh::trace(const Scene& scene, const Ray& ray, const Ignore& ignore) const {
    RayContext context(scene, placement_of_instance, ray, ignore);
    RTCIntersectArguments arguments;
    rtcInitIntersectArguments(&arguments);
    arguments.context = &context;
    if (ignore.placement != none) {
        arguments.flags = RTC_RAY_QUERY_FLAG_INVOKE_ARGUMENT_FILTER;
        arguments.filter = skip_ignored;
    }
    RTCRayHit found{embree_ray(ray), {}};
    found.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    found.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(top, &found, &arguments);
    if (found.hit.geomID == RTC_INVALID_GEOMETRY_ID) return {};
    return Hit{placement_of_instance[found.hit.instID[0]], found.hit.primID, found.ray.tfar, found.hit.u, found.hit.v};
}

RayContext::RayContext(const Scene& of, const Array<Index>& placements, const Ray& ray, const Ignore& skipped)
    : scene(of),
      placement_of_instance(placements),
      ignore(skipped),
      reach_t(skipped.reach > 0.0f ? skipped.reach / glm::length(ray.direction) : 0.0f) {
    rtcInitRayQueryContext(this);
}

bool RayContext::ignored(const RTCFilterFunctionNArguments& at) const {
    const Index hit = placement(at);
    const float before = 1.0f - RTCRayN_tfar(at.ray, 1, 0);
    if (hit == ignore.placement && std::abs(before) < reach_t) return true;
    return ignore.holds(hit, *scene.placements[hit].surface, RTCHitN_primID(at.hit, 1, 0));
}

RTCRay embree_ray(const Ray& ray) {
    RTCRay made{};
    made.org_x = ray.origin.x;
    made.org_y = ray.origin.y;
    made.org_z = ray.origin.z;
    made.dir_x = ray.direction.x;
    made.dir_y = ray.direction.y;
    made.dir_z = ray.direction.z;
    made.tnear = ray.near_t;
    made.tfar = ray.far_t;
    made.mask = ~0u;
    return made;
}

}  // namespace fovea
