// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/scene/pose.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

namespace fovea::scene {
namespace {

constexpr double farthest_px = 1e6;

/// Shares of the corners of a triangle in the point of its plane nearest to `at`.
std::array<double, 3> shares_of(const dvec3& a, const dvec3& b, const dvec3& c, const dvec3& at) {
    const dvec3 ab = b - a, ac = c - a, normal = glm::cross(ab, ac);
    const double square = glm::dot(normal, normal);
    if (!(square > 0.0)) return {1.0, 0.0, 0.0};
    const double second = glm::dot(glm::cross(at - a, ac), normal) / square;
    const double third = glm::dot(glm::cross(ab, at - a), normal) / square;
    return {1.0 - second - third, second, third};
}

/// `deforms`: of which surfaces the positions are kept.
template <typename Deforms>
Pose pose_of(const Scene& scene, const View& view, In<Index> placements, const Deforms& deforms) {
    std::vector<std::pair<std::uint64_t, Index>> order;
    for (const Index placement : placements) order.emplace_back(scene.placements[placement].id, placement);
    std::ranges::sort(order);
    Pose made{view, {}};
    std::map<const Surface*, std::shared_ptr<const Array<vec3>>> known;
    for (const auto& [id, placement] : order) {
        const Placement& of = scene.placements[placement];
        const auto [at, fresh] = known.try_emplace(of.surface.get());
        const auto begin = of.surface->positions.begin();
        if (fresh && deforms(*of.surface))
            at->second = std::make_shared<const Array<vec3>>(begin, begin + of.surface->vertex_count());
        made.placed.push_back({id, placement, view.world_to_view * of.object_to_world, at->second});
    }
    return made;
}

}  // namespace

SurfacePoint surface_point(const Surface& surface, In<vec3> at, Index place, const dvec3& position) {
    if (at.empty()) return {position};
    if (!surface.is_edge(place)) {
        const mesh::Triangle& of = surface.triangles[surface.triangle_at(place)];
        return {position, {of.x, of.y, of.z}, shares_of(dvec3(at[of.x]), dvec3(at[of.y]), dvec3(at[of.z]), position)};
    }
    const mesh::Edge edge = surface.edges[place];
    const dvec3 from(at[edge.x]), way = dvec3(at[edge.y]) - from;
    const double square = glm::dot(way, way);
    const double share = square > 0.0 ? std::clamp(glm::dot(position - from, way) / square, 0.0, 1.0) : 0.0;
    return {position, {edge.x, edge.y, edge.y}, {1.0 - share, share, 0.0}};
}

Index Pose::find(std::uint64_t id) const {
    const auto at = std::ranges::lower_bound(placed, id, {}, &Placed::id);
    return at != placed.end() && at->id == id ? Index(at - placed.begin()) : none;
}

Pose::Seen Pose::seen(const SurfacePoint& point, const Placed& here, Index number) const {
    if (number == none) return {dvec2(0.0), NAN};
    const Placed& there = placed[number];
    const In<vec3> positions = there.at();
    dvec3 at = point.position;
    if (!positions.empty() && positions.size() == here.at().size()) {
        at = dvec3(0.0);
        for (int k = 0; k < 3; ++k) at += point.shares[k] * dvec3(positions[point.vertices[k]]);
    }
    const dvec3 position(there.object_to_view * dvec4(at, 1.0));
    const dvec4 clip = view.view_to_clip * dvec4(position, 1.0);
    const dvec2 px = to_pixels(view, clip);
    const bool is_there = clip.w > 0.0 && std::abs(px.x) < farthest_px && std::abs(px.y) < farthest_px;
    return {px, is_there ? -position.z : NAN};
}

std::size_t Pose::bytes() const {
    std::size_t sum = placed.size() * sizeof(Placed);
    std::set<const void*> known;
    for (const Placed& each : placed)
        if (known.insert(each.positions.get()).second) sum += each.at().size_bytes();
    return sum;
}

Pose pose_of(const Scene& scene, const View& view) {
    Array<Index> all(scene.placements.size());
    std::iota(all.begin(), all.end(), Index(0));
    return pose_of(scene, view, all, [](const Surface&) { return true; });
}

Pose pose_of(const Scene& scene, const View& view, In<Index> placements) {
    return pose_of(scene, view, placements, [](const Surface& surface) { return !surface.rest().empty(); });
}

}  // namespace fovea::scene
