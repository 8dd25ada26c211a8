// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/project/slivers.h>

#include <algorithm>
#include <bit>

#include <fovea/base/hash.h>
#include <fovea/base/parallel.h>

namespace fovea::project {
namespace {

/// A point of a sliver.
struct Place {
    std::uint64_t at;
    Index sliver;
    auto operator<=>(const Place&) const = default;
};

/// A point of a placement: points of paths at one vertex of a mesh have the same bits.
std::uint64_t place_of(const Paths& paths, Index path, Index point) {
    const vec3& p = paths.points_obj[point];
    return hash_numbers(paths.placement[path], std::bit_cast<std::uint32_t>(p.x), std::bit_cast<std::uint32_t>(p.y),
                        std::bit_cast<std::uint32_t>(p.z));
}

}  // namespace

Array<Index> slivers_apart(const Paths& paths, In<Index> slivers) {
    if (slivers.empty()) return {};
    std::vector<Place> places;
    for (Index k = 0; k < slivers.size(); ++k)
        for (Index i = paths.rows.begin(slivers[k]); i < paths.rows.end(slivers[k]); ++i)
            places.push_back({place_of(paths, slivers[k], i), k});
    parallel_sort(places.begin(), places.end());
    const auto touched =
        parallel_collect<Index>(paths.count(), paths_per_block, [&](std::size_t p, std::size_t end, auto& found) {
            for (; p < end; ++p) {
                if (!paths.of_view[p] || std::ranges::binary_search(slivers, Index(p))) continue;
                for (Index i = paths.rows.begin(Index(p)); i < paths.rows.end(Index(p)); ++i)
                    for (const Place& place :
                         std::ranges::equal_range(places, place_of(paths, Index(p), i), {}, &Place::at))
                        found.push_back(place.sliver);
            }
        });
    std::vector<std::uint8_t> kept(slivers.size(), 1);
    for (const Index k : touched) kept[k] = 0;
    Array<Index> left;
    for (Index k = 0; k < slivers.size(); ++k)
        if (kept[k]) left.push_back(slivers[k]);
    return left;
}

}  // namespace fovea::project
