// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/scene/triangle_tree.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <limits>

namespace fovea::scene {
namespace {

/// Number of pairs of nodes from which the work is not divided further.
constexpr std::size_t enough_blocks = 64;

Array<Index> triangle_order(const Surface& surface) {
    return morton_order(surface.triangles.size(), dvec3(surface.center), surface.radius, [&](std::size_t i) -> Box {
        const Triangle& t = surface.triangles[i];
        const vec3 &a = surface.positions[t.x], &b = surface.positions[t.y], &c = surface.positions[t.z];
        return {glm::min(a, glm::min(b, c)), glm::max(a, glm::max(b, c))};
    });
}

/// Whether two triangles have the same corners, in whatever order.
bool coincide(const Surface& surface, Index a, Index b) {
    const Triangle &s = surface.triangles[a], &t = surface.triangles[b];
    for (int i = 0; i < 3; ++i) {
        const vec3& corner = surface.positions[s[i]];
        if (corner != surface.positions[t.x] && corner != surface.positions[t.y] && corner != surface.positions[t.z])
            return false;
    }
    return true;
}

/// The corner of a triangle's box with the least coordinates.
vec3 least_corner(const Surface& surface, Index triangle) {
    const Triangle& t = surface.triangles[triangle];
    return glm::min(surface.positions[t.x], glm::min(surface.positions[t.y], surface.positions[t.z]));
}

/// Of triangles that coincide, leaves out those beyond the `crowd` first. In Morton order they follow each other, with
/// others of the same box between them at most, so each is held against the last few that differ.
void leave_out_repeated(const Surface& surface, Array<Index>& order) {
    constexpr int crowd = 16;
    constexpr std::size_t last_few = 8;
    // In nearly all surfaces no triangle coincides with one of the last few before it: then nothing is left out.
    std::atomic<bool> any = false;
    parallel_blocks(order.size(), 1 << 14, [&](std::size_t, std::size_t begin, std::size_t end) {
        std::array<vec3, last_few> last;
        last.fill(vec3(infinity));
        bool met = false;
        for (std::size_t i = begin - std::min(begin, last_few); i < end; ++i) {
            const vec3 least = least_corner(surface, order[i]);
            for (std::size_t k = 1; k <= std::min(i, last_few); ++k)
                if (least == last[(i - k) % last_few]) met |= coincide(surface, order[i - k], order[i]);
            last[i % last_few] = least;
        }
        if (met) any.store(true, std::memory_order_relaxed);
    });
    if (!any) return;
    struct Place {
        Index triangle = none;
        vec3 least{0.0f};  // tells most that differ
        int met = 0;
    };
    std::array<Place, last_few> last;
    std::size_t kept = 0, next = 0;
    for (const Index triangle : order) {
        const vec3 least = least_corner(surface, triangle);
        const auto place = std::ranges::find_if(last, [&](const Place& place) {
            return place.least == least && place.triangle != none && coincide(surface, place.triangle, triangle);
        });
        if (place == last.end()) last[next++ % last.size()] = {triangle, least, 0};
        if (place == last.end() || ++place->met < crowd) order[kept++] = triangle;
    }
    order.resize(kept);
}

/// Boxes of the triangles of a leaf; a lane that is not used has the empty box.
FourBoxes used_boxes(const FourTriangles& leaf) {
    FourBoxes boxes = leaf.boxes();
    for (Four& high : boxes.high) high = high == infinity ? four(-infinity) : high;
    return boxes;
}

TriangleTree make_tree(const Surface& surface) {
    TriangleTree tree;
    tree.order = triangle_order(surface);
    leave_out_repeated(surface, tree.order);
    if (tree.order.empty()) return tree;
    const std::size_t leaves = (tree.order.size() + 3) / 4;
    const auto box = [&](std::size_t i) { return around(used_boxes(corners_of(surface, tree.leaf(Index(i))))); };
    tree.levels = levels_over(parallel_map<Box>(leaves, box), tree.bounds);
    return tree;
}

}  // namespace

FourTriangles corners_of(const Surface& surface, In<Index> triangles) {
    FourTriangles found;
    for (auto& corner : found.corner) std::ranges::fill(corner, four(infinity));
    for (std::size_t lane = 0; lane < triangles.size(); ++lane)
        for (int k = 0; k < 3; ++k) {
            const vec3& corner = surface.positions[surface.triangles[triangles[lane]][k]];
            for (int axis = 0; axis < 3; ++axis) found.corner[k][axis][lane] = corner[axis];
        }
    return found;
}

FourBoxes FourTriangles::boxes() const {
    FourBoxes boxes;
    for (int axis = 0; axis < 3; ++axis) {
        boxes.low[axis] = lesser(corner[0][axis], lesser(corner[1][axis], corner[2][axis]));
        boxes.high[axis] = greater(corner[0][axis], greater(corner[1][axis], corner[2][axis]));
    }
    return boxes;
}

SingleMap::SingleMap(const Affine& map, const Box& bounds) {
    const dvec3 farthest = glm::max(glm::abs(dvec3(bounds.low)), glm::abs(dvec3(bounds.high)));
    double size = 0.0;  // of the largest sum of magnitudes
    for (int axis = 0; axis < 3; ++axis) {
        double sum = std::abs(map[3][axis]);
        for (int column = 0; column < 4; ++column) {
            m_[column][axis] = static_cast<float>(map[column][axis]);
            if (column < 3) sum += std::abs(map[column][axis]) * farthest[column];
        }
        size = std::max(size, sum);
    }
    // Three roundings of products and sums, and one of each coefficient; twice as much for boxes, from middle and half.
    error_ = static_cast<float>(8.0 * std::numeric_limits<float>::epsilon() * size);
}

FourTriangles SingleMap::mapped(const FourTriangles& triangles) const {
    FourTriangles image;
    for (int k = 0; k < 3; ++k) {
        const Four* p = triangles.corner[k];
        for (int axis = 0; axis < 3; ++axis)
            image.corner[k][axis] = m_[0][axis] * p[0] + m_[1][axis] * p[1] + m_[2][axis] * p[2] + m_[3][axis];
    }
    return image;
}

FourBoxes SingleMap::mapped(const FourBoxes& boxes) const {
    FourBoxes image;
    Four middle[3], half[3];
    for (int axis = 0; axis < 3; ++axis) {
        middle[axis] = 0.5f * (boxes.low[axis] + boxes.high[axis]);
        half[axis] = 0.5f * (boxes.high[axis] - boxes.low[axis]);
    }
    for (int axis = 0; axis < 3; ++axis) {
        Four at = four(m_[3][axis]), reach = four(error_);
        for (int column = 0; column < 3; ++column) {
            at += m_[column][axis] * middle[column];
            reach += std::abs(m_[column][axis]) * half[column];
        }
        image.low[axis] = at - reach;
        image.high[axis] = at + reach;
    }
    return image;
}

FourBoxes TreeMeeting::of_b(const FourBoxes& boxes) const {
    FourBoxes image = within_ ? boxes : b_to_a_.mapped(boxes);
    for (int axis = 0; axis < 3; ++axis) {
        image.low[axis] -= margin_;
        image.high[axis] += margin_;
    }
    return image;
}

TreeMeeting::TreeMeeting(const TriangleTree& a, const TriangleTree& b, const SingleMap& b_to_a, float margin,
                         bool within)
    : a_(a), b_(b), b_to_a_(b_to_a), margin_(margin), within_(within) {
    const auto high = [](const TriangleTree& tree) { return static_cast<Index>(tree.levels.size()); };
    constexpr float farthest = std::numeric_limits<float>::max();  // less than the corners of empty boxes
    const Box everywhere{vec3(-farthest), vec3(farthest)};
    blocks_.push_back({high(a), 0, high(b), 0, everywhere, everywhere});
    bool divided = true;
    while (divided && blocks_.size() < enough_blocks) {
        divided = false;
        for (const Pair& pair : std::exchange(blocks_, {})) {
            if (pair.of_leaves()) {
                blocks_.push_back(pair);
                continue;
            }
            divided = true;
            each_below(pair, [&](const Pair& below) { blocks_.push_back(below); });
        }
    }
}

std::shared_ptr<const TriangleTree> triangle_tree(const Surface& surface) {
    return surface.cache().get<TriangleTree>(0, [&] { return make_tree(surface); });
}

}  // namespace fovea::scene
