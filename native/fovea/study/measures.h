// SPDX-License-Identifier: GPL-3.0-or-later
// How near two drawings are to each other. Cole 2009, section 3.2.
#pragma once

#include <limits>
#include <vector>

#include <fovea/study/bitmap.h>
#include <fovea/style/field.h>

namespace fovea::study {

/// Distances [px] of a drawing's pixels from the other; infinite if only one of them is empty.
struct Distances {
    double mean = 0.0, median = 0.0, most = 0.0;  ///< `most`: of 95 % of the pixels
};

/// Drawing A judged by drawing B.
struct Measures {
    double precision = 1.0;
    double recall = 1.0;
    double f1 = 1.0;
    double chamfer_px = 0.0;
    double iou = 1.0;
    double mean_to_b_px = 0.0, median_to_b_px = 0.0, most_to_b_px = 0.0;
    double mean_to_a_px = 0.0, median_to_a_px = 0.0, most_to_a_px = 0.0;
    std::size_t pixels_a = 0, pixels_b = 0;

    static constexpr auto fields = each_of(
        style::Field{"precision", &Measures::precision, "Precision", "Share of A's pixels within the tolerance of B"},
        style::Field{"recall", &Measures::recall, "Recall", "Share of B's pixels within the tolerance of A"},
        style::Field{"f1", &Measures::f1, "F1", "Harmonic mean of precision and recall"},
        style::Field{"chamfer_px", &Measures::chamfer_px, "Chamfer Distance",
                     "Mean of the mean distances of A's pixels from B and of B's from A"},
        style::Field{"iou", &Measures::iou, "Intersection over Union",
                     "Of both sets, widened by the tolerance on each side"},
        style::Field{"mean_to_b_px", &Measures::mean_to_b_px, "Mean Distance to B", "Of A's pixels"},
        style::Field{"median_to_b_px", &Measures::median_to_b_px, "Median Distance to B", "Of A's pixels"},
        style::Field{"most_to_b_px", &Measures::most_to_b_px, "Distance to B of 95 %", "Of A's pixels"},
        style::Field{"mean_to_a_px", &Measures::mean_to_a_px, "Mean Distance to A", "Of B's pixels"},
        style::Field{"median_to_a_px", &Measures::median_to_a_px, "Median Distance to A", "Of B's pixels"},
        style::Field{"most_to_a_px", &Measures::most_to_a_px, "Distance to A of 95 %", "Of B's pixels"},
        style::Field{"pixels_a", &Measures::pixels_a, "Pixels of A", ""},
        style::Field{"pixels_b", &Measures::pixels_b, "Pixels of B", ""});
};

/// Distance that counts as near in drawings of this diagonal where none is given: 1 mm on the paper of the thesis.
constexpr double usual_tolerance(double diagonal) { return 0.0042 * diagonal; }

/// How far the pixels of drawings A and B, of one size, are from each other.
class Nearness {
   public:
    Nearness(const Bitmap& a, const Bitmap& b);

    /// `tolerance` [px]. An empty drawing has precision 1; recall of an empty drawing is 1.
    Measures at(double tolerance) const;
    /// Pixels of both.
    std::size_t pixels() const { return of_a_.size() + of_b_.size(); }
    /// For each distance [px] the share of them that are that near to the other drawing; 1 of none.
    Array<double> shares_within(const std::vector<double>& distances) const;

   private:
    Array<float> to_a_, to_b_;  // of all pixels
    Array<float> of_a_, of_b_;  // distances of a drawing's pixels from the other, ascending
};

inline Measures compare(const Bitmap& a, const Bitmap& b, double tolerance) { return Nearness(a, b).at(tolerance); }

}  // namespace fovea::study
