// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/path/chain_curves.h>

#include <algorithm>
#include <bit>
#include <utility>

#include <fovea/path/ends.h>
#include <fovea/path/paths.h>

namespace fovea::path {
namespace {

/// End of a segment: 2 * piece + 0 or 1.
using End = Index;

/// Open-addressing hash table of the segment ends on each (side, level).
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

/// Per end: the end of another segment that it continues with, or `none`.
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

/// Key that is unique per piece.
std::uint64_t key_of(const CurvePiece& piece) {
    if (piece.key != 0) return piece.key;
    return piece.other == none ? std::uint64_t(piece.level) << 32 | piece.triangle
                               : std::uint64_t(piece.triangle) << 32 | piece.other;
}

}  // namespace

CurveChains chain_curves(const Curves& pieces) {
    constexpr std::uint64_t highest = ~std::uint64_t(0);
    CurveChains chains;
    std::uint64_t lowest = highest;
    const auto add = [&](End end) {
        const CurvePiece& piece = pieces[end / 2];
        lowest = std::min(lowest, key_of(piece));
        chains.point.push_back(piece.point[end % 2]);
        chains.strength.push_back(piece.strength[end % 2]);
        chains.triangle.push_back(piece.triangle);
        chains.side.push_back(piece.side[end % 2]);
        chains.other.push_back(piece.other);
    };
    const auto finish = [&](bool closed) {
        const Index points = static_cast<Index>(chains.point.size());
        chains.closed.push_back(closed && points - chains.rows.offsets.back() > 2);
        chains.free.push_back(chains.closed.back() ? 0 : any_free);
        chains.anchor.push_back(std::exchange(lowest, highest));
        chains.rows.offsets.push_back(points);
    };
    walk_ends(link(pieces), add, finish);
    return chains;
}

}  // namespace fovea::path
