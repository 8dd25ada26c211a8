// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/scene/triangle_tree.h>

#include <limits>

#include <fovea/base/morton.h>
#include <fovea/base/parallel.h>

namespace fovea::scene {
namespace {

Box box_of(const Surface& surface, Index triangle) {
    const Triangle& t = surface.triangles[triangle];
    const vec3 &a = surface.positions[t.x], &b = surface.positions[t.y], &c = surface.positions[t.z];
    return {glm::min(a, glm::min(b, c)), glm::max(a, glm::max(b, c))};
}

struct Placed {
    std::uint64_t code;
    Index triangle;
};

Array<Index> morton_order(const Surface& surface) {
    const dvec3 low = dvec3(surface.center) - double(surface.radius);
    const double cells = surface.radius > 0.0f ? 524288.0 / surface.radius : 0.0;
    auto placed = parallel_map<Placed>(surface.triangles.size(), [&](std::size_t t) -> Placed {
        const Box box = box_of(surface, static_cast<Index>(t));
        const dvec3 at = (0.5 * (dvec3(box.low) + dvec3(box.high)) - low) * cells;
        const auto cell = [](double place) { return place > 0.0 ? Index(std::min(place, 1048575.0)) : 0u; };
        return {along_curve({cell(at.x), cell(at.y), cell(at.z)}), static_cast<Index>(t)};
    });
    parallel_sort(placed.begin(), placed.end(), [](const Placed& a, const Placed& b) {
        return a.code != b.code ? a.code < b.code : a.triangle < b.triangle;
    });
    return parallel_map<Index>(placed.size(), [&](std::size_t i) { return placed[i].triangle; });
}

/// Bounding boxes of each `each` consecutive boxes.
Array<Box> boxes_over(const Array<Box>& below, Index each) {
    return parallel_map<Box>((below.size() + each - 1) / each, [&](std::size_t i) {
        Box box = below[each * i];
        for (std::size_t k = each * i + 1; k < std::min<std::size_t>(each * (i + 1), below.size()); ++k)
            box = {glm::min(box.low, below[k].low), glm::max(box.high, below[k].high)};
        return box;
    });
}

TriangleTree make_tree(const Surface& surface) {
    TriangleTree tree;
    tree.order = morton_order(surface);
    tree.boxes = parallel_map<Box>(tree.order.size(), [&](std::size_t i) { return box_of(surface, tree.order[i]); });
    if (tree.boxes.empty()) return tree;
    tree.levels.push_back(boxes_over(tree.boxes, TriangleTree::leaf_size));
    while (tree.levels.back().size() > 1) tree.levels.push_back(boxes_over(tree.levels.back(), 2));
    return tree;
}

}  // namespace

Box Box::mapped(const Affine& map) const {
    const dvec3 middle = 0.5 * (dvec3(low) + dvec3(high)), half = 0.5 * (dvec3(high) - dvec3(low));
    const dvec3 at = map * dvec4(middle, 1.0);
    dvec3 reach = glm::abs(map[0]) * half.x + glm::abs(map[1]) * half.y + glm::abs(map[2]) * half.z;
    // Exceeds the rounding errors of the map and of the conversion to single precision.
    reach += 4.0 * std::numeric_limits<float>::epsilon() * (glm::abs(at) + reach);
    return {vec3(at - reach), vec3(at + reach)};
}

std::shared_ptr<const TriangleTree> triangle_tree(const Surface& surface) {
    return surface.cache().get<TriangleTree>(0, [&] { return make_tree(surface); });
}

}  // namespace fovea::scene
