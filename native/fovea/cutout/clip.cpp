// SPDX-License-Identifier: GPL-3.0-or-later
// Weiler & Atherton, "Hidden surface removal using polygon area sorting", SIGGRAPH 1977: outlines from where they enter
// the triangle to where they leave it, closed along its sides. Which segment crosses which side is decided in integers,
// and equally from both triangles at the side.
#include <fovea/cutout/clip.h>

#include <algorithm>
#include <tuple>

namespace fovea::cutout {
namespace {

/// A side of a triangle, from its lower vertex to its higher one.
struct Side {
    Point low, high;
    bool turned;  ///< counterclockwise it runs from high to low
    bool left_is_inside;

    bool left_of(const Point& p) const { return turn(low, high, p) >= 0; }
    bool inside(const Point& p) const { return left_of(p) == left_is_inside; }
};

/// Where an outline crosses a side.
struct Crossing {
    Index segment;
    int side;
    double t;     ///< from the side's lower vertex
    bool enters;  ///< the triangle
    bool used = false;
};

class Clipper {
   public:
    Clipper(const TextureTriangle& triangle, const Outlines& outlines) : outlines_(outlines), triangle_(triangle) {
        const auto& c = triangle.corner;
        area_ = turn(c[0], c[1], c[2]);
        mirrored_ = area_ < 0;
        if (mirrored_) std::swap(order_[1], order_[2]);
        for (int k = 0; k < 3; ++k) {
            const int from = order_[k], to = order_[(k + 1) % 3];
            Side& side = sides_[k];
            side.turned = triangle.vertex[to] < triangle.vertex[from];
            side.low = c[side.turned ? to : from];
            side.high = c[side.turned ? from : to];
            side.left_is_inside = !side.turned;
            box_.add(c[k]);
        }
    }

    Clipped clip(std::vector<Index>& scratch) {
        if (area_ == 0) return untouched();
        outlines_.each_segment(box_, scratch, [&](Index i) { find_crossings(i); });
        if (!pair_up()) return {Clipped::whole, {}};
        sort_around();
        Pieces pieces = along_sides();
        if (broken_) return {Clipped::whole, {}};
        Pieces islands, holes;
        find_loops_inside(islands, holes);
        if (crossings_.empty() && islands.empty() && holes.empty()) return untouched();
        if (crossings_.empty() && outlines_.opaque(triangle_.corner[0])) pieces.push_back(whole_triangle());
        pieces.insert(pieces.end(), islands.begin(), islands.end());
        join_holes(pieces, holes);
        if (mirrored_)
            for (auto& piece : pieces) std::reverse(piece.begin(), piece.end());
        return {Clipped::part, std::move(pieces)};
    }

   private:
    Clipped untouched() const {
        return {outlines_.opaque(triangle_.corner[0]) ? Clipped::whole : Clipped::nothing, {}};
    }

    bool contains(const Point& p) const { return sides_[0].inside(p) && sides_[1].inside(p) && sides_[2].inside(p); }

    void find_crossings(Index i) {
        const Point &p = outlines_.points()[i], &q = outlines_.points()[outlines_.next(i)];
        for (int k = 0; k < 3; ++k) {
            const Side& side = sides_[k];
            if (side.left_of(p) == side.left_of(q)) continue;
            const std::int64_t low = turn(p, q, side.low), high = turn(p, q, side.high);
            if ((low >= 0) == (high >= 0)) continue;
            crossings_.push_back({i, k, double(low) / (double(low) - double(high)), side.inside(q)});
        }
    }

    /// Puts the crossings in the order in which the outlines pass them; false if they do not alternate, which happens
    /// only where an outline and a side lie on one line.
    bool pair_up() {
        std::sort(crossings_.begin(), crossings_.end(), [](const Crossing& a, const Crossing& b) {
            return std::tuple(a.segment, !a.enters, a.side) < std::tuple(b.segment, !b.enters, b.side);
        });
        for (std::size_t i = 0; i < crossings_.size(); ++i) {
            const Crossing& here = crossings_[i];
            const bool alone = i + 1 == crossings_.size() || crossings_[i + 1].segment != here.segment;
            if (alone) {
                const Index end = here.enters ? outlines_.next(here.segment) : here.segment;
                if (!contains(outlines_.points()[end])) return false;
            } else {
                const Crossing& other = crossings_[i + 1];
                const bool third = i + 2 < crossings_.size() && crossings_[i + 2].segment == here.segment;
                if (third || here.enters == other.enters) return false;
                ++i;
            }
        }
        return true;
    }

    /// Place of a crossing along the triangle's sides, counterclockwise.
    std::pair<int, double> around(Index crossing) const {
        const Crossing& c = crossings_[crossing];
        return {c.side, sides_[c.side].turned ? -c.t : c.t};
    }

    void sort_around() {
        for (Index i = 0; i < crossings_.size(); ++i) ring_.push_back(i);
        std::sort(ring_.begin(), ring_.end(),
                  [&](Index a, Index b) { return std::tuple(around(a), a) < std::tuple(around(b), b); });
        place_.resize(ring_.size());
        for (Index i = 0; i < ring_.size(); ++i) place_[ring_[i]] = i;
    }

    PieceCorner corner(int number) const {
        return {PieceCorner::at_corner, Index(order_[number]), 0.0, dvec2(triangle_.corner[order_[number]])};
    }
    PieceCorner on_side(const Crossing& c) const {
        const Side& side = sides_[c.side];
        // Sides are numbered as in the triangle, whose order may be mirrored.
        const int number = mirrored_ ? 2 - c.side : c.side;
        return {PieceCorner::on_side, Index(number), c.t, glm::mix(dvec2(side.low), dvec2(side.high), c.t)};
    }
    PieceCorner inside(Index point) const {
        return {PieceCorner::inside, point, 0.0, dvec2(outlines_.points()[point])};
    }

    std::vector<PieceCorner> whole_triangle() const { return {corner(0), corner(1), corner(2)}; }

    /// The crossing at which the outline leaves that entered at this one; appends its points between. `none`: nowhere.
    Index follow(Index entry, std::vector<PieceCorner>& piece) const {
        const Index first = crossings_[entry].segment;
        for (Index segment = first;;) {
            const auto at = std::lower_bound(crossings_.begin(), crossings_.end(), segment,
                                             [](const Crossing& c, Index wanted) { return c.segment < wanted; });
            for (auto c = at; c != crossings_.end() && c->segment == segment; ++c)
                if (!c->enters) return Index(c - crossings_.begin());
            segment = outlines_.next(segment);
            if (segment == first) return none;
            piece.push_back(inside(segment));
        }
    }

    Pieces along_sides() {
        Pieces pieces;
        for (Index start = 0; start < crossings_.size(); ++start) {
            if (crossings_[start].enters || crossings_[start].used) continue;
            auto& piece = pieces.emplace_back();
            Index exit = start;
            do {
                crossings_[exit].used = true;
                piece.push_back(on_side(crossings_[exit]));
                const Index entry = ring_[(place_[exit] + 1) % ring_.size()];
                if (!crossings_[entry].enters || crossings_[entry].used) {
                    broken_ = true;
                    return {};
                }
                add_corners(crossings_[exit], entry, place_[entry] <= place_[exit], piece);
                crossings_[entry].used = true;
                piece.push_back(on_side(crossings_[entry]));
                exit = follow(entry, piece);
                broken_ = exit == none;
                if (broken_) return {};
            } while (exit != start);
        }
        return pieces;
    }

    /// Corners of the triangle between two crossings.
    void add_corners(const Crossing& from, Index to, bool all_round, std::vector<PieceCorner>& piece) const {
        const int sides = crossings_[to].side - from.side + (all_round ? 3 : 0);
        for (int k = 1; k <= sides; ++k) piece.push_back(corner((from.side + k) % 3));
    }

    void find_loops_inside(Pieces& islands, Pieces& holes) const {
        for (Index i = 0; i < outlines_.loop_count(); ++i) {
            if (!outlines_.box(i).meets(box_)) continue;
            const Index first = outlines_.first(i), count = Index(outlines_.loop(i).size());
            if (!contains(outlines_.loop(i)[0])) continue;
            const auto crossed = std::lower_bound(crossings_.begin(), crossings_.end(), first,
                                                  [](const Crossing& c, Index wanted) { return c.segment < wanted; });
            if (crossed != crossings_.end() && crossed->segment < first + count) continue;
            std::vector<PieceCorner> loop;
            for (Index p = first; p < first + count; ++p) loop.push_back(inside(p));
            (area(loop) > 0.0 ? islands : holes).push_back(std::move(loop));
        }
    }

    static double area(const std::vector<PieceCorner>& loop) {
        double sum = 0.0;
        for (std::size_t i = 0; i < loop.size(); ++i)
            sum += cross(loop[i].place - loop[0].place, loop[(i + 1) % loop.size()].place - loop[0].place);
        return sum;
    }

    static bool surrounds(const std::vector<PieceCorner>& piece, const dvec2& at) {
        bool within = false;
        for (std::size_t i = 0; i < piece.size(); ++i) {
            const dvec2 &a = piece[i].place, &b = piece[(i + 1) % piece.size()].place;
            if ((a.y > at.y) != (b.y > at.y)) within ^= (cross(b - a, at - a) > 0.0) == (b.y > a.y);
        }
        return within;
    }

    /// Each hole goes to the smallest piece around it.
    static void join_holes(Pieces& pieces, const Pieces& holes) {
        std::vector<Pieces> of(pieces.size());
        for (const auto& hole : holes) {
            std::size_t best = pieces.size();
            for (std::size_t i = 0; i < pieces.size(); ++i)
                if (surrounds(pieces[i], hole[0].place) &&
                    (best == pieces.size() || area(pieces[i]) < area(pieces[best])))
                    best = i;
            if (best < pieces.size()) of[best].push_back(hole);
        }
        for (std::size_t i = 0; i < pieces.size(); ++i) {
            // From the right, so that each seam has its hole's neighbors on the right in the polygon already.
            const auto right = [](const auto& hole) {
                double x = hole[0].place.x;
                for (const PieceCorner& c : hole) x = std::max(x, c.place.x);
                return x;
            };
            std::stable_sort(of[i].begin(), of[i].end(),
                             [&](const auto& a, const auto& b) { return right(a) > right(b); });
            while (!of[i].empty()) {
                const auto hole = std::move(of[i].front());
                of[i].erase(of[i].begin());
                join_hole(pieces[i], hole, of[i]);
            }
        }
    }

    const Outlines& outlines_;
    const TextureTriangle& triangle_;
    std::int64_t area_;
    bool mirrored_, broken_ = false;
    std::array<int, 3> order_{0, 1, 2};  // corners, counterclockwise
    std::array<Side, 3> sides_;
    Box box_;
    std::vector<Crossing> crossings_;  // by segment
    std::vector<Index> ring_, place_;  // crossings counterclockwise around the triangle, and the place of each
};

}  // namespace

Clipped clip(const TextureTriangle& triangle, const Outlines& outlines, std::vector<Index>& scratch) {
    return Clipper(triangle, outlines).clip(scratch);
}

}  // namespace fovea::cutout
