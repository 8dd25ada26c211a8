// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/elision/line_parts.h>

#include <unordered_map>

#include <fovea/base/hash.h>
#include <fovea/base/parallel.h>

namespace fovea::elision {

LineParts::LineParts(const Paths& paths, const Scene& scene, In<Index> some) : paths_(paths), scene_(scene) {
    struct Numbered {
        LinePart part;
        Index number;
    };
    std::unordered_map<const Surface*, std::uint64_t> known;
    for (const Placement& placement : scene.placements) {
        const auto [at, fresh] = known.try_emplace(placement.surface.get());
        if (fresh) at->second = hash_of(In<mesh::Edge>(placement.surface->edges));
        object_.push_back(hash_numbers(placement.id, at->second));
    }
    first_.resize(paths.count());
    Index count = 0;
    for (const Index p : some) {
        first_[p] = count;
        count += on_edges(p) ? paths.rows.size(p) - 1 : 1;
    }
    Array<Numbered> found(count);
    parallel_for(some.size(), 256, [&](std::size_t k) {
        const Index p = some[k], begin = paths.rows.begin(p);
        const Index size = on_edges(p) ? paths.rows.size(p) - 1 : 1;
        for (Index i = 0; i < size; ++i) found[first_[p] + i] = {part(p, begin + i), first_[p] + i};
    });
    parallel_sort(found.begin(), found.end(), [](const Numbered& m, const Numbered& n) {
        const LinePart &a = m.part, &b = n.part;
        return a.key != b.key ? a.key < b.key : a.path != b.path ? a.path < b.path : a.from < b.from;
    });
    sorted.resize(count);
    place_.resize(count);
    parallel_for(count, 1024, [&](std::size_t i) {
        sorted[i] = found[i].part;
        place_[found[i].number] = Index(i);
    });
}

Index LineParts::of(Index path, Index point) const {
    return place_[first_[path] + (on_edges(path) ? point - paths_.rows.begin(path) : 0)];
}

bool LineParts::on_edges(Index path) const {
    const Placement& placement = scene_.placements[paths_.placement[path]];
    return placement.surface->is_edge(paths_.place[paths_.rows.begin(path)]);
}

LinePart LineParts::part(Index path, Index point) const {
    const std::uint64_t object = object_[paths_.placement[path]];
    const Index end = paths_.rows.end(path) - 1;
    if (!on_edges(path)) return {hash_numbers(object, paths_.id[path]), path, 0.0, paths_.arc_obj[end]};
    const bool ahead = paths_.edge_t[point] < 0.5f;
    const double first = paths_.arc_obj[point], last = paths_.arc_obj[point + 1];
    return {hash_numbers(object, paths_.place[point]), path, ahead ? first : last, ahead ? last : first};
}

Array<Index> matched_parts(In<LinePart> now, In<LinePart> there) {
    Array<Index> found;
    found.reserve(now.size());
    auto at = there.begin();
    const auto end = there.end();
    for (const LinePart& part : now) {
        while (at != end && at->key < part.key) ++at;
        const bool one = at != end && at->key == part.key && (at + 1 == end || (at + 1)->key != part.key);
        found.push_back(one ? Index(at - there.begin()) : none);
    }
    return found;
}

}  // namespace fovea::elision
