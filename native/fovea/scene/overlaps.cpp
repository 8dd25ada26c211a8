// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/scene/overlaps.h>

#include <algorithm>

#include <fovea/scene/triangle_tree.h>

namespace fovea {

std::vector<std::pair<Index, Index>> overlapping_placements(const Scene& scene, In<Index> placements) {
    struct Entry {
        Box box;
        Index position;
    };
    std::vector<Entry> entries;
    for (Index i = 0; i < placements.size(); ++i) {
        const Placement& placement = scene.placements[placements[i]];
        const auto tree = triangle_tree(*placement.surface);
        if (tree->empty()) continue;
        const Box box = tree->bounds().mapped(Affine(placement.object_to_world));
        if (box.meets(box)) entries.push_back({box, i});  // not where a placement is no number
    }
    std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
        return a.box.low.x != b.box.low.x ? a.box.low.x < b.box.low.x : a.position < b.position;
    });
    // Sweep along x: what begins before a box ends may meet it.
    std::vector<std::pair<Index, Index>> pairs;
    for (std::size_t i = 0; i < entries.size(); ++i)
        for (std::size_t j = i + 1; j < entries.size() && entries[j].box.low.x <= entries[i].box.high.x; ++j)
            if (entries[i].box.meets(entries[j].box))
                pairs.push_back(std::minmax({entries[i].position, entries[j].position}));
    std::sort(pairs.begin(), pairs.end());
    return pairs;
}

}  // namespace fovea
