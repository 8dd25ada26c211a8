// SPDX-License-Identifier: GPL-3.0-or-later
// Thresholds of line definitions with which they draw what an artist has drawn.
#pragma once

#include <limits>

#include <fovea/study/evidence.h>

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

/// The thresholds with the best score for all drawings together, but for `slack` for each. `first`: thresholds to start
/// from, one per definition.
///
/// Recall is the share of the judges' pixels near to any definition. Of precision a pixel of a definition counts as
/// 1 / n, if n of those that are drawn have a pixel here or beside it, so that nobody gains by drawing a line twice.
/// Coordinate search: for one threshold, all others fixed, all values are tried in one pass over the pixels; until no
/// single threshold is better elsewhere. Polls the Cancel of the calling thread's scope.
Fit fitted(const std::vector<Judging>& drawings, In<float> first, const FitOptions& options);

/// The same of given thresholds.
Fit judged(const std::vector<Judging>& drawings, In<float> thresholds, const FitOptions& options);

/// The same of evidence that is there, whatever tolerance is in the options.
Fit fitted(const Evidence& evidence, In<float> first, const FitOptions& options);
Fit judged(const Evidence& evidence, In<float> thresholds, const FitOptions& options);

/// How well thresholds fit what they were not fitted to: each part (`Evidence::folds`) is held out once and judged by
/// those fitted to the others; precision and recall are of all held-out parts together, without thresholds.
Fit cross_validated(const Evidence& evidence, In<float> first, const FitOptions& options);

/// A single drawing, in the view of the definitions' lines; both have to outlive it.
std::vector<Judging> judging(const std::vector<Strengths>& definitions, const Bitmap& judge);

inline Fit fitted(const std::vector<Strengths>& definitions, const Bitmap& judge, In<float> first,
                  const FitOptions& options) {
    return fitted(judging(definitions, judge), first, options);
}
inline Fit judged(const std::vector<Strengths>& definitions, const Bitmap& judge, In<float> thresholds,
                  const FitOptions& options) {
    return judged(judging(definitions, judge), thresholds, options);
}

}  // namespace fovea::study
