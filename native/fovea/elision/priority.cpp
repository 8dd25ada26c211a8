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

/// Clamps to [0, 1]; NaN: 0.
double in_unit(double value) { return value > 0.0 ? std::min(value, 1.0) : 0.0; }

/// Integrals along a path over length in space.
struct Along {
    double length = 0.0, kind = 0.0, strength = 0.0, painted = 0.0, distance = 0.0;
    double outer = 0.0, most_outer = 0.0;  // what the kind gains from where its object ends, and could gain

    void add(double share, const Along& at) {
        length += share;
        kind += share * at.kind;
        strength += share * at.strength;
        painted += share * at.painted;
        distance += share * at.distance;
        outer += share * at.outer;
        most_outer += share * at.most_outer;
    }
};

class Terms {
   public:
    Terms(const Paths& paths, const Scene& scene, const View& view, const style::Elision& weights, In<float> object,
          In<float> painted, In<OuterShare> outer)
        : paths_(paths),
          scene_(scene),
          view_(view),
          weights_(weights),
          object_(object),
          painted_(painted),
          outer_(outer),
          radius_(std::max(scene_radius(scene), std::numeric_limits<double>::min())),
          painted_weight_(painted.empty() ? 0.0 : weights.painted),
          sum_(weights.length + weights.kind + weights.strength + weights.depth + weights.object + painted_weight_) {}

    Priority of_path(Index p) const {
        const Along along = sums(p);
        const double by = along.length > 0.0 ? 1.0 / along.length : 0.0;
        const Index placement = paths_.placement[p];
        const double object = placement < object_.size() ? in_unit(object_[placement]) : 0.5;
        const double distance = std::max(0.0, along.distance * by);
        const double sum = weights_.length * along.length / (along.length + 0.1 * radius_) +
                           weights_.kind * along.kind * by + weights_.strength * along.strength * by +
                           weights_.depth * radius_ / (radius_ + distance) + weights_.object * object +
                           painted_weight_ * along.painted * by;
        const auto with = [&](double outer) {
            return float(in_unit((sum + weights_.kind * (outer - along.outer) * by) / sum_));
        };
        const float value = float(in_unit(sum / sum_));
        if (!(along.most_outer > 0.0)) return {value};
        const double share = along.outer / along.most_outer;
        if (share <= 0.0 || share >= 1.0) return {value};
        return {value, with(0.0), with(along.most_outer), float(share)};
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
                if (share > 0.0) {
                    const auto [kind, outer, most_outer] = kind_at(from, importance);
                    sum.add(share, {0.0, kind, strength, (paint(p, from) + paint(p, i)) * 0.5,
                                    -(to_view * dvec4(middle, 1.0)).z, outer, most_outer});
                }
            }
            before = here;
        }
        return sum;
    }

    struct Kind {
        double importance, outer, most_outer;
    };

    Kind kind_at(Index point, double importance) const {
        if (outer_.empty() || outer_[point].share < 0.0f) return {importance, 0.0, 0.0};
        const double inner = outer_[point].inner, most = std::max(0.0, outermost_ - inner);
        const double gained = most * outer_[point].share;
        return {inner + gained, gained, most};
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
    In<OuterShare> outer_;
    const double outermost_ = line::importance_of(line::edge_parts());
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

Array<Priority> path_priorities(const Paths& paths, const Scene& scene, const View& view, const style::Elision& weights,
                                In<float> object, In<float> painted, In<OuterShare> outer) {
    check_weights(weights, !painted.empty());
    check(object.empty() || object.size() == scene.placements.size(),
          "priority: one object value per placement expected");
    check(painted.empty() || painted.size() == paths.points_obj.size() || painted.size() == paths.count(),
          "priority: one painted value per point or per path expected");
    check(outer.empty() || outer.size() == paths.points_obj.size(), "priority: one outer share per point expected");
    const Terms terms(paths, scene, view, weights, object, painted, outer);
    Array<Priority> priorities(paths.count());
    parallel_for(paths.count(), 256, [&](std::size_t p) { priorities[p] = terms.of_path(Index(p)); });
    return priorities;
}

namespace {

/// Of the hidden runs of path p: 2 p, of its visible ones: 2 p + 1.
std::vector<Index> slots_of(const ClippedPaths& clipped, const Runs& runs) {
    std::vector<Index> slots(runs.size());
    for (std::size_t r = 0; r < runs.size(); ++r)
        slots[r] = 2 * clipped.path[runs.piece[r]] + (runs.invisibility[r] == 0);
    return slots;
}

Ranked ranked(Index slot, float priority, In<std::uint64_t> id) {
    return {bool(slot & 1), std::isnan(priority) ? -std::numeric_limits<float>::infinity() : priority, id[slot / 2],
            slot};
}

}  // namespace

Array<Index> rank_runs(const ClippedPaths& clipped, const Runs& runs, In<Priority> priority, In<std::uint64_t> id) {
    check_runs(clipped, runs);
    const Index paths = Index(priority.size());
    check(id.size() == paths, "rank: one priority and one id per path expected");
    check(clipped.path.empty() || std::ranges::max(clipped.path) < paths, "rank: the runs are of other paths");
    const std::vector<Index> slots = slots_of(clipped, runs);
    std::vector<std::uint8_t> used(2 * std::size_t(paths), 0);
    for (const Index slot : slots) used[slot] = 1;
    std::vector<Ranked> order;
    for (Index s = 0; s < used.size(); ++s)
        if (used[s]) order.push_back(ranked(s, priority[s / 2].value, id));
    parallel_sort(order.begin(), order.end());
    std::vector<Index> rank(used.size(), 0);
    for (Index i = 0; i < order.size(); ++i) rank[order[i].slot] = i + 1;
    Array<Index> ranks(runs.size());
    for (std::size_t r = 0; r < runs.size(); ++r) ranks[r] = rank[slots[r]];
    return ranks;
}

Array<vec3> precedence_of_ranks(const ClippedPaths& clipped, const Runs& runs, In<Index> ranks, In<Priority> priority,
                                In<std::uint64_t> id) {
    check(ranks.size() == runs.size(), "rank: one rank per run expected");
    const std::vector<Index> slots = slots_of(clipped, runs);
    if (std::ranges::none_of(slots, [&](Index slot) { return priority[slot / 2].is_changing(); })) return {};
    std::vector<Index> rank(2 * priority.size(), 0);
    for (std::size_t r = 0; r < runs.size(); ++r) rank[slots[r]] = ranks[r];
    std::vector<Ranked> order;
    for (Index s = 0; s < rank.size(); ++s) {
        if (rank[s] == 0) continue;
        order.push_back(ranked(s, priority[s / 2].before, id));
        if (priority[s / 2].is_changing()) order.push_back(ranked(s, priority[s / 2].after, id));
    }
    parallel_sort(order.begin(), order.end());
    Array<vec3> places(std::ranges::max(ranks) + std::size_t(1), vec3(0.0f));
    for (Index i = 0; i < order.size(); ++i) {
        vec3& place = places[rank[order[i].slot]];
        place = vec3(place.y > 0.0f ? place.x : float(i + 1), float(i + 1), priority[order[i].slot / 2].share);
    }
    return places;
}

}  // namespace fovea::elision
