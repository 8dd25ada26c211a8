// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/visibility/crowds.h>

#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>
#include <tuple>

#include <fovea/base/hash.h>
#include <fovea/base/parallel.h>
#include <fovea/visibility/segment.h>

namespace fovea::visibility {
namespace {

constexpr double steps_per_px = 64.0, steps_of_normals = 64.0;
/// Low bits of a float that are rounded away: it is known to 4e-6 of its size.
constexpr int float_bits = 6;

struct Member {
    std::uint64_t alike;
    Index piece;
    auto order() const { return std::tuple(alike, piece); }
};

/// Leaves the members that may be of crowds: those of bins with more than `crowd` members. Members that are alike are
/// in the same bin, and those that are not are spread over all bins, so that few are left to be sorted.
void keep_full_bins(Array<Member>& members) {
    auto bins = parallel_filled<Index>(std::bit_ceil(2 * members.size()), 0);
    const auto bin_of = [&](const Member& m) -> Index& { return bins[m.alike & (bins.size() - 1)]; };
    parallel_for(members.size(),
                 [&](std::size_t k) { std::atomic_ref(bin_of(members[k])).fetch_add(1, std::memory_order_relaxed); });
    members = parallel_filter(members, 1 << 14, [&](const Member& m) { return bin_of(m) > crowd; });
}

/// Sorts members so that those alike are next to each other; those of crowds are left.
void keep_crowds(Array<Member>& members) {
    keep_full_bins(members);
    parallel_sort(members.begin(), members.end(),
                  [](const Member& a, const Member& b) { return a.order() < b.order(); });
    auto kept = members.begin();
    for (auto begin = members.begin(); begin != members.end();) {
        const auto end = std::find_if(begin, members.end(), [&](const Member& m) { return m.alike != begin->alike; });
        kept = std::size_t(end - begin) > crowd ? std::move(begin, end, kept) : kept;
        begin = end;
    }
    members.resize(kept - members.begin());
}

/// Hash of the points `begin` to before `end` of the clipped paths, rounded.
std::uint64_t hash_of_points(const ClippedPaths& clipped, Index begin, Index end) {
    std::uint64_t hash = end - begin;
    for (Index i = begin; i < end; ++i) {
        const dvec2 px = glm::round(dvec2(clipped.px[i]) * steps_per_px) + 0.0;  // no negative zero
        const std::uint32_t away = std::bit_cast<std::uint32_t>(clipped.position_view[i].z);
        const double numbers[] = {px.x, px.y, double((away + (1u << (float_bits - 1))) >> float_bits)};
        hash = hash_bytes(numbers, sizeof(numbers), hash);
    }
    return hash;
}

/// Hash of the direction in space of a facet, rounded. `facet`: numbered over the scene.
std::uint64_t hash_of_normal(const Scene& scene, Index facet) {
    if (facet == none) return 0;
    const auto base = std::ranges::upper_bound(scene.facet_base, facet) - 1;
    const Placement& placement = scene.placements[base - scene.facet_base.begin()];
    const dvec3 own(placement.surface->facet_plane[facet - *base]);
    const dvec3 normal = glm::normalize(glm::transpose(glm::inverse(dmat3(placement.object_to_world))) * own);
    const dvec3 rounded = glm::round(normal * steps_of_normals) + 0.0;  // no negative zero
    return hash_bytes(&rounded, sizeof(rounded));
}

/// Hash of the directions of the surfaces that the segments of a piece lie on, and of how rays ignore these.
std::uint64_t hash_of_supports(const ClippedPaths& clipped, const Paths& paths, const Tracer& tracer, Index piece) {
    std::uint64_t hash = 0;
    for (Index i = clipped.pieces.begin(piece); i + 1 < clipped.pieces.end(piece); ++i) {
        const Ignore ignore = segment_at(clipped, paths, tracer, piece, i).ignore;
        hash = hash_numbers(hash, ignore.across_triangles(), ignore.reach > 0.0f,
                            hash_of_normal(tracer.scene(), clipped.facet0[i]),
                            hash_of_normal(tracer.scene(), clipped.facet1[i]));
    }
    return hash;
}

}  // namespace

Array<Index> first_of_crowds(const ClippedPaths& clipped, const Paths& paths, const Tracer& tracer) {
    auto members = parallel_map<Member>(clipped.path.size(), [](std::size_t q) -> Member { return {0, Index(q)}; });
    std::erase_if(members, [&](const Member& m) { return paths.placement[clipped.path[m.piece]] == none; });
    const auto keep_alike_in = [&](const auto& hash_of) {
        parallel_for(members.size(), 64, [&](std::size_t k) {
            members[k].alike = hash_numbers(members[k].alike, hash_of(members[k].piece));
        });
        keep_crowds(members);
    };
    // What tells most of them apart, and takes least time, comes first.
    const Rows& points = clipped.pieces;
    keep_alike_in([&](Index q) { return hash_of_points(clipped, points.begin(q), points.begin(q) + 1); });
    keep_alike_in([&](Index q) { return hash_of_points(clipped, points.begin(q), points.end(q)); });
    keep_alike_in([&](Index q) { return hash_of_supports(clipped, paths, tracer, q); });
    if (members.empty()) return {};
    Array<Index> first(clipped.path.size());
    for (Index q = 0; q < first.size(); ++q) first[q] = q;
    for (std::size_t k = 1; k < members.size(); ++k)
        if (members[k].alike == members[k - 1].alike) first[members[k].piece] = first[members[k - 1].piece];
    return first;
}

}  // namespace fovea::visibility
