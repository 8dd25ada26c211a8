// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/path/chain_curves.h>

#include <algorithm>
#include <bit>

namespace fovea {
namespace {

/// One end of a piece: 2 piece + end.
using End = Index;

/// Ends by the side and level that they lie on: a table of sides, each where its hash says or in the next free place.
class EndsBySide {
   public:
    explicit EndsBySide(const Curves& pieces)
        : pieces_(pieces), places_(std::bit_ceil(4 * pieces.size() + 1), {none, none, 0}) {}

    struct Side {
        End first, second;  // the first two ends on it
        Index count;
    };

    void add(End e) {
        for (std::size_t i = place_of(e);; i = (i + 1) & (places_.size() - 1)) {
            Side& side = places_[i];
            if (side.count == 0) {
                side = {e, none, 1};
            } else if (same_side(side.first, e)) {
                if (side.count++ == 1) side.second = e;
            } else {
                continue;
            }
            return;
        }
    }

    const std::vector<Side>& sides() const { return places_; }

   private:
    std::size_t place_of(End e) const {
        const CurvePiece& piece = pieces_[e / 2];
        const std::uint64_t key = std::uint64_t(piece.level) << 32 | piece.side[e % 2];
        return (key * 0x9e3779b97f4a7c15u) >> 32 & (places_.size() - 1);
    }
    bool same_side(End a, End b) const {
        const CurvePiece &x = pieces_[a / 2], &y = pieces_[b / 2];
        return x.side[a % 2] == y.side[b % 2] && x.level == y.level;
    }

    const Curves& pieces_;
    std::vector<Side> places_;
};

/// Per end: the end of another piece that goes on from it, or `none`.
Array<End> link(const Curves& pieces) {
    EndsBySide ends(pieces);
    for (End e = 0; e < 2 * pieces.size(); ++e)
        if (pieces[e / 2].side[e % 2] != none) ends.add(e);
    Array<End> next(2 * pieces.size(), none);
    for (const EndsBySide::Side& side : ends.sides()) {
        if (side.count != 2) continue;
        next[side.first] = side.second;
        next[side.second] = side.first;
    }
    return next;
}

/// No two pieces have the same.
std::uint64_t key_of(const CurvePiece& piece) {
    return piece.other == none ? std::uint64_t(piece.level) << 32 | piece.triangle
                               : std::uint64_t(piece.triangle) << 32 | piece.other;
}

class Chainer {
   public:
    explicit Chainer(const Curves& pieces) : pieces_(pieces), next_(link(pieces)), used_(pieces.size(), 0) {}

    CurveChains run() {
        for (End e = 0; e < next_.size(); ++e)
            if (next_[e] == none && !used_[e / 2]) walk(e);
        for (Index i = 0; i < used_.size(); ++i)
            if (!used_[i]) walk(2 * i);
        return std::move(out_);
    }

   private:
    /// From an end along all pieces that follow.
    void walk(End start) {
        const Index first = static_cast<Index>(out_.point.size());
        std::uint64_t lowest = ~std::uint64_t(0);
        End from = start;
        while (true) {
            const Index i = from / 2;
            used_[i] = 1;
            const CurvePiece& piece = pieces_[i];
            lowest = std::min(lowest, key_of(piece));
            add(piece, from % 2);
            const End to = from ^ 1;
            from = next_[to];
            if (from != none && !used_[from / 2]) continue;
            add(piece, to % 2);
            out_.closed.push_back(from == start && out_.point.size() - first > 2);
            break;
        }
        out_.anchor.push_back(lowest);
        out_.rows.offsets.push_back(static_cast<Index>(out_.point.size()));
    }

    void add(const CurvePiece& piece, int end) {
        out_.point.push_back(piece.point[end]);
        out_.strength.push_back(piece.strength[end]);
        out_.triangle.push_back(piece.triangle);
        out_.side.push_back(piece.side[end]);
        out_.other.push_back(piece.other);
    }

    const Curves& pieces_;
    Array<End> next_;
    std::vector<std::uint8_t> used_;
    CurveChains out_;
};

}  // namespace

CurveChains chain_curves(const Curves& pieces) { return Chainer(pieces).run(); }

}  // namespace fovea
