// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/line/hysteresis.h>

#include <algorithm>
#include <tuple>

#include <fovea/base/disjoint_sets.h>

namespace fovea {
namespace {

DisjointSets join_at_sides(const Curves& pieces) {
    DisjointSets joined(pieces.size());
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
    DisjointSets joined = join_at_sides(pieces);
    Array<double> length(pieces.size(), 0.0);
    Array<std::uint8_t> strong(pieces.size(), 0);
    for (Index i = 0; i < pieces.size(); ++i) {
        const CurvePiece& piece = pieces[i];
        const Index set = joined.name(i);
        length[set] += glm::distance(dvec3(piece.point[0]), dvec3(piece.point[1]));
        strong[set] |= std::max(piece.strength[0], piece.strength[1]) >= 1.0f;
    }
    Curves kept;
    for (Index i = 0; i < pieces.size(); ++i) {
        const Index set = joined.name(i);
        if (strong[set] && length[set] >= least_length) kept.push_back(pieces[i]);
    }
    return kept;
}

}  // namespace fovea
