// SPDX-License-Identifier: GPL-3.0-or-later
// Tree of bounding boxes over triangles, to find the pairs of triangles of two surfaces that may intersect.
#pragma once

#include <fovea/mesh/surface.h>
#include <fovea/scene/box_tree.h>

namespace fovea::scene {

/// Corners of four triangles. A lane that is not used has all of them at infinity.
struct FourTriangles {
    Four corner[3][3];  ///< of corner and axis

    FourBoxes boxes() const;
    vec3 at(int lane, int k) const { return {corner[k][0][lane], corner[k][1][lane], corner[k][2][lane]}; }
};

/// Triangles of a surface in Morton order (Lauterbach et al., "Fast BVH Construction on GPUs", CGF 2009), with boxes
/// over runs of 4, 16, 64, ... of them. Object space.
struct TriangleTree {
    Array<Index> order;  ///< triangles in Morton order; of those that coincide, 16 at most
    /// Lane i of node j of levels[0] bounds leaf 4 j + i; of levels[k], node 4 j + i of levels[k - 1]. The last has one
    /// node; there are none above a single leaf.
    std::vector<Array<FourBoxes>> levels;
    Box bounds;

    bool empty() const { return order.empty(); }
    /// A leaf is four consecutive entries of `order`, fewer at its end.
    In<Index> leaf(Index number) const {
        const std::size_t begin = 4 * std::size_t(number);
        return {order.data() + begin, std::min<std::size_t>(4, order.size() - begin)};
    }
};

/// The corners of up to four triangles of a surface.
FourTriangles corners_of(const Surface& surface, In<Index> triangles);

/// Cached with the surface.
std::shared_ptr<const TriangleTree> triangle_tree(const Surface& surface);

/// An affine map in single precision, and the bound of its errors.
class SingleMap {
   public:
    /// For points in `bounds`.
    SingleMap(const Affine& map, const Box& bounds);
    /// Bound of the error of each coordinate of a mapped point.
    float error() const { return error_; }
    FourTriangles mapped(const FourTriangles& triangles) const;
    /// Boxes that contain the images.
    FourBoxes mapped(const FourBoxes& boxes) const;

   private:
    float m_[4][3];
    float error_;
};

/// Simultaneous traversal of two trees: calls visit(a, b) for all pairs of leaves in which the boxes of two triangles
/// overlap once those of `b` are mapped to the object space of a and grown by `margin`, or else for a few more. With
/// `within` (a and b are the same tree, and the map is not used) a <= b. The work is divided into blocks that do not
/// depend on the number of threads.
class TreeMeeting {
   public:
    TreeMeeting(const TriangleTree& a, const TriangleTree& b, const SingleMap& b_to_a, float margin, bool within);

    std::size_t block_count() const { return blocks_.size(); }
    template <typename Visit>
    void block(std::size_t block, const Visit& visit) const {
        descend(blocks_[block], visit);
    }

   private:
    /// A node of each tree. Level 0 are the leaves, level k nodes of levels[k - 1].
    struct Pair {
        Index level_a, a, level_b, b;
        Box box_a, box_b;  ///< in the object space of a; that of b is grown

        bool of_leaves() const { return level_a == 0 && level_b == 0; }
    };

    FourBoxes of_b(const FourBoxes& boxes) const;

    /// Calls found(pair) for the pairs of children that meet.
    template <typename Found>
    void each_below(const Pair& p, const Found& found) const {
        if (p.level_a > p.level_b) {
            const FourBoxes& boxes = a_.levels[p.level_a - 1][p.a];
            for_each_lane(boxes.meeting(p.box_b),
                          [&](int i) { found(Pair{p.level_a - 1, 4 * p.a + i, p.level_b, p.b, boxes[i], p.box_b}); });
            return;
        }
        const FourBoxes boxes_b = of_b(b_.levels[p.level_b - 1][p.b]);
        for_each_lane(boxes_b.meeting(p.box_a), [&](int j) {
            const Box box_b = boxes_b[j];
            if (p.level_b > p.level_a) {
                found(Pair{p.level_a, p.a, p.level_b - 1, 4 * p.b + j, p.box_a, box_b});
                return;
            }
            const FourBoxes& boxes_a = a_.levels[p.level_a - 1][p.a];
            unsigned meeting = boxes_a.meeting(box_b);
            if (within_ && p.a == p.b) meeting &= (2u << j) - 1;
            for_each_lane(meeting, [&](int i) {
                found(Pair{p.level_a - 1, 4 * p.a + i, p.level_b - 1, 4 * p.b + j, boxes_a[i], box_b});
            });
        });
    }

    template <typename Visit>
    void descend(const Pair& pair, const Visit& visit) const {
        if (pair.of_leaves())
            visit(pair.a, pair.b);
        else
            each_below(pair, [&](const Pair& below) { descend(below, visit); });
    }

    const TriangleTree &a_, &b_;
    const SingleMap& b_to_a_;
    const float margin_;
    const bool within_;
    std::vector<Pair> blocks_;
};

}  // namespace fovea::scene
