// SPDX-License-Identifier: GPL-3.0-or-later
// Two-level BVH of Embree: one per surface, instanced in one per view. Only for scene/bvh*.cpp and the tracer.
#pragma once

#include <mutex>

#include <fovea/scene/bvh_embree.h>
#include <fovea/scene/tracer.h>

namespace fovea::scene {

/// Robust mode: no ray passes between two triangles that share a side.
inline const RTCSceneFlags bvh_flags = filtered_scene | RTC_SCENE_FLAG_ROBUST;

struct ReleaseScene {
    void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
};
using OwnedScene = std::unique_ptr<RTCSceneTy, ReleaseScene>;

/// The process-wide Embree device. Throws std::bad_alloc if it cannot be made.
RTCDevice bvh_device();
/// If Embree has reported an error since the last call: throws std::bad_alloc if memory is too small, Cancelled if it
/// was cancelled, else std::runtime_error, naming `what`.
void check_bvh_device(const std::string& what);
/// Builds a scene's BVH, polling the Cancel of the calling thread's scope, and checks the device. A scene whose build
/// was cancelled is not usable.
void build_bvh(RTCScene scene, const std::string& what);
/// Makes a geometry use the first `vertices` and `count` entries of these arrays, which are borrowed.
void share_triangles(RTCGeometry geometry, const Array<vec3>& positions, Index vertices,
                     const Array<Triangle>& triangles, Index count);

/// BVH over the occluding triangles of a surface. Borrows the surface's arrays and is stored in its lasting cache.
/// Built with Embree's default quality as long as the surface does not move, then in a mode that can be refitted. When
/// vertices move with `refit`, it is refitted, or rebuilt if the triangles differ or have moved so much relative to
/// each other that the refitted boxes would overlap too much.
class SurfaceBvh {
   public:
    explicit SurfaceBvh(const Surface& surface);

    /// Updates the BVH to the surface's current positions. Affects existing tracers, too.
    void follow(const Surface& surface) const;
    RTCScene scene() const { return scene_.get(); }

   private:
    void take_triangles(const Surface& surface) const;

    OwnedScene scene_;
    RTCGeometry geometry_;  // owned by scene_
    mutable std::mutex mutex_;
    mutable bool moves_ = false;  // follow() has found moved vertices before
    // surface version; hash of the triangles and of the arrays' addresses
    mutable std::uint64_t version_ = 0, triangles_ = 0;
    mutable Array<Index> neighbors_;  // sampled triangles, in Morton order when built
    mutable double spread_ = 0.0;     // spread() of these when built
};

/// A surface's BVH, at its current positions; cached with the surface.
std::shared_ptr<const SurfaceBvh> bvh_of(const Surface& surface);

struct Tracer::Bvh {
    OwnedScene top;
    Array<Index> placement_of_instance;
    Array<std::uint64_t> versions;  // of the surfaces, per instance
    Array<dmat4> object_to_view;    // per placement
    std::vector<std::shared_ptr<const SurfaceBvh>> surfaces;
    bool any_one_sided = false;  // rays pass through the backs of some triangles

    Bvh();
    void add(const Scene& scene, Index placement);
    void commit();
    std::optional<Hit> trace(const Scene& scene, const Ray& ray, const Ignore& ignore) const;
};

/// Context that Embree passes to filter functions.
struct RayContext : QueryContext {
    const Scene& scene;
    const Array<Index>& placement_of_instance;
    const Ignore& ignore;
    float reach_t;  // ignore.reach as a share of the ray's length

    RayContext(const Scene& scene, const Array<Index>& placements, const Ray& ray, const Ignore& ignore);
    /// Placement that was hit; and whether the hit is ignored.
    Index placement(const RTCFilterFunctionNArguments& at) const {
        return placement_of_instance[RTCHitN_instID(at.hit, 1, 0, 0)];
    }
    bool ignored(const RTCFilterFunctionNArguments& at) const;
};

/// The ray's direction times the normal of what it hit: positive where it hits the back. Both in object space, where
/// winding tells the sides apart.
float along_normal(const RTCFilterFunctionNArguments& at);

/// Converts to Embree's ray.
RTCRay embree_ray(const Ray& ray);

}  // namespace fovea::scene
