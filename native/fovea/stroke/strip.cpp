// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/stroke/strip.h>

#include <algorithm>
#include <cmath>

#include <fovea/base/elementary.h>
#include <fovea/base/steps.h>

namespace fovea::stroke {

namespace {

constexpr double stretch_limit = 0.87;   // cosine of the bend up to which u is shared by both segments: 30 degrees
constexpr double reverse_limit = -0.87;  // cosine of the sharpest bend whose inner corner is shared: 150 degrees
constexpr double round_error = 0.1;      // px between a round join and its polygon
constexpr int most_steps = 1024;         // of half of a round join
constexpr double fringe = 0.5;           // px added for antialiasing
constexpr Index largest_group = 32;      // points that may share a corner

dvec2 left_of(dvec2 d) { return {-d.y, d.x}; }

/// Vertices on one side of the strip at a point: of the segment that ends there, and of the one that starts there.
struct Corners {
    Index before = none, after = none;
    /// The segments end square, with two vertices in different positions.
    bool square = false;
};

/// Consecutive points that share a corner on one side, because there is no room on that side for each to have its own.
struct Group {
    Index first, last;
    dvec2 corner;
    bool shared;  // false: every segment ends square, and they may overlap
};

class Strip {
   public:
    Strip(In<CenterPoint> line, bool closed, const StripEnds& ends, Strokes& out)
        : line_(line), closed_(closed), ends_(ends), out_(out), size_(Index(line.size())) {
        directions_.reserve(size_ - 1);
        for (Index i = 0; i + 1 < size_; ++i) directions_.push_back(glm::normalize(line[i + 1].px - line[i].px));
        middle_.assign(size_, none);
    }

    void build() {
        const auto left = side(1.0), right = side(-1.0);
        for (Index i = 0; i + 1 < size_; ++i) {
            segment(left[i].after, middle_[i], right[i].after, left[i + 1].before, middle_[i + 1], right[i + 1].before);
            if (i + 2 < size_ || closed_) {
                fan(i + 1, left[i + 1], 1.0);
                fan(i + 1, right[i + 1], -1.0);
            }
        }
    }

   private:
    double reach(Index i) const { return line_[i].half_width + fringe; }
    /// Directions of the segments before and after a point; equal at an end.
    dvec2 into(Index i) const { return i > 0 ? directions_[i - 1] : closed_ ? directions_.back() : directions_[0]; }
    dvec2 out_of(Index i) const {
        return i + 1 < size_ ? directions_[i] : closed_ ? directions_[0] : directions_.back();
    }
    dvec2 square(Index i, dvec2 direction, double side) const {
        return line_[i].px + side * reach(i) * left_of(direction);
    }

    /// Corner shared by points first .. last: intersection of the strip's edges before and after them.
    Group group(Index first, Index last, double side) const {
        const dvec2 a = into(first), b = out_of(last);
        const dvec2 from = square(first, a, side), to = square(last, b, side);
        const double turn = cross(a, b);
        Group g{first, last, 0.5 * (from + to), glm::dot(a, b) > reverse_limit};
        if (first == last && g.shared) {
            g.corner = line_[first].px + side * reach(first) * left_of(a + b) / (1.0 + glm::dot(a, b));
        } else if (g.shared && std::abs(turn) > 0.05) {
            g.corner = from + a * (cross(to - from, b) / turn);
            const double far = 4.0 * std::max(reach(first), reach(last));
            g.shared = glm::distance(g.corner, line_[first].px) < far + glm::distance(from, to);
        }
        return g;
    }

    /// Whether this is the outer side of a bend too sharp to be mitred.
    bool is_round(Index i, double side) const {
        const dvec2 a = into(i), b = out_of(i);
        const double turn = cross(a, b);
        return glm::dot(a, b) < mitre_limit && (turn < 0.0 ? side > 0.0 : side < 0.0);
    }

    bool has_corner(const Group& g, double side) const {
        return g.shared && (g.first != g.last || !is_round(g.first, side));
    }
    dvec2 corner_before(const Group& g, double side) const {
        return has_corner(g, side) ? g.corner : square(g.first, into(g.first), side);
    }
    dvec2 corner_after(const Group& g, double side) const {
        return has_corner(g, side) ? g.corner : square(g.last, out_of(g.last), side);
    }

    /// Whether the corner is about as far from all segments that end in it as the side of the strip.
    bool lies_beside(const Group& g, double side) const {
        if (g.last - g.first > largest_group) return false;
        for (Index i = g.first; i < g.last; ++i)
            if (side * cross(directions_[i], g.corner - line_[i].px) < 0.8 * reach(i)) return false;
        return true;
    }

    /// Merges points until no segment between two groups runs backwards along this side.
    std::vector<Group> groups(double side) const {
        std::vector<Group> result;
        for (Index i = 0; i < size_; ++i) {
            result.push_back(group(i, i, side));
            while (result.size() > 1) {
                const Group &a = result[result.size() - 2], &b = result.back();
                const dvec2 along = corner_before(b, side) - corner_after(a, side);
                if (glm::dot(along, directions_[a.last]) >= 0.0) break;
                Group merged = group(a.first, b.last, side);
                // The ends of a line stay where they are.
                const bool start = a.first == 0, end = b.last + 1 == size_;
                if (start || end) merged.corner = start ? corner_after(a, side) : corner_before(b, side);
                merged.shared =
                    a.shared && b.shared && (start || end ? start != end : merged.shared) && lies_beside(merged, side);
                result.resize(result.size() - 2);
                result.push_back(merged);
            }
        }
        return result;
    }

    /// Corners at every point on one side (1: left, -1: right).
    std::vector<Corners> side(double side) {
        std::vector<Corners> corners(size_);
        for (const Group& g : groups(side)) {
            if (has_corner(g, side))
                shared_corner(g, side, corners);
            else
                for (Index i = g.first; i <= g.last; ++i) square_corners(i, side, corners[i]);
        }
        return corners;
    }

    void shared_corner(const Group& g, double side, std::vector<Corners>& corners) {
        const CenterPoint &p = line_[g.first], &q = line_[g.last];
        const bool merged = g.first != g.last, start = g.first == 0, end = g.last + 1 == size_;
        const dvec2 a = into(g.first), b = out_of(g.last);
        const CenterPoint mean{.px = p.px,
                               .arc = 0.5 * (p.arc + q.arc),
                               .half_width = 0.5f * (p.half_width + q.half_width),
                               .opacity = 0.5f * (p.opacity + q.opacity),
                               .mix = 0.5f * (p.mix + q.mix),
                               .faint = 0.5f * (p.faint + q.faint),
                               .tint = 0.5f * (p.tint + q.tint),
                               .color = 0.5 * (p.color + q.color),
                               .along = 0.5 * (p.along + q.along),
                               .whole_px = 0.5 * (p.whole_px + q.whole_px),
                               .way = p.way};
        const CenterPoint& middle = merged && start ? p : merged && end ? q : mean;
        Corners split;
        if (glm::dot(a, b) > stretch_limit || (merged && (start || end))) {
            split.before = split.after = vertex(middle, g.corner, middle.arc, side);
        } else {  // u is exact on both sides of the bend, and discontinuous between them
            split.before = vertex(p, g.corner, within(p.arc + glm::dot(g.corner - p.px, a)), side);
            split.after = vertex(q, g.corner, within(q.arc + glm::dot(g.corner - q.px, b)), side);
        }
        for (Index i = g.first; i <= g.last; ++i) {
            corners[i] = {i == g.first ? split.before : split.after, split.after, false};
            if (merged || is_round(i, -side)) need_middle(i);
        }
    }

    void square_corners(Index i, double side, Corners& corners) {
        const CenterPoint& p = line_[i];
        corners.before = vertex(p, square(i, into(i), side), p.arc, side);
        corners.after = vertex(p, square(i, out_of(i), side), p.arc, side);
        corners.square = true;
        need_middle(i);
    }

    void need_middle(Index i) {
        if (middle_[i] == none) middle_[i] = vertex(line_[i], line_[i].px, line_[i].arc, 0.0);
    }

    /// Clamps u to the run, so that caps do not cut bends near the ends of a stroke.
    double within(double u) const {
        return std::clamp(u, double(ends_.start), std::max<double>(ends_.start, ends_.end));
    }

    /// Adds a vertex on a side of the strip; side 0: on the center line.
    Index vertex(const CenterPoint& p, dvec2 px, double u, double side) {
        out_.px.push_back(vec2(px));
        out_.arc.push_back({float(u), float(side * (p.half_width + fringe)), ends_.start, ends_.end});
        out_.half_width.push_back(p.half_width);
        out_.opacity.push_back(p.opacity);
        out_.mix.push_back({p.mix.x, p.mix.y, p.tint, p.faint});
        CenterPoint here = p;
        here.go(u - p.arc);
        out_.anchor.push_back({float(here.along), float(here.whole_px)});
        out_.pen.push_back(ends_.pen);
        if (ends_.colored) out_.color.push_back(vec3(p.color));
        return Index(out_.px.size()) - 1;
    }

    void triangle(Index a, Index b, Index c) {
        if (a != b && b != c && c != a) out_.triangles.push_back({a, b, c});
    }

    /// Triangles of a segment between two cross sections, each with or without a middle vertex.
    void segment(Index l0, Index m0, Index r0, Index l1, Index m1, Index r1) {
        if (m0 == none && m1 == none) {
            triangle(l0, r0, l1);
            triangle(r0, r1, l1);
        } else if (m0 != none) {
            triangle(l0, m0, l1);
            if (m1 != none) triangle(m0, m1, l1);
            triangle(m0, r0, r1);
            triangle(m0, r1, m1 != none ? m1 : l1);
        } else {
            triangle(l0, m1, l1);
            triangle(l0, r0, m1);
            triangle(r0, r1, m1);
        }
    }

    /// Fills the wedge on the outer side of a bend whose segments end square. u continues from either segment to the
    /// middle of the wedge.
    void fan(Index i, const Corners& corners, double side) {
        const dvec2 a = into(i), b = out_of(i);
        const double turn = cross(a, b);
        if (!corners.square || (turn < 0.0 ? side < 0.0 : side > 0.0)) return;
        const double half = arc_cosine(std::clamp(glm::dot(a, b), -1.0, 1.0)) / 2.0;
        const double step = 2.0 * arc_cosine(1.0 - std::min(round_error / reach(i), 0.5));
        const int steps = steps_of(half / step, most_steps);
        const auto at = [&](double angle, double turned) {
            const double t = -side * angle, c = cosine(t), s = sine(t);
            const dvec2 direction(a.x * c - a.y * s, a.x * s + a.y * c);
            const double u = within(line_[i].arc + reach(i) * turned);
            return vertex(line_[i], square(i, direction, side), u, side);
        };
        Index last = corners.before;
        for (int k = 1; k <= 2 * steps; ++k) {
            if (k == steps + 1) last = at(half, -half);
            const double angle = half * k / steps;
            const Index next = k == 2 * steps ? corners.after : at(angle, k <= steps ? angle : angle - 2.0 * half);
            triangle(middle_[i], last, next);
            last = next;
        }
    }

    In<CenterPoint> line_;
    bool closed_;
    StripEnds ends_;
    Strokes& out_;
    Index size_;
    std::vector<dvec2> directions_;
    std::vector<Index> middle_;
};

}  // namespace

void add_strip(In<CenterPoint> line, bool closed, const StripEnds& ends, Strokes& out) {
    if (line.size() >= 2) Strip(line, closed, ends, out).build();
}

}  // namespace fovea::stroke
