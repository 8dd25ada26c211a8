// SPDX-License-Identifier: GPL-3.0-or-later
// Lines drawn by hand, and what elision leaves of them.
#pragma once

#include <algorithm>
#include <cmath>

#include <fovea/elision/elide.h>
#include <fovea/elision/opacity.h>
#include <fovea/elision/priority.h>

namespace fovea {
using namespace draw;

/// Straight or bent lines on a sheet, each one path, piece and run; the first is the most important.
struct Sheet {
    int width = 200, height = 160;
    float half_width = 4.0f, step_px = 2.0f;
    ClippedPaths clipped;
    Runs runs;

    void line(const std::vector<vec2>& points, std::uint8_t hidden_by = 0) {
        const Index piece = clipped.pieces.count();
        double arc = 0.0;
        for (std::size_t k = 0; k < points.size(); ++k) {
            const float length = k + 1 < points.size() ? glm::distance(points[k], points[k + 1]) : 0.0f;
            const Index count = Index(std::ceil(length / step_px));
            clipped.px.push_back(points[k]);
            clipped.arc_px.push_back(arc);
            clipped.sample_start.push_back(clipped.samples);
            clipped.sample_count.push_back(count);
            clipped.samples += count;
            arc += length;
        }
        clipped.path.push_back(piece);
        clipped.pieces.offsets.push_back(Index(clipped.px.size()));
        runs.push(piece, 0.0, arc, hidden_by);
    }

    /// Ends of a line through a point.
    static std::vector<vec2> through(vec2 middle, double angle, double length) {
        const vec2 way = vec2(float(std::cos(angle)), float(std::sin(angle))) * float(length / 2.0);
        return {middle - way, middle + way};
    }

    Array<Index> ranks() const {
        std::vector<float> priority;
        std::vector<std::uint64_t> id;
        for (Index p = 0; p < clipped.path.size(); ++p) {
            priority.push_back(1.0f / float(p + 1));
            id.push_back(p);
        }
        return rank_runs(clipped, runs, priority, id);
    }
    OwnBands own(In<float> half_widths) const { return own_bands(clipped, runs, ranks(), half_widths, 6.0f * step_px); }
    OwnBands own() const { return own(std::vector<float>(clipped.samples, half_width)); }
    PriorityBuffer buffer(const OwnBands& own) const {
        return draw_priorities(draw_bands(clipped, runs, ranks(), own), width, height);
    }
    /// Per atlas sample; 1 where no run is.
    Array<float> scores(const OwnBands& own) const {
        const Array<float> found = elision_scores(own, crowding(own, buffer(own)));
        Array<float> all(clipped.samples);
        std::ranges::fill(all, 1.0f);
        for (std::size_t s = 0; s < found.size(); ++s) all[own.sample[s]] = found[s];
        return all;
    }
    Array<float> scores() const { return scores(own()); }
    Array<float> opacities(const ElisionOptions& options = {}) const {
        const OwnBands bands = own();
        return elision_opacities(clipped, bands, elision_scores(bands, crowding(bands, buffer(bands))), options);
    }

    /// Samples of a piece; `aside`: so many pixels from its ends.
    std::vector<float> of(Index piece, const Array<float>& values, double aside = 0.0) const {
        std::vector<float> found;
        const Index begin = clipped.pieces.begin(piece), last = clipped.pieces.end(piece) - 1;
        for (Index i = begin; i < last; ++i)
            for (Index j = 0; j < clipped.sample_count[i]; ++j) {
                const double share = (j + 0.5) / clipped.sample_count[i];
                const double arc = glm::mix(clipped.arc_px[i], clipped.arc_px[i + 1], share);
                if (arc >= clipped.arc_px[begin] + aside && arc <= clipped.arc_px[last] - aside)
                    found.push_back(values[clipped.sample_start[i] + j]);
            }
        return found;
    }
};

}  // namespace fovea
