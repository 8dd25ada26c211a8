#include "line/hysteresis.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace fovea {
namespace {

/// Sets of pieces that are joined (union by the lower number, so that no order matters).
class Joined {
   public:
    explicit Joined(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), Index(0)); }
    Index root(Index i) {
        while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
        return i;
    }
    void join(Index a, Index b) {
        a = root(a);
        b = root(b);
        parent_[std::max(a, b)] = std::min(a, b);
    }

   private:
    Array<Index> parent_;
};

Joined join_at_sides(const Curves& pieces) {
    Joined joined(pieces.size());
    std::vector<std::tuple<Index, Index, Index>> ends;  // side, level, piece
    for (Index i = 0; i < pieces.size(); ++i)
        for (const Index side : pieces[i].side)
            if (side != none) ends.emplace_back(side, pieces[i].level, i);
    std::sort(ends.begin(), ends.end());
    for (std::size_t i = 1; i < ends.size(); ++i) {
        const auto& [side, level, piece] = ends[i];
        const auto& [side_before, level_before, before] = ends[i - 1];
        if (side == side_before && level == level_before) joined.join(piece, before);
    }
    return joined;
}

}  // namespace

Curves keep_strong(const Curves& pieces, double least_length) {
    Joined joined = join_at_sides(pieces);
    Array<double> length(pieces.size(), 0.0);
    Array<std::uint8_t> strong(pieces.size(), 0);
    for (Index i = 0; i < pieces.size(); ++i) {
        const CurvePiece& piece = pieces[i];
        const Index root = joined.root(i);
        length[root] += glm::distance(dvec3(piece.point[0]), dvec3(piece.point[1]));
        strong[root] |= std::max(piece.strength[0], piece.strength[1]) >= 1.0f;
    }
    Curves kept;
    for (Index i = 0; i < pieces.size(); ++i) {
        const Index root = joined.root(i);
        if (strong[root] && length[root] >= least_length) kept.push_back(pieces[i]);
    }
    return kept;
}

}  // namespace fovea
