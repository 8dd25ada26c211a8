// SPDX-License-Identifier: GPL-3.0-or-later
// Two levels of Embree: one BVH per surface, instanced under one per view. For scene/bvh*.cpp and the tracer alone.
#pragma once

#include <embree4/rtcore.h>
#include <mutex>

#include <fovea/scene/tracer.h>

namespace fovea::scene {

/// Robust: no ray slips between two triangles that share a side.
inline const RTCSceneFlags bvh_flags = RTC_SCENE_FLAG_FILTER_FUNCTION_IN_ARGUMENTS | RTC_SCENE_FLAG_ROBUST;

struct ReleaseScene {
    void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
};
using OwnedScene = std::unique_ptr<RTCSceneTy, ReleaseScene>;

/// The one Embree device.
RTCDevice bvh_device();
/// Throws std::runtime_error, naming `what`, where Embree has failed since.
void check_bvh_device(const std::string& what);
/// Lets a geometry borrow the first of these vertices and triangles.
void share_triangles(RTCGeometry geometry, const Array<vec3>& positions, Index vertices,
                     const Array<Triangle>& triangles, Index count);

/// BVH over the occluding triangles of a surface; borrows the surface's arrays, in whose lasting cache it lives. A
/// surface that never moves has the best for rays. Where vertices moved with `refit` it is refitted, and built anew
/// only if the triangles are others, or lie so differently that its boxes no longer keep them apart.
class SurfaceBvh {
   public:
    explicit SurfaceBvh(const Surface& surface);

    /// Follows the surface to where it is now. Tracers made before see it move.
    void follow(const Surface& surface) const;
    RTCScene scene() const { return scene_.get(); }

   private:
    void take_triangles(const Surface& surface) const;

    OwnedScene scene_;
    RTCGeometry geometry_;  // the scene's
    mutable std::mutex mutex_;
    mutable bool moves_ = false;                         // it has followed once
    mutable std::uint64_t version_ = 0, triangles_ = 0;  // of the surface; hash of contents and place
    mutable Array<Index> neighbors_;                     // some triangles, in an order in which they lay side by side
    mutable double spread_ = 0.0;                        // of the neighbors, when built
};

struct Tracer::Bvh {
    OwnedScene top;
    Array<Index> placement_of_instance;
    Array<std::uint64_t> versions;  // of the surfaces, per instance
    Array<dmat4> object_to_view;    // per placement
    std::vector<std::shared_ptr<const SurfaceBvh>> surfaces;

    Bvh();
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

}  // namespace fovea::scene
