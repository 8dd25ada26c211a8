// SPDX-License-Identifier: GPL-3.0-or-later
// Precision and recall of lines that have strengths, at every threshold of them. Cole 2009, section 3.2.2.
#pragma once

#include <limits>

#include <fovea/base/columns.h>
#include <fovea/study/bitmap.h>

namespace fovea::study {

/// Strengths of lines at pixels, bottom row first; below 0: there is no line.
struct Strengths {
    int width = 0, height = 0;
    Array<float> values;

    /// The pixels with at least a strength.
    Bitmap above(float threshold) const;
};

/// Numbers of the pixels that are set, ascending.
Array<Index> pixels_in(const Bitmap& bitmap);

/// For each of the pixels with these numbers the most strength within a distance [px]; below 0: there is no line.
Array<float> most_near(const Strengths& strengths, In<Index> pixels, double distance);

/// Drawings of ever more lines, from those that are drawn in any case alone.
struct PrecisionRecall {
    Array<float> threshold;
    Array<double> precision, recall;

    static constexpr auto columns =
        each_of(Column{"threshold", &PrecisionRecall::threshold,
                       "(N,) float32 strengths from which on lines are drawn, descending; the first is infinite"},
                Column{"precision", &PrecisionRecall::precision, "(N,) float64 of the drawing"},
                Column{"recall", &PrecisionRecall::recall, "(N,) float64 of the drawing, ascending"});

    /// The number of the drawing with the most recall among those with at least a precision; -1: there is none.
    int best_at(double precision_wanted) const;
    /// Its recall. Beyond the highest precision it falls in a straight line to that of nothing, (1, 0).
    double recall_at(double precision_wanted) const;
    /// Mean of recall_at for precisions of 0.5 to 1.
    double area() const;
};

/// `always`: lines that are drawn in any case. `judge`: the drawing that both are judged by. `tolerance` [px].
PrecisionRecall precision_recall(const Strengths& strengths, const Bitmap& always, const Bitmap& judge,
                                 double tolerance);

}  // namespace fovea::study
