// Two levels of Embree: one BVH per surface, instanced under one per view. For scene/bvh*.cpp and the tracer alone.
#pragma once

#include <embree4/rtcore.h>

#include "scene/tracer.h"

namespace fovea {

/// BVH over the occluding triangles of a surface; borrows the surface's arrays, whose cache it lives in.
struct SurfaceBvh {
    RTCScene scene = nullptr;

    explicit SurfaceBvh(const Surface& surface);
    ~SurfaceBvh() { rtcReleaseScene(scene); }
    SurfaceBvh(SurfaceBvh&& other) noexcept : scene(std::exchange(other.scene, nullptr)) {}
    SurfaceBvh(const SurfaceBvh&) = delete;
    SurfaceBvh& operator=(const SurfaceBvh&) = delete;
};

struct Tracer::Bvh {
    RTCScene top = nullptr;
    Array<Index> placement_of_instance;
    Array<std::uint64_t> versions;  // of the surfaces, per instance
    Array<dmat4> object_to_view;    // per placement
    std::vector<std::shared_ptr<const SurfaceBvh>> surfaces;

    Bvh();
    ~Bvh() { rtcReleaseScene(top); }
    Bvh(const Bvh&) = delete;
    Bvh& operator=(const Bvh&) = delete;

    void add(const Scene& scene, Index placement);
    void commit();
    std::optional<Hit> trace(const Scene& scene, const Ray& ray, const Ignore& ignore) const;
};

/// What a filter needs to know of the ray it filters for.
struct RayContext : RTCRayQueryContext {
    const Scene& scene;
    const Array<Index>& placement_of_instance;
    const Ignore& ignore;
    float reach_t;  // the ignore's reach as a share of the ray

    RayContext(const Scene& scene, const Array<Index>& placements, const Ray& ray, const Ignore& ignore);
    /// The placement that was hit, and whether the hit is to be ignored.
    Index placement(const RTCFilterFunctionNArguments& at) const {
        return placement_of_instance[RTCHitN_instID(at.hit, 1, 0, 0)];
    }
    bool ignored(const RTCFilterFunctionNArguments& at) const;
};

/// The ray as Embree takes it.
RTCRay embree_ray(const Ray& ray);

}  // namespace fovea
