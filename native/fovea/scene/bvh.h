// SPDX-License-Identifier: GPL-3.0-or-later
// Two levels of BVHs of Embree: one per surface, and one over the placements of a view. Only for scene/bvh*.cpp and the
// tracer.
//
// Embree finds the boxes that a ray passes. Whether and where the ray meets a triangle is decided here, in double
// precision; of equally near hits, by placement and triangle. So boxes need only be large enough, and what a ray meets
// depends neither on how a BVH came to be, nor on the version of Embree and the instructions that it uses.
#pragma once

#include <deque>
#include <mutex>

#include <fovea/scene/bvh_embree.h>
#include <fovea/scene/ray_triangle.h>
#include <fovea/scene/tracer.h>

namespace fovea::scene {

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

/// A geometry of `count` boxes, committed and attached to the scene, which owns it. `box` tells them, and `meet`, if
/// given, what a ray that passes one does; both are handed `user`.
RTCGeometry attach_boxes(RTCScene scene, std::size_t count, RTCBoundsFunction box, RTCIntersectFunctionN meet,
                         const void* user);
/// Box of what lies between `lower` and `upper`, larger by a share of `size` that exceeds what Embree's single
/// precision errs by, for rays that begin within a few times `size`.
RTCBounds box_between(const dvec3& lower, const dvec3& upper, double size);
/// Embree's ray, of no hit. `along` is scaled to a longest component of 1, and t with it.
RTCRayHit ray_through_boxes(const dvec3& from, const dvec3& along, double near_t, double far_t);
/// Largest t of Embree's ray for a hit at `t` of one whose longest component is `longest`.
float end_of_ray(double t, double longest);

struct RayContext;

/// BVH over the occluding triangles of a surface. Borrows the surface's arrays and is stored in its lasting cache.
/// Built with Embree's default quality, or by Morton order where the surface is large; once it has moved, in a mode
/// that can be refitted. When vertices move with `refit`, it is refitted, or rebuilt if the triangles differ or have
/// moved so much relative to each other that the refitted boxes would overlap too much.
///
/// Triangles that reach far beyond most others, as at a vertex that was flung away, are parts of their own: boxes are
/// as precise as a part is large, and rays would pass all of them.
class SurfaceBvh {
   public:
    explicit SurfaceBvh(const Surface& surface);

    /// Updates the BVH to the surface's current positions. Affects existing tracers, too.
    void follow(const Surface& surface) const;
    /// Leads the context's ray through the triangles; it is in object space.
    void lead(RayContext& context) const;
    /// Leads it to one of them alone.
    static void lead_to(Index triangle, RayContext& context);

   private:
    /// What has a box: a few adjacent triangles.
    struct Patch {
        Index begin, end;
    };
    /// Triangles with a BVH of their own, and what callbacks read.
    struct Part {
        const bool is_whole;  // all of the surface
        Array<Patch> patches;
        const vec3* positions = nullptr;
        const Triangle* triangles = nullptr;
        dvec3 center{0.0};  // of the space of boxes, in which all is within 1 of the origin
        double scale = 1.0;
        const RTCBounds* boxes = nullptr;  // of patches, while it is built: builders ask for each several times
        OwnedScene scene;
        RTCGeometry geometry = nullptr;  // owned by the scene

        Part(const Surface& surface, In<std::uint8_t> reach, std::uint8_t of);
        /// Sets what callbacks read; of it, the boxes as long as they are kept.
        Array<RTCBounds> take(const Surface& surface);
        void build(const Surface& surface, bool moves);
    };
    static void box_of(const RTCBoundsFunctionArguments* at);
    static void meet(const RTCIntersectFunctionNArguments* at);
    static void meet(RayContext& context, const vec3* positions, const Triangle& corners, Index triangle);

    void build(const Surface& surface) const;

    mutable std::deque<Part> parts_;  // callbacks have their addresses
    mutable std::mutex mutex_;
    mutable bool moves_ = false;  // follow() has found moved vertices before
    // surface version; hash of the triangles and of the arrays' addresses
    mutable std::uint64_t version_ = 0, hash_ = 0;
    mutable Array<Index> neighbors_;  // sampled triangles, in Morton order when built
    mutable double spread_ = 0.0;     // spread() of these when built
};

/// A surface's BVH, at its current positions; cached with the surface.
std::shared_ptr<const SurfaceBvh> bvh_of(const Surface& surface);

struct Tracer::Bvh {
    struct Instance {
        Index placement;
        const SurfaceBvh* surface;
        glm::dmat4x3 view_to_object;
    };
    /// A surface, kept as long as the tracer, and its version when the tracer was made.
    struct Version {
        const Surface* surface;
        std::uint64_t version;
        std::shared_ptr<const SurfaceBvh> bvh;
    };
    const Scene& scene;
    OwnedScene top;
    Array<dmat4> object_to_view;      // per placement
    std::vector<Instance> instances;  // by placement
    std::vector<Version> surfaces;    // by address
    const bool all_around;            // rays begin anywhere, not at the eye
    double size = 0.0;                // greatest coordinate of what is around

    Bvh(const Scene& of, bool from_anywhere);
    /// The placements `hiding` hide, and are all that rays meet.
    void build(const Array<Index>& hiding);
    void lead(RayContext& context) const;
    /// The first of the hits that are not ignored.
    std::optional<Hit> trace(const Ray& ray, const Ignore& ignore) const;
    /// Whether there is one before the end of the ray, which may begin anywhere. `last`: asked first, and told.
    bool is_blocked(Ray ray, const Ignore& ignore, Blocker& last) const;
    /// The first if the ray meets that placement at all, which is quick to tell; else nothing.
    std::optional<Hit> trace_if_of(Index placement, const Ray& ray, const Ignore& ignore) const;
};

/// A ray on its way, as Embree hands it from box to box.
struct RayContext : QueryContext {
    const Tracer::Bvh& bvh;
    const Ignore& ignore;
    const dvec3 origin, direction;  // view space
    const double near_t;
    double far_t;          // hits beyond are of no interest
    const double reach_t;  // ignore.reach as a share of the ray's length

    const Tracer::Bvh::Instance* instance = nullptr;  // where the ray is, and the ray in object space
    Index placement = none;
    const Surface* surface = nullptr;
    ShearedRay local;
    double first_t = 0.0, longest = 1.0;  // ray parameter at the begin of Embree's ray, and its t per ray parameter

    RayContext(const Tracer::Bvh& of, const Ray& ray, const Ignore& skipped);
    virtual ~RayContext() = default;
    /// Takes the ray to the space of an instance; false if it has no direction there.
    bool enter(const Tracer::Bvh::Instance& entered);
    /// Leads the ray through an instance. Whether that shortened it.
    bool pass(const Tracer::Bvh::Instance& entered);
    /// The ray meets a triangle between near_t and far_t. May shorten the ray.
    virtual void meet(Index triangle, const TriangleHit& hit) = 0;

    /// The ray's direction times the normal of a triangle: positive where it meets the back. In object space, where
    /// winding tells the sides apart.
    double along_normal(Index triangle) const;
    bool ignored(Index triangle, double t) const;
};

}  // namespace fovea::scene
