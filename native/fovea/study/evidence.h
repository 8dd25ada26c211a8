// SPDX-License-Identifier: GPL-3.0-or-later
// What a fit of thresholds depends on: at which of them the lines of definitions are drawn, and which are near to what
// artists have drawn.
#pragma once

#include <fovea/study/precision_recall.h>

namespace fovea::study {

/// What definitions draw in the view of a drawing: of each the highest threshold at which a pixel is drawn; and the
/// drawing. All of one size.
struct Judging {
    std::vector<const Strengths*> definitions;
    const Bitmap* judge = nullptr;
};

/// Number of a threshold of a definition: that of index level - 1 among its strengths, in ascending order. At pixels,
/// the highest at which it is drawn; 0: at none.
using Level = Index;

/// Of one drawing or of several, one after the other.
struct Evidence {
    std::size_t definitions = 0;
    std::vector<Array<float>> strengths;  ///< per definition, ascending; level k has strength k - 1
    Array<std::uint32_t> owner;           ///< per pixel of a definition: which one
    Array<std::uint8_t> is_near;          ///< whether it is near to the judge
    Array<std::uint32_t> fold;            ///< the part that it belongs to, of `folds`
    std::vector<Array<Level>> drawn;      ///< per definition, per pixel of any: its level here, or beside another's
    std::vector<Array<Level>> reached;    ///< per definition, per pixel of the judge: its most level near to it
    Array<std::uint32_t> judge_fold;      ///< per pixel of the judge
    std::size_t judged = 0;               ///< pixels of the judge
    /// Parts to hold out one after the other: drawings, or of a single one its blocks, a tenth of its longer side wide,
    /// every fifth of them.
    std::size_t folds = 0;

    Level off(std::size_t d) const { return Level(strengths[d].size()) + 1; }
    /// That of one part alone, or of all but it; with the same levels.
    Evidence part(std::size_t number, bool held_out) const;
};

/// Of what is near to a drawing within a tolerance [px]. Throws std::invalid_argument if drawings have other numbers of
/// definitions, or other sizes than theirs.
Evidence evidence_of(const std::vector<Judging>& drawings, double tolerance);

/// Level of the weakest lines that are drawn with a threshold.
Level level_from(const Array<float>& ascending, float threshold);

}  // namespace fovea::study
