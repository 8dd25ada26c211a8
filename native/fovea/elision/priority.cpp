// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/elision/priority.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <fovea/base/check.h>
#include <fovea/base/parallel.h>
#include <fovea/line/registry.h>

namespace fovea::elision {
namespace {

/// Greatest importance among some kinds.
double importance_of(Kinds kinds) {
    const auto& all = line_definitions();
    double importance = 0.0;
    for (Index i = 0; i < all.size(); ++i)
        if (kinds >> i & 1) importance = std::max(importance, all[i]->importance);
    return importance;
}

/// Clamps to [0, 1]; NaN: 0.
double in_unit(double value) { return value > 0.0 ? std::min(value, 1.0) : 0.0; }

/// Integrals along a path over length in space.
struct Along {
    double length = 0.0, kind = 0.0, strength = 0.0, painted = 0.0, distance = 0.0;

    void add(double share, const Along& at) {
        length += share;
        kind += share * at.kind;
        strength += share * at.strength;
        painted += share * at.painted;
        distance += share * at.distance;
    }
};

class Terms {
   public:
    Terms(const Paths& paths, const Scene& scene, const View& view, const style::Elision& weights, In<float> object,
          In<float> painted)
        : paths_(paths),
          scene_(scene),
          view_(view),
          weights_(weights),
          object_(object),
          painted_(painted),
          radius_(std::max(scene_radius(scene), std::numeric_limits<double>::min())),
          painted_weight_(painted.empty() ? 0.0 : weights.painted),
          sum_(weights.length + weights.kind + weights.strength + weights.depth + weights.object + painted_weight_) {}

    float of_path(Index p) const {
        const Along along = sums(p);
        const double by = along.length > 0.0 ? 1.0 / along.length : 0.0;
        const Index placement = paths_.placement[p];
        const double object = placement < object_.size() ? in_unit(object_[placement]) : 0.5;
        const double distance = std::max(0.0, along.distance * by);
        const double sum = weights_.length * along.length / (along.length + 0.1 * radius_) +
                           weights_.kind * along.kind * by + weights_.strength * along.strength * by +
                           weights_.depth * radius_ / (radius_ + distance) + weights_.object * object +
                           painted_weight_ * along.painted * by;
        return float(in_unit(sum / sum_));
    }

   private:
    Along sums(Index p) const {
        const Index placement = paths_.placement[p];
        const bool placed = placement != none;
        const dmat4 to_world = placed ? scene_.placements[placement].object_to_world : dmat4(1.0);
        const dmat4 to_view = placed ? view_.world_to_view * to_world : dmat4(1.0);
        Along sum;
        Kinds kinds = 0;
        double importance = 0.0;
        dvec3 before(0.0);
        for (Index i = paths_.rows.begin(p); i < paths_.rows.end(p); ++i) {
            const dvec3 here(to_world * dvec4(paths_.points_obj[i], 1.0));
            if (i > paths_.rows.begin(p)) {
                const Index from = i - 1;
                if (i == paths_.rows.begin(p) + 1 || paths_.kinds[from] != kinds) {
                    kinds = paths_.kinds[from];
                    importance = importance_of(kinds);
                }
                const dvec3 middle = (dvec3(paths_.points_obj[from]) + dvec3(paths_.points_obj[i])) * 0.5;
                const double strength = (in_unit(paths_.strength[from]) + in_unit(paths_.strength[i])) * 0.5;
                const double share = glm::distance(before, here);
                if (share > 0.0)
                    sum.add(share, {0.0, importance, strength, (paint(p, from) + paint(p, i)) * 0.5,
                                    -(to_view * dvec4(middle, 1.0)).z});
            }
            before = here;
        }
        return sum;
    }

    double paint(Index p, Index point) const {
        if (painted_.empty()) return 0.0;
        return in_unit(painted_[painted_.size() == paths_.points_obj.size() ? point : p]);
    }

    const Paths& paths_;
    const Scene& scene_;
    const View& view_;
    const style::Elision& weights_;
    In<float> object_, painted_;
    double radius_, painted_weight_, sum_;
};

void check_weights(const style::Elision& w, bool painted) {
    const std::array all{w.length, w.kind, w.strength, w.depth, w.object, w.painted};
    check(std::ranges::all_of(all, [](double x) { return x >= 0.0 && std::isfinite(x); }),
          "priority: weights must be 0 or more");
    check(w.length + w.kind + w.strength + w.depth + w.object + (painted ? w.painted : 0.0) > 0.0,
          "priority: at least one weight must be more than 0");
}

/// What decides the rank of the hidden, or of the visible, runs of a path.
struct Ranked {
    bool visible;
    float priority;
    std::uint64_t id;  // of the path
    Index slot;

    bool operator<(const Ranked& other) const {
        if (visible != other.visible) return visible < other.visible;
        if (priority != other.priority) return priority < other.priority;
        return id != other.id ? id > other.id : slot > other.slot;
    }
};

}  // namespace

double scene_radius(const Scene& scene) {
    constexpr double far = std::numeric_limits<double>::infinity();
    dvec3 low(far), high(-far);
    for (const Placement& placement : scene.placements) {
        if (!(placement.usage & usage_draw)) continue;
        const Sphere sphere = bounding_sphere(placement, View());  // world_to_view is the identity
        low = glm::min(low, sphere.center - sphere.radius);
        high = glm::max(high, sphere.center + sphere.radius);
    }
    return low.x <= high.x ? glm::distance(low, high) * 0.5 : 0.0;
}

Array<float> path_priorities(const Paths& paths, const Scene& scene, const View& view, const style::Elision& weights,
                             In<float> object, In<float> painted) {
    check_weights(weights, !painted.empty());
    check(object.empty() || object.size() == scene.placements.size(),
          "priority: one object value per placement expected");
    check(painted.empty() || painted.size() == paths.points_obj.size() || painted.size() == paths.count(),
          "priority: one painted value per point or per path expected");
    const Terms terms(paths, scene, view, weights, object, painted);
    Array<float> priorities(paths.count());
    parallel_for(paths.count(), 256, [&](std::size_t p) { priorities[p] = terms.of_path(Index(p)); });
    return priorities;
}

Array<Index> rank_runs(const ClippedPaths& clipped, const Runs& runs, In<float> priority, In<std::uint64_t> id) {
    check_runs(clipped, runs);
    const Index paths = Index(priority.size());
    check(id.size() == paths, "rank: one priority and one id per path expected");
    check(clipped.path.empty() || std::ranges::max(clipped.path) < paths, "rank: the runs are of other paths");
    // Slot 2 p: hidden runs of path p, 2 p + 1: visible ones.
    std::vector<std::uint8_t> used(2 * std::size_t(paths), 0);
    const auto slot = [&](std::size_t r) { return 2 * clipped.path[runs.piece[r]] + (runs.invisibility[r] == 0); };
    for (std::size_t r = 0; r < runs.size(); ++r) used[slot(r)] = 1;
    std::vector<Ranked> order;
    for (Index s = 0; s < used.size(); ++s) {
        if (!used[s]) continue;
        const float value = priority[s / 2];
        order.push_back(
            {bool(s & 1), std::isnan(value) ? -std::numeric_limits<float>::infinity() : value, id[s / 2], s});
    }
    parallel_sort(order.begin(), order.end());
    std::vector<Index> rank(used.size(), 0);
    for (Index i = 0; i < order.size(); ++i) rank[order[i].slot] = i + 1;
    Array<Index> ranks(runs.size());
    for (std::size_t r = 0; r < runs.size(); ++r) ranks[r] = rank[slot(r)];
    return ranks;
}

}  // namespace fovea::elision
