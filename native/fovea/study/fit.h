// SPDX-License-Identifier: GPL-3.0-or-later
// Thresholds of line definitions with which they draw what an artist has drawn.
#pragma once

#include <limits>

#include <fovea/study/precision_recall.h>

namespace fovea::study {

/// Of definitions that are not drawn.
inline constexpr float no_threshold = std::numeric_limits<float>::infinity();

struct FitOptions {
    double tolerance = 0.0;  ///< [px], within which lines are near
    double beta = 1.0;       ///< above 1: rather complete than clean, as in F_beta
    double cost = 0.01;      ///< that each definition has to add to F_beta at least
    double slack = 0.0005;   ///< of scores that are as good: of a range of such thresholds the middle is taken
    int starts = 20;         ///< random ones, beside the one that is given and that of nothing
};

/// What is drawn with some thresholds, judged by a drawing.
struct Fit {
    Array<float> thresholds;  ///< per definition; `no_threshold`: it is not drawn
    double precision = 1.0, recall = 0.0;
    double score = 0.0;  ///< F_beta less the costs

    double f(double beta) const;
};

/// The thresholds with the best score, but for `slack` for each. `definitions`: of each the highest threshold at which
/// a pixel is drawn, all of one size. `judge`: what the artist has drawn. `first`: thresholds to start from, one per
/// definition.
///
/// Recall is the share of the judge's pixels near to any definition. Of precision a pixel of a definition counts as
/// 1 / n, if n of those that are drawn have a pixel here or beside it, so that nobody gains by drawing a line twice.
/// Coordinate search: for one threshold, all others fixed, all values are tried in one pass over the pixels; until no
/// single threshold is better elsewhere.
Fit fitted(const std::vector<Strengths>& definitions, const Bitmap& judge, In<float> first, const FitOptions& options);

/// The same of given thresholds.
Fit judged(const std::vector<Strengths>& definitions, const Bitmap& judge, In<float> thresholds,
           const FitOptions& options);

}  // namespace fovea::study
