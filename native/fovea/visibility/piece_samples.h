// SPDX-License-Identifier: GPL-3.0-or-later
// The atlas samples of one piece, which are contiguous.
#pragma once

#include <fovea/project/clipped_paths.h>

namespace fovea::visibility {

/// Samples of a piece, numbered from 0 along it; they lie at ascending arc lengths.
class PieceSamples {
   public:
    PieceSamples(const ClippedPaths& clipped, Index piece);

    std::ptrdiff_t count() const { return end_ - begin_; }
    /// Atlas index of a sample.
    std::size_t in_atlas(std::ptrdiff_t sample) const { return std::size_t(begin_ + sample); }
    /// Arc length of a sample [px].
    double arc(std::ptrdiff_t sample) const;
    /// The first sample beyond an arc length; count() where there is none.
    std::ptrdiff_t after(double arc_px) const;
    /// Interpolates per-atlas-sample `values` at an arc length: linear between samples, constant beyond the first and
    /// the last; `otherwise` if the piece has no samples.
    float value(In<float> values, double arc_px, float otherwise) const;

   private:
    const ClippedPaths& clipped_;
    Index first_point_, last_point_;
    std::ptrdiff_t begin_, end_;
};

}  // namespace fovea::visibility
