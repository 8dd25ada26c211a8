#include "path/chain_curves.h"

#include <algorithm>

namespace fovea {
namespace {

/// One end of a piece: 2 piece + end.
using End = Index;

/// Per end: the end of another piece that goes on from it, or `none`.
Array<End> link(const Curves& pieces) {
    Array<End> ends;
    ends.reserve(2 * pieces.size());
    const auto side = [&](End e) { return std::pair(pieces[e / 2].side[e % 2], pieces[e / 2].level); };
    for (End e = 0; e < 2 * pieces.size(); ++e)
        if (side(e).first != none) ends.push_back(e);
    std::sort(ends.begin(), ends.end(), [&](End a, End b) { return side(a) != side(b) ? side(a) < side(b) : a < b; });
    Array<End> next(2 * pieces.size(), none);
    for (std::size_t i = 0; i < ends.size();) {
        std::size_t j = i + 1;
        while (j < ends.size() && side(ends[j]) == side(ends[i])) ++j;
        if (j - i == 2) {
            next[ends[i]] = ends[i + 1];
            next[ends[i + 1]] = ends[i];
        }
        i = j;
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
