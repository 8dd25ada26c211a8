// SPDX-License-Identifier: GPL-3.0-or-later
// Tree of bounding boxes over triangles, to find the pairs of triangles of two surfaces that may intersect.
#pragma once

#include <glm/mat4x3.hpp>

#include <fovea/base/parallel.h>
#include <fovea/mesh/surface.h>

namespace fovea::scene {

/// An affine map; column 3 is the translation.
using Affine = glm::dmat4x3;

struct Box {
    vec3 low, high;

    /// Whether the boxes overlap or touch. Branchless, as the outcome of each comparison is unpredictable.
    bool meets(const Box& other) const {
        return bool(unsigned(low.x <= other.high.x) & unsigned(other.low.x <= high.x) &
                    unsigned(low.y <= other.high.y) & unsigned(other.low.y <= high.y) &
                    unsigned(low.z <= other.high.z) & unsigned(other.low.z <= high.z));
    }
    Box grown(float by) const { return {low - by, high + by}; }
    /// A box that contains the image of this one.
    Box mapped(const Affine& map) const;
};

/// Triangles of a surface in Morton order (Lauterbach et al., "Fast BVH Construction on GPUs", CGF 2009), with boxes
/// over runs of 1, 2, 4, ... leaves. Object space.
struct TriangleTree {
    static constexpr Index leaf_size = 4;

    Array<Index> order;  ///< triangles in Morton order; leaf i is the run of leaf_size that starts at leaf_size * i
    Array<Box> boxes;    ///< per entry of `order`
    std::vector<Array<Box>>
        levels;  ///< node j of level k bounds nodes 2 j and 2 j + 1 of level k - 1; the last has one

    bool empty() const { return levels.empty(); }
    const Box& bounds() const { return levels.back()[0]; }
    /// The highest level with at least `nodes` nodes, else the leaves.
    Index level_of(std::size_t nodes) const {
        Index level = static_cast<Index>(levels.size()) - 1;
        while (level > 0 && levels[level].size() < nodes) --level;
        return level;
    }
};

/// Cached with the surface.
std::shared_ptr<const TriangleTree> triangle_tree(const Surface& surface);

/// Simultaneous traversal of two trees: calls visit(i, j, out) for the positions in `order` of all triangles i of `a`
/// and j of `b` whose boxes overlap when those of `b` are grown by `margin`. `b_to_a` maps object space of b to that of
/// a. With `within` (a and b are the same tree, and the map is not used) every pair comes once, with i < j. The work is
/// divided into blocks that do not depend on the number of threads.
template <typename Visit>
class TreeMeeting {
   public:
    TreeMeeting(const TriangleTree& a, const TriangleTree& b, const Affine& b_to_a, float margin, bool within,
                const Visit& visit)
        : a_(a), b_(b), b_to_a_(b_to_a), margin_(margin), within_(within), visit_(visit) {}

    std::size_t block_count() const { return a_.levels[start_a_].size() * b_.levels[start_b_].size(); }
    template <typename Out>
    void block(std::size_t block, Out& out) const {
        const std::size_t parts = b_.levels[start_b_].size();
        const Index b = static_cast<Index>(block % parts);
        nodes(start_a_, static_cast<Index>(block / parts), start_b_, b, of_b(b_.levels[start_b_][b]), out);
    }

   private:
    Box of_b(const Box& box) const { return (within_ ? box : box.mapped(b_to_a_)).grown(margin_); }

    /// `box_b`: box of node b, mapped and grown by of_b.
    template <typename Out>
    void nodes(Index level_a, Index a, Index level_b, Index b, const Box& box_b, Out& out) const {
        // All of b precedes a: these pairs come in the other order.
        if (within_ && (std::uint64_t(b) + 1) << level_b <= std::uint64_t(a) << level_a) return;
        if (!a_.levels[level_a][a].meets(box_b)) return;
        if (level_a == 0 && level_b == 0) {
            leaves(a, b, out);
        } else if (level_a >= level_b) {
            for (Index child = 2 * a; child < std::min<std::size_t>(2 * a + 2, a_.levels[level_a - 1].size()); ++child)
                nodes(level_a - 1, child, level_b, b, box_b, out);
        } else {
            const Array<Box>& below = b_.levels[level_b - 1];
            for (Index child = 2 * b; child < std::min<std::size_t>(2 * b + 2, below.size()); ++child)
                nodes(level_a, a, level_b - 1, child, of_b(below[child]), out);
        }
    }

    template <typename Out>
    void leaves(Index a, Index b, Out& out) const {
        constexpr Index size = TriangleTree::leaf_size;
        const Index end_a = std::min<std::size_t>(size * (a + 1), a_.order.size());
        const Index end_b = std::min<std::size_t>(size * (b + 1), b_.order.size());
        for (Index j = size * b; j < end_b; ++j) {
            const Box box = of_b(b_.boxes[j]);
            if (!a_.levels[0][a].meets(box)) continue;
            for (Index i = size * a; i < (within_ ? std::min(end_a, j) : end_a); ++i)
                if (a_.boxes[i].meets(box)) visit_(i, j, out);
        }
    }

    const TriangleTree &a_, &b_;
    const Affine& b_to_a_;
    const float margin_;
    const bool within_;
    const Visit& visit_;
    const Index start_a_ = a_.level_of(64), start_b_ = b_.level_of(8);
};

}  // namespace fovea::scene
