// SPDX-License-Identifier: GPL-3.0-or-later
// Number of surfaces along a ray, whichever way it passes boxes.
#include <algorithm>
#include <iterator>
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
    const auto order = [](const Met& m) {
        return std::tie(m.hit.placement, m.body, m.leaves, m.hit.t, m.hit.triangle);
    };
    return order(a) < order(b);
}

/// Calls found(hit) for a maximal subset of the sorted hits whose distances differ by more than ray_margin. Adding hits
/// never makes the subset smaller.
template <typename Iterator, typename Found>
void apart(Iterator begin, Iterator end, const Found& found) {
    double last = -1.0;
    for (; begin != end; ++begin) {
        if (begin->hit.t - last <= ray_margin) continue;
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

/// Collects hits along the ray until `most` surfaces are counted, then only nearer ones: in the end there are all those
/// up to where that many are met, in whichever order boxes were passed.
struct Tracer::Count final : RayContext {
    const SceneBodies& bodies;
    const int most;
    std::vector<Met> met, nearer;  // sorted

    Count(const Bvh& of, const Ray& ray, const Ignore& skipped, const SceneBodies& in, int at_most)
        : RayContext(of, ray, skipped), bodies(in), most(at_most) {}

    void meet(Index triangle, const TriangleHit& hit) override {
        if (ignored(triangle, hit.t)) return;
        const Bodies& of = *bodies[placement];
        const Index body = of.of_facet[surface->triangle_facet[triangle]];
        const Met made{{placement, triangle, hit.t}, body, of.solid[body] && along_normal(triangle) > 0.0};
        met.insert(std::upper_bound(met.begin(), met.end(), made, before), made);
        while (count(met) >= most) {
            far_t = std::ranges::max(met, {}, [](const Met& m) { return m.hit.t; }).hit.t;
            nearer.clear();
            std::ranges::copy_if(met, std::back_inserter(nearer), [&](const Met& m) { return m.hit.t < far_t; });
            if (count(nearer) < most) break;
            met.swap(nearer);
        }
    }

    static int count(const std::vector<Met>& of) {
        int surfaces = 0;
        each_surface(of, [&](const Hit&) { ++surfaces; });
        return surfaces;
    }
};

void Tracer::surfaces_before(const vec3& point, const Ignore& ignore, int most, const SceneBodies& bodies,
                             std::vector<Hit>& surfaces) const {
    surfaces.clear();
    const Ray ray = ray_to(point);
    if (most <= 0 || ray.far_t <= ray.near_t) return;
    Count counted(*bvh_, ray, ignore, bodies, most);
    bvh_->lead(counted);
    each_surface(counted.met, [&](const Hit& hit) {
        if (int(surfaces.size()) < most) surfaces.push_back(hit);
    });
}

}  // namespace fovea::scene
