// SPDX-License-Identifier: GPL-3.0-or-later
// Intersection: where surfaces pass through each other, two objects or parts of one.
// In   triangles of all placements that are drawn; independent of the view
// Out  curves on two triangles at once. They belong to the placement with the lower id (the other one if that is scaled
//      to a point) and are in its object space; `other` is the triangle of the second placement. Surfaces that only
//      touch have none (scene/crossings.h): a box on a floor is outlined by its own creases. Instances in a heap have
//      none with each other (see below).
// Results are cached with the first surface, keyed by the second's version and its placement relative to the first, in
// single precision. So nothing is recomputed when the camera, or both objects together, move, and pairs of instances
// with equal relative placement share one result.
#include <algorithm>
#include <atomic>
#include <cmath>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <unordered_map>
#include <unordered_set>

#include <fovea/base/hash.h>
#include <fovea/line/definition.h>
#include <fovea/scene/crossings.h>

namespace fovea::line {
namespace {

struct Intersection {
    bool between, within;
};

const Parameters<Intersection> intersection_parameters{
    {&Intersection::between, "between", "Between Objects", true, "Where two objects pass through each other"},
    {&Intersection::within, "within", "Within Objects", true, "Where an object passes through itself"}};

/// Frames after which results that are not requested are evicted.
constexpr std::uint64_t kept_frames = 16;
std::atomic<std::uint64_t> frames{0};

/// Number of overlapping instances of the same surface from which a placement counts as part of a heap (leaves, grass,
/// gravel): there would be very many intersection lines, none of them useful.
constexpr Index heap = 24;

/// Products of larger coordinates overflow.
constexpr double farthest = 1e18;

/// Cache of the intersections of one surface with others, and with itself (key 0).
struct KeptPairs {
    struct Entry {
        std::shared_ptr<const KeptCurves> curves;
        std::uint64_t frame = 0;  ///< last request
    };
    std::mutex mutex;
    std::map<std::uint64_t, Entry> entries;

    std::shared_ptr<const KeptCurves> find(std::uint64_t key, std::uint64_t frame) {
        const std::lock_guard lock(mutex);
        const auto it = entries.find(key);
        if (it == entries.end()) return nullptr;
        it->second.frame = frame;
        return it->second.curves;
    }
    void keep(std::uint64_t key, std::uint64_t frame, std::shared_ptr<const KeptCurves> curves) {
        const std::lock_guard lock(mutex);
        entries[key] = {std::move(curves), frame};
    }
    /// Evicts entries that have not been requested for kept_frames.
    void forget(std::uint64_t frame) {
        const std::lock_guard lock(mutex);
        std::erase_if(entries, [&](const auto& entry) { return entry.second.frame + kept_frames < frame; });
    }
};

/// Two placements.
struct Pair {
    Index first, second;
    Affine second_to_first{1.0};
    std::uint64_t key = 0;
};

/// Rounds to multiples of 2^-24 of the magnitude of `size`; never returns -0.
double rounded(double value, double size) {
    const double step = std::ldexp(1.0, std::ilogb(size) - 24);
    return std::nearbyint(value / step) * step + 0.0;
}

/// Computes pair.second_to_first, rounded to single precision so that it is equal for objects that move together, and
/// the cache key. False if there is no finite map.
bool relate(const Scene& scene, Pair& pair) {
    const Placement &first = scene.placements[pair.first], &second = scene.placements[pair.second];
    Affine& map = pair.second_to_first;
    map = Affine(glm::inverse(first.object_to_world) * second.object_to_world);
    double turn = 0.0, shift = glm::length(first.surface->center) + first.surface->radius;
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 3; ++row) {
            double& size = column < 3 ? turn : shift;
            if (!(std::abs(map[column][row]) < farthest)) return false;
            size = std::max(size, std::abs(map[column][row]));
        }
    if (turn == 0.0 || shift == 0.0) return false;
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 3; ++row) map[column][row] = rounded(map[column][row], column < 3 ? turn : shift);
    pair.key = hash_bytes(&map, sizeof(map), second.surface->version());
    return true;
}

/// Pairs of placements (indices into the scene) whose world-space bounding boxes overlap, but for those of which both
/// are in a heap; ascending. Placements without triangles are omitted.
Array<std::pair<Index, Index>> overlapping_placements(const Scene& scene, In<Index> placements) {
    const auto box_of = [&](Index i) -> std::optional<Box> {
        const Placement& placement = scene.placements[i];
        const auto tree = triangle_tree(*placement.surface);
        if (tree->empty()) return {};
        const Box box = tree->bounds.mapped(Affine(placement.object_to_world));
        return box.meets(box) ? std::optional(box) : std::nullopt;  // not if it is NaN
    };
    const auto bounded = parallel_collect<std::pair<Box, Index>>(
        placements.size(), 4096, [&](std::size_t begin, std::size_t end, auto& out) {
            for (const Index i : placements.subspan(begin, end - begin))
                if (const auto box = box_of(i)) out.emplace_back(*box, i);
        });
    const auto boxes = parallel_map<Box>(bounded.size(), [&](std::size_t i) { return bounded[i].first; });
    const auto of = parallel_map<Index>(bounded.size(), [&](std::size_t i) { return bounded[i].second; });
    const BoxTree tree(boxes);
    const auto heaped = parallel_map<std::uint8_t>(boxes.size(), [&](std::size_t i) {
        const Surface* const own = scene.placements[of[i]].surface.get();
        Index alike = 0;  // with itself
        tree.each_meeting(boxes[i], [&](Index j) {
            alike += scene.placements[of[j]].surface.get() == own;
            return alike <= heap;
        });
        return alike > heap;
    });
    auto pairs =
        parallel_collect<std::pair<Index, Index>>(boxes.size(), 64, [&](std::size_t begin, std::size_t end, auto& out) {
            for (std::size_t i = begin; i < end; ++i) {
                if (heaped[i]) continue;
                tree.each_meeting(boxes[i], [&](Index j) {
                    if (j > i || heaped[j]) out.push_back(std::minmax(of[i], of[j]));
                    return true;
                });
            }
        });
    parallel_sort(pairs.begin(), pairs.end());
    return pairs;
}

/// The pairs of placements that overlap, the one that keeps their result first.
std::vector<Pair> pairs_of(const Scene& scene, In<Index> drawn) {
    std::vector<Pair> pairs;
    for (const auto& [i, j] : overlapping_placements(scene, drawn)) {
        Pair pair{i, j};
        if (scene.placements[pair.second].id < scene.placements[pair.first].id) std::swap(pair.first, pair.second);
        if (relate(scene, pair)) {
            pairs.push_back(pair);
        } else if (std::swap(pair.first, pair.second); relate(scene, pair)) {
            pairs.push_back(pair);
        }
    }
    return pairs;
}

std::shared_ptr<const KeptCurves> kept_curves(const Crossings& crossings) {
    auto curves = std::make_shared<KeptCurves>();
    curves->pieces = parallel_map<CurvePiece>(crossings.size(), [&](std::size_t i) -> CurvePiece {
        const Crossing& c = crossings[i];
        return {.triangle = c.triangle[0],
                .side = {c.end[0], c.end[1]},
                .point = {c.point[0], c.point[1]},
                .strength = {1.0f, 1.0f},
                .other = c.triangle[1]};
    });
    return curves;
}

std::shared_ptr<KeptPairs> kept_pairs(const Surface& surface) {
    return *surface.cache().get<std::shared_ptr<KeptPairs>>(0, [] { return std::make_shared<KeptPairs>(); });
}

/// Where a surface passes through itself. Not computed while its cache is locked: parallel loops in it query that, too.
std::shared_ptr<const KeptCurves> find_within(const Surface& surface, std::uint64_t frame, const Cancel& cancel) {
    const auto store = kept_pairs(surface);
    store->forget(frame);
    auto curves = store->find(0, frame);
    if (!curves) store->keep(0, frame, curves = kept_curves(cross_itself(surface, cancel)));
    return curves;
}

std::shared_ptr<const KeptCurves> find_pair(const Scene& scene, const Pair& pair, const Cancel& cancel) {
    const Surface &first = *scene.placements[pair.first].surface, &second = *scene.placements[pair.second].surface;
    return kept_curves(cross(first, second, pair.second_to_first, cancel));
}

/// Results for pairs, of which those that are equal are computed once and kept.
std::vector<std::shared_ptr<const KeptCurves>> find_pairs(const Scene& scene, const std::vector<Pair>& pairs,
                                                          std::uint64_t frame, const Cancel& cancel) {
    std::vector<std::shared_ptr<KeptPairs>> stores(pairs.size());
    std::vector<std::shared_ptr<const KeptCurves>> found(pairs.size());
    // For each missing result, the first pair that needs it.
    std::map<std::pair<const void*, std::uint64_t>, std::size_t> missing;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        stores[i] = kept_pairs(*scene.placements[pairs[i].first].surface);
        found[i] = stores[i]->find(pairs[i].key, frame);
        if (!found[i]) missing.try_emplace({stores[i].get(), pairs[i].key}, i);
    }
    std::vector<std::size_t> jobs;
    for (const auto& [key, i] : missing) jobs.push_back(i);
    parallel_for(jobs.size(), 1, [&](std::size_t j) {
        const std::size_t i = jobs[j];
        stores[i]->keep(pairs[i].key, frame, find_pair(scene, pairs[i], cancel));
    });
    for (const auto& store : std::set(stores.begin(), stores.end())) store->forget(frame);
    for (std::size_t i = 0; i < pairs.size(); ++i)
        if (!found[i]) found[i] = stores[i]->find(pairs[i].key, frame);
    return found;
}

/// The surfaces of placements, each once.
std::vector<const Surface*> surfaces_of(const Scene& scene, In<Index> placements) {
    std::vector<const Surface*> found;
    std::unordered_set<const Surface*> met;
    for (const Index i : placements)
        if (met.insert(scene.placements[i].surface.get()).second) found.push_back(scene.placements[i].surface.get());
    return found;
}

std::vector<SceneCurves> find_intersection(const Scene& scene, In<Index> drawn, const Intersection& values,
                                           const Cancel& cancel) {
    std::vector<const Surface*> surfaces;
    std::vector<Pair> pairs;
    if (values.within) surfaces = surfaces_of(scene, drawn);
    if (values.between) pairs = pairs_of(scene, drawn);
    std::vector<std::shared_ptr<const KeptCurves>> within(surfaces.size()), between;
    const std::uint64_t frame = ++frames;
    parallel_invoke(
        [&] {
            parallel_for(surfaces.size(), 1,
                         [&](std::size_t i) { within[i] = find_within(*surfaces[i], frame, cancel); });
        },
        [&] { between = find_pairs(scene, pairs, frame, cancel); });
    std::unordered_map<const Surface*, std::shared_ptr<const KeptCurves>> of_surface;
    for (std::size_t i = 0; i < surfaces.size(); ++i)
        if (!within[i]->pieces.empty()) of_surface.emplace(surfaces[i], within[i]);
    std::vector<SceneCurves> found;
    if (!of_surface.empty())
        for (const Index i : drawn)
            if (const auto own = of_surface.find(scene.placements[i].surface.get()); own != of_surface.end())
                found.push_back({i, i, own->second});
    for (std::size_t i = 0; i < pairs.size(); ++i) found.push_back({pairs[i].first, pairs[i].second, between[i]});
    return found;
}

void find_ahead(const Surface& surface, const Intersection& values, const Cancel& cancel) {
    if (values.within) find_within(surface, frames, cancel);
}

}  // namespace

extern const LineDefinition intersection = {
    .name = "intersection",
    .label = "Intersection",
    .source = "Saito & Takahashi 1990; Edelsbrunner & Mücke 1990, Simulation of Simplicity",
    .description = "Where surfaces pass through each other; not where they only touch",
    .scope = Scope::placements,
    .importance = 0.4,
    .parameters = intersection_parameters,
    .rule = SceneRule{intersection_parameters.of(find_intersection), intersection_parameters.of(find_ahead)},
    .usual = true,
};

}  // namespace fovea::line
