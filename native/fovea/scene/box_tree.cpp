// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/scene/box_tree.h>

#include <limits>

namespace fovea::scene {
namespace {

constexpr Box empty{vec3(infinity), vec3(-infinity)};

Box around(const Box& a, const Box& b) { return {glm::min(a.low, b.low), glm::max(a.high, b.high)}; }

Array<FourBoxes> four_by_four(const Array<Box>& boxes) {
    return parallel_map<FourBoxes>((boxes.size() + 3) / 4, [&](std::size_t j) {
        FourBoxes four;
        for (int lane = 0; lane < 4; ++lane) {
            const std::size_t i = 4 * j + lane;
            const Box box = i < boxes.size() ? boxes[i] : empty;
            for (int axis = 0; axis < 3; ++axis) {
                four.low[axis][lane] = box.low[axis];
                four.high[axis][lane] = box.high[axis];
            }
        }
        return four;
    });
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

Box around(const FourBoxes& boxes) { return around(around(boxes[0], boxes[1]), around(boxes[2], boxes[3])); }

std::vector<Array<FourBoxes>> levels_over(Array<Box> boxes, Box& bounds) {
    std::vector<Array<FourBoxes>> levels;
    while (boxes.size() > 1) {
        levels.push_back(four_by_four(boxes));
        const Array<FourBoxes>& level = levels.back();
        boxes = parallel_map<Box>(level.size(), [&](std::size_t i) { return around(level[i]); });
    }
    bounds = boxes[0];
    return levels;
}

BoxTree::BoxTree(const Array<Box>& boxes) {
    Box all = empty;
    for (const Box& box : boxes) all = around(all, box);
    const dvec3 half = 0.5 * (dvec3(all.high) - dvec3(all.low));
    order_ = morton_order(boxes.size(), dvec3(all.low) + half, std::max({half.x, half.y, half.z}),
                          [&](std::size_t i) { return boxes[i]; });
    Array<Box> sorted = parallel_map<Box>(boxes.size(), [&](std::size_t i) { return boxes[order_[i]]; });
    if (sorted.size() == 1) sorted.push_back(empty);  // so that there is a level
    if (!sorted.empty()) levels_ = levels_over(std::move(sorted), all);
}

}  // namespace fovea::scene
