// SPDX-License-Identifier: GPL-3.0-or-later
// Number of surfaces along a ray, counted in Embree's filter functions.
#include <algorithm>
#include <tuple>

#include <fovea/scene/bvh.h>

namespace fovea::scene {
namespace {

/// A hit, with the component that it is on. For open shells the two directions are not distinguished.
struct Met {
    Hit hit;
    Index body;
    bool leaves;  ///< the ray leaves a solid here
};

bool before(const Met& a, const Met& b) {
    return std::tie(a.hit.placement, a.body, a.leaves, a.hit.t) < std::tie(b.hit.placement, b.body, b.leaves, b.hit.t);
}

/// Calls found(hit) for a maximal subset of the sorted hits whose distances differ by more than ray_margin. Adding hits
/// never makes the subset smaller.
template <typename Iterator, typename Found>
void apart(Iterator begin, Iterator end, const Found& found) {
    float last = -1.0f;
    for (; begin != end; ++begin) {
        if (begin->hit.t - last <= static_cast<float>(ray_margin)) continue;
        last = begin->hit.t;
        found(begin->hit);
    }
}

/// Calls found(hit) once per surface among the sorted hits: for a solid, as often as the ray enters it or leaves it,
/// whichever is more (the near plane may cut it open, or the eye may be inside); for an open shell, as often as the ray
/// crosses it.
template <typename Found>
void each_surface(const std::vector<Met>& met, const Found& found) {
    for (auto begin = met.begin(); begin != met.end();) {
        const auto other = [&](const Met& m) {
            return m.hit.placement != begin->hit.placement || m.body != begin->body;
        };
        const auto end = std::find_if(begin, met.end(), other);
        const auto leaving = std::find_if(begin, end, [](const Met& m) { return m.leaves; });
        int enters = 0, leaves = 0;
        apart(begin, leaving, [&](const Hit&) { ++enters; });
        apart(leaving, end, [&](const Hit&) { ++leaves; });
        if (enters >= leaves)
            apart(begin, leaving, found);
        else
            apart(leaving, end, found);
        begin = end;
    }
}

}  // namespace

/// Collects all hits along the ray: the filter rejects each, so that traversal continues, until `most` surfaces are
/// counted.
struct Tracer::Count : RayContext {
    const Tracer& tracer;
    const SceneBodies& bodies;
    const Ray& ray;
    int most, count = 0;
    std::vector<Met> met;

    static void filter(const RTCFilterFunctionNArguments* at) {
        auto& self = *static_cast<Count*>(at->context);
        if (self.count < self.most && !self.ignored(*at)) self.add(*at);
        if (self.count < self.most) at->valid[0] = 0;
    }

    void add(const RTCFilterFunctionNArguments& at) {
        const Hit hit{placement(at), RTCHitN_primID(at.hit, 1, 0), RTCRayN_tfar(at.ray, 1, 0)};
        if (!tracer.surely_before(hit, ray)) return;
        const Bodies& of = *bodies[hit.placement];
        const Index body = of.of_facet[scene.placements[hit.placement].surface->triangle_facet[hit.triangle]];
        const Met made{hit, body, of.solid[body] && along_normal(at) > 0.0f};
        met.insert(std::upper_bound(met.begin(), met.end(), made, before), made);
        count = 0;
        each_surface(met, [&](const Hit&) { ++count; });
    }
};

void Tracer::surfaces_before(const vec3& point, const Ignore& ignore, int most, const SceneBodies& bodies,
                             std::vector<Hit>& surfaces) const {
    surfaces.clear();
    const Ray ray = ray_to(point);
    if (most <= 0 || ray.far_t <= ray.near_t) return;
    Count counted{{scene_, bvh_->placement_of_instance, ray, ignore}, *this, bodies, ray, most, 0, {}};
    RTCRay made = embree_ray(ray);
    find_any(bvh_->top.get(), made, counted, Count::filter);
    each_surface(counted.met, [&](const Hit& hit) { surfaces.push_back(hit); });
}

}  // namespace fovea::scene
