// SPDX-License-Identifier: GPL-3.0-or-later
// Axis-aligned boxes, four at a time, and a tree of them.
#pragma once

#include <algorithm>
#include <bit>
#include <glm/mat4x3.hpp>
#include <limits>
#include <vector>

#include <fovea/base/four.h>
#include <fovea/base/morton.h>
#include <fovea/base/parallel.h>

namespace fovea::scene {

/// An affine map; column 3 is the translation.
using Affine = glm::dmat4x3;

struct Box {
    vec3 low, high;

    /// Whether the boxes overlap or touch. False for an empty box, and for NaN.
    bool meets(const Box& other) const {
        return glm::all(glm::lessThanEqual(low, other.high)) && glm::all(glm::lessThanEqual(other.low, high));
    }
    Box grown(float by) const { return {low - by, high + by}; }
    /// A box that contains the image of this one.
    Box mapped(const Affine& map) const;
};

/// Four boxes. A lane that is not used has a box that meets none.
struct FourBoxes {
    Four low[3], high[3];

    Box operator[](int lane) const {
        return {{low[0][lane], low[1][lane], low[2][lane]}, {high[0][lane], high[1][lane], high[2][lane]}};
    }
    /// Bit i is set if lane i overlaps or touches `box`.
    unsigned meeting(const Box& box) const {
        FourInts met = (low[0] <= box.high.x) & (high[0] >= box.low.x);
        met &= (low[1] <= box.high.y) & (high[1] >= box.low.y);
        return bits(met & (low[2] <= box.high.z) & (high[2] >= box.low.z));
    }
};

/// The numbers [0, count) in Morton order of the middles of box(i). They lie in the cube of half the side `half` around
/// `center`, or are moved to its border.
template <typename BoxOf>
Array<Index> morton_order(std::size_t count, const dvec3& center, double half, const BoxOf& box) {
    const double cells = half > 0.0 ? 524288.0 / half : 0.0;
    const auto cell = [](double place) { return place > 0.0 ? Index(std::min(place, 1048575.0)) : 0u; };
    struct Placed {
        std::uint64_t code;
        Index number;
    };
    auto placed = parallel_map<Placed>(count, [&](std::size_t i) -> Placed {
        const Box at = box(i);
        const dvec3 place = (0.5 * (dvec3(at.low) + dvec3(at.high)) - (center - half)) * cells;
        return {along_curve({cell(place.x), cell(place.y), cell(place.z)}), static_cast<Index>(i)};
    });
    parallel_sort(placed.begin(), placed.end(), [](const Placed& a, const Placed& b) {
        return a.code != b.code ? a.code < b.code : a.number < b.number;
    });
    return parallel_map<Index>(count, [&](std::size_t i) { return placed[i].number; });
}

/// Smallest box around four; lanes that are not used hold the empty box.
Box around(const FourBoxes& boxes);

/// Levels of a tree over boxes: lane i of node j of levels[0] is box 4 j + i; of levels[k], it bounds node 4 j + i of
/// levels[k - 1]. The last has one node. A single box has no levels. `bounds`: output; of all boxes, at least one.
std::vector<Array<FourBoxes>> levels_over(Array<Box> boxes, Box& bounds);

/// Finds those of a set of boxes that meet another one.
class BoxTree {
   public:
    explicit BoxTree(const Array<Box>& boxes);

    /// Calls found(number) for boxes that meet `box`, in the same order every time, until it returns false.
    template <typename Found>
    void each_meeting(const Box& box, const Found& found) const {
        constexpr float farthest = std::numeric_limits<float>::max();  // lanes that are not used begin beyond
        const Box finite{glm::max(box.low, -farthest), glm::min(box.high, farthest)};
        if (!levels_.empty()) descend(levels_.size() - 1, 0, finite, found);
    }

   private:
    template <typename Found>
    bool descend(std::size_t level, Index node, const Box& box, const Found& found) const {
        for (unsigned lanes = levels_[level][node].meeting(box); lanes != 0; lanes &= lanes - 1) {
            const Index below = 4 * node + static_cast<Index>(std::countr_zero(lanes));
            if (!(level == 0 ? found(order_[below]) : descend(level - 1, below, box, found))) return false;
        }
        return true;
    }

    Array<Index> order_;
    std::vector<Array<FourBoxes>> levels_;
};

}  // namespace fovea::scene
