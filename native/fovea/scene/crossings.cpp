// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/scene/crossings.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include <fovea/base/hash.h>
#include <fovea/base/parallel.h>
#include <fovea/scene/coincidence.h>
#include <fovea/scene/four_planes.h>
#include <fovea/scene/orientation.h>

namespace fovea::scene {
namespace {

/// Sine of the angle up to which two triangles, one of them within the tolerance of the other's plane, count as
/// coplanar.
constexpr double flat_sine = 0.01;

/// Corners of a triangle, rounded to the grid, and the surface it belongs to (0 first, 1 second).
struct Corners {
    dvec3 p[3];
    unsigned second;

    bool collapsed() const { return p[0] == p[1] || p[1] == p[2] || p[2] == p[0]; }
};

struct End {
    std::uint64_t id;
    dvec3 point;
};

/// A segment before its ends are numbered.
struct Piece {
    Index triangle[2];
    End end[2];
};

/// Grid that the vertices of both surfaces are rounded to: its step is a power of two, in the object space of the
/// first.
class Grid {
   public:
    Grid(const TriangleTree& first, const Box& second) {
        for (const Box& box : {first.bounds, second})
            for (int i = 0; i < 3; ++i)
                size_ = std::max({size_, std::abs(double(box.low[i])), std::abs(double(box.high[i]))});
        int exponent = 0;
        std::frexp(size_, &exponent);  // size_ < 2^exponent
        scale_ = std::ldexp(1.0, 38 - exponent);
    }
    bool usable() const { return size_ > 0.0 && size_ < 1e18; }
    /// Contact tolerance, and grid step; both in object space.
    double tolerance() const { return contact_tolerance * size_; }
    double step() const { return 1.0 / scale_; }

    /// Rounds to the grid. Zeros are positive, as positions are compared and hashed by their bits.
    dvec3 point(const dvec3& p) const {
        constexpr double units = 0x1.8p52;  // a sum with it has no digits below 1; |p * scale_| < 2^39
        return p * scale_ + units - units;
    }
    vec3 back(const dvec3& p) const { return vec3(p / scale_); }

   private:
    double scale_ = 1.0, size_ = 0.0;
};

/// Id of the intersection of a side with a triangle, hashed from their positions: equal for coincident ones.
std::uint64_t id_of(const dvec3& from, const dvec3& to, const Corners& t, bool within) {
    dvec3 at[5] = {from, to, t.p[0], t.p[1], t.p[2]};
    std::sort(at + 2, at + 5, before);
    return hash_bytes(at, sizeof(at), within ? 2 : t.second);
}

/// Computes where the side from corner k to k + 1 of `s` meets triangle `t`; false if it does not. `heights`:
/// orientation of the corners of s relative to t.
bool meet_side(const Corners& s, int k, const Orientation (&heights)[3], const Corners& t, bool within, End& end) {
    int i = k, j = (k + 1) % 3;
    if (heights[i].sign * heights[j].sign >= 0) return false;
    if (before(s.p[j], s.p[i])) std::swap(i, j);
    const unsigned second = within ? 0u : (s.second ? 3u : 12u);
    int sign = 0;
    for (int side = 0; side < 3; ++side) {
        const int turn = orientation({s.p[i], s.p[j], t.p[side], t.p[(side + 1) % 3]}, second).sign;
        if (turn == 0 || (sign != 0 && turn != sign)) return false;
        sign = turn;
    }
    const double fall = heights[i].value - heights[j].value;
    // a side in the triangle's plane: any point of it
    const double share = fall != 0.0 ? heights[i].value / fall : 0.5;
    end = {id_of(s.p[i], s.p[j], t, within), glm::mix(s.p[i], s.p[j], share)};
    return true;
}

/// Six times the signed volumes of the tetrahedra over a triangle, one per corner of another triangle, and which of the
/// volumes have a sign for sure.
struct Heights {
    dvec3 normal;  ///< of the triangle; length is twice its area
    double of[3] = {}, error[3] = {};
    double lowest = infinity, highest = -infinity;
    bool sure = true;

    /// Heights of the corners of `c`, except that which is `shared`, over the triangle `over`.
    Heights(const Corners& c, const Corners& over, int shared) {
        const dvec3 a = over.p[1] - over.p[0], b = over.p[2] - over.p[0];  // exact, as differences of grid points are
        const dvec3 first(a.y * b.z, a.z * b.x, a.x * b.y), second(a.z * b.y, a.x * b.z, a.y * b.x);
        normal = first - second;
        const dvec3 size = glm::abs(first) + glm::abs(second);
        for (int i = 0; i < 3; ++i) {
            if (i == shared) continue;
            const dvec3 along = c.p[i] - over.p[0];
            of[i] = glm::dot(normal, along);
            error[i] = orientation_error * glm::dot(size, glm::abs(along));
            lowest = std::min(lowest, of[i]);
            highest = std::max(highest, of[i]);
            sure = sure && std::abs(of[i]) > error[i];
        }
    }
    bool on_one_side() const { return sure && (lowest > 0.0 || highest < 0.0); }
    /// Whether no corner is farther than `distance` from the plane.
    bool within(double distance) const {
        const double farthest = std::max(-lowest, highest);
        return farthest * farthest <= distance * distance * squared(normal);
    }

    static double squared(const dvec3& v) { return glm::dot(v, v); }
};

/// Intersects pairs of triangles of two surfaces, or of one with itself (`within`).
class Finder {
   public:
    Finder(const Mapped& first, const Mapped& second, const Grid& grid, bool within)
        : mapped_{first, second}, grid_(grid), within_(within) {}

    void meet(Index first, Index second, Array<Piece>& out) const {
        const Corners a = on_grid(0, first), b = on_grid(1, second);
        if (a.collapsed() || b.collapsed()) return;
        int shared_a = -1, shared_b = -1;
        const auto take = [&](int i, int j) { std::tie(shared_a, shared_b) = std::pair(i, j); };
        if (within_ && count_shared(a, b, take) > 1) return;
        const Heights over_a(b, a, shared_b);
        if (over_a.on_one_side()) return;
        const Heights over_b(a, b, shared_a);
        if (over_b.on_one_side() || coplanar(over_a, over_b)) return;
        Orientation of_a[3], of_b[3];  // orientation of each corner relative to the other triangle
        if (!orient(over_a, b, shared_b, a, of_b) || !orient(over_b, a, shared_a, b, of_a)) return;
        End ends[6];
        int count = 0;
        for (int k = 0; k < 3; ++k) {
            count += meet_side(a, k, of_a, b, within_, ends[count]);
            count += meet_side(b, k, of_b, a, within_, ends[count]);
        }
        if (shared_a >= 0) ends[count++] = {hash_bytes(&a.p[shared_a], sizeof(dvec3)), a.p[shared_a]};
        if (count == 2) out.push_back({{first, second}, {ends[0], ends[1]}});
    }

   private:
    /// The map is applied to the second surface only.
    Corners on_grid(unsigned of, Index triangle) const {
        Corners corners;
        corners.second = of;
        const Surface& surface = mapped_[0].surface;
        for (int k = 0; k < 3; ++k)
            corners.p[k] = grid_.point(of == 1 && !within_ ? mapped_[1].corner(triangle, k)
                                                           : dvec3(surface.positions[surface.triangles[triangle][k]]));
        return corners;
    }

    /// Counts the corners of `a` that are corners of `b`, and calls found(i, j) for each.
    template <typename Found>
    static int count_shared(const Corners& a, const Corners& b, const Found& found) {
        int shared = 0;
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j) {
                if (a.p[i] != b.p[j]) continue;
                ++shared;
                found(i, j);
            }
        return shared;
    }

    /// Whether two triangles count as coplanar.
    bool coplanar(const Heights& over_a, const Heights& over_b) const {
        const double tolerance = grid_.tolerance() / grid_.step();
        const double of_normals = Heights::squared(over_a.normal) * Heights::squared(over_b.normal);  // lengths squared
        return (over_a.within(tolerance) || over_b.within(tolerance)) &&
               Heights::squared(glm::cross(over_a.normal, over_b.normal)) <= flat_sine * flat_sine * of_normals;
    }

    /// Orientation of the corners of `c` relative to `over`; false if all but the shared one are on one side.
    bool orient(const Heights& heights, const Corners& c, int shared, const Corners& over, Orientation (&of)[3]) const {
        const unsigned second = within_ ? 0u : (c.second ? 8u : 7u);
        bool above = false, below = false;
        for (int i = 0; i < 3; ++i) {
            if (i == shared)
                of[i] = {0.0, 0};
            else if (std::abs(heights.of[i]) > heights.error[i])
                of[i] = {-heights.of[i], heights.of[i] > 0.0 ? -1 : 1};
            else
                of[i] = orientation({over.p[0], over.p[1], over.p[2], c.p[i]}, second);
            above = above || of[i].sign > 0;
            below = below || of[i].sign < 0;
        }
        return above && below;
    }

    const Mapped mapped_[2];
    const Grid& grid_;
    const bool within_;
};

/// Numbers the ends of segments; removes duplicates, which arise where triangles coincide.
Crossings numbered(In<Piece> pieces, const Grid& grid) {
    struct Numbered {
        std::uint64_t id;
        Index end;  ///< 2 i + k is end k of piece i
    };
    Array<Numbered> ends(2 * pieces.size());
    for (Index i = 0; i < ends.size(); ++i) ends[i] = {pieces[i / 2].end[i % 2].id, i};
    parallel_sort(ends.begin(), ends.end(),
                  [](const Numbered& a, const Numbered& b) { return a.id != b.id ? a.id < b.id : a.end < b.end; });
    Crossings crossings(pieces.size());
    Index number = 0;
    for (std::size_t i = 0; i < ends.size(); ++i) {
        number += i > 0 && ends[i].id != ends[i - 1].id;
        crossings[ends[i].end / 2].end[ends[i].end % 2] = number;
    }
    for (std::size_t i = 0; i < pieces.size(); ++i)
        for (int k = 0; k < 2; ++k) {
            crossings[i].triangle[k] = pieces[i].triangle[k];
            crossings[i].point[k] = grid.back(pieces[i].end[k].point);
        }
    std::vector<std::pair<std::uint64_t, Index>> same(crossings.size());
    for (Index i = 0; i < same.size(); ++i) {
        const auto [low, high] = std::minmax(crossings[i].end[0], crossings[i].end[1]);
        same[i] = {std::uint64_t(low) << 32 | high, i};
    }
    parallel_sort(same.begin(), same.end());
    Array<std::uint8_t> again(crossings.size(), 0);
    for (std::size_t i = 1; i < same.size(); ++i) again[same[i].second] = same[i].first == same[i - 1].first;
    return values_where(crossings, [&](std::size_t i) { return !again[i]; });
}

/// Pairs of triangles in two leaves.
struct Leaves {
    const TriangleTree &a, &b;
    const Surface &surface_a, &surface_b;
    const SingleMap& b_to_a;
    float margin;  ///< exceeds what rounding to the grid moves a box by
    float step;    ///< of the grid
    bool within;

    /// A leaf of the second tree, in the object space of a.
    struct Second {
        Index leaf = none;
        FourTriangles corners;
        FourBoxes boxes;
    };

    /// Calls found(triangle of a, triangle of b) for the pairs that may cross. `second`: the last leaf of b, which
    /// comes with several of a, one after the other.
    template <typename Found>
    void each_pair(Index leaf_a, Index leaf_b, Second& second, const Found& found) const {
        const In<Index> in_a = a.leaf(leaf_a), in_b = b.leaf(leaf_b);
        const float error = within ? step : step + b_to_a.error();
        if (leaf_b != second.leaf) {
            const FourTriangles corners = corners_of(surface_b, in_b);
            second = {leaf_b, within ? corners : b_to_a.mapped(corners), {}};
            second.boxes = second.corners.boxes();
        }
        const FourTriangles corners_a = corners_of(surface_a, in_a);
        const FourBoxes boxes_a = corners_a.boxes();
        unsigned meeting[4] = {}, any = 0;
        // Lanes that are not used have boxes at infinity, which meet each other.
        const unsigned used_a = (1u << in_a.size()) - 1;
        for (int j = 0; j < int(in_b.size()); ++j) {
            meeting[j] = boxes_a.meeting(second.boxes[j].grown(margin + error)) & used_a;
            if (within && leaf_a == leaf_b) meeting[j] &= (1u << j) - 1;
            any |= meeting[j];
        }
        if (any == 0) return;
        const FourPlanes planes(corners_a, error, within);
        for (int j = 0; j < 4; ++j)
            if (meeting[j] != 0)
                for_each_lane(planes.may_cross(meeting[j], second.corners, j), [&](int i) { found(in_a[i], in_b[j]); });
    }
};

Crossings find(const Mapped& first, const Mapped& second, bool within, const Cancel& cancel) {
    const auto tree_a = triangle_tree(first.surface), tree_b = triangle_tree(second.surface);
    if (tree_a->empty() || tree_b->empty()) return {};
    const Grid grid(*tree_a, tree_b->bounds.mapped(second.map));
    if (!grid.usable()) return {};
    const SingleMap single(second.map, tree_b->bounds);
    // Corners of one surface are on the grid, or finer numbers than its step: a vertex far away makes the tolerance
    // large, within which all of the rest may be.
    const float margin = static_cast<float>(within ? grid.step() : grid.tolerance());
    const Leaves leaves{
        *tree_a, *tree_b, first.surface, second.surface, single, margin, static_cast<float>(grid.step()), within};
    const Finder finder(first, second, grid, within);
    const TreeMeeting meeting(*tree_a, *tree_b, single, leaves.margin, within);
    const auto pieces = parallel_collect<Piece>(meeting.block_count(), 1, [&](std::size_t b, std::size_t, auto& out) {
        cancel.poll();
        Leaves::Second second;
        meeting.block(b, [&](Index i, Index j) {
            leaves.each_pair(i, j, second, [&](Index s, Index t) { finder.meet(s, t, out); });
        });
    });
    const Crossings crossings = without_contact(numbered(pieces, grid), first, second, grid.tolerance());
    return within ? crossings : without_coincidence(crossings, first, second, cancel);
}

}  // namespace

Crossings cross(const Surface& first, const Surface& second, const Affine& second_to_first, const Cancel& cancel) {
    return find({first, Affine(1.0)}, {second, second_to_first}, false, cancel);
}

Crossings cross_itself(const Surface& surface, const Cancel& cancel) {
    return find({surface, Affine(1.0)}, {surface, Affine(1.0)}, true, cancel);
}

}  // namespace fovea::scene
