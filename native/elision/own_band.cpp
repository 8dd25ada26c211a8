#include "elision/own_band.h"

#include <algorithm>

#include "base/check.h"
#include "base/parallel.h"

namespace fovea {
namespace {

constexpr float most_half_width_px = 4096.0f;

/// Runs of one piece over a stretch of it.
struct Cover {
    Index run = none;
    double share = 0.0;  // of the stretch, by runs as visible as this one
};

Cover cover(const Runs& runs, Index first, Index last, double from, double to) {
    double longest = 0.0, of_class[2] = {0.0, 0.0};
    Cover found;
    for (Index r = first; r < last && runs.start_px[r] < to; ++r) {
        const double length = std::min(to, runs.end_px[r]) - std::max(from, runs.start_px[r]);
        if (length <= 0.0) continue;
        of_class[runs.invisibility[r] == 0] += length;
        if (length > longest) {
            longest = length;
            found.run = r;
        }
    }
    if (found.run != none) found.share = std::min(1.0, of_class[runs.invisibility[found.run] == 0] / (to - from));
    return found;
}

/// Pixel position on a piece, its end beyond it.
vec2 place_at(const ClippedPaths& clipped, Index piece, double arc) {
    const Index first = clipped.pieces.begin(piece), last = clipped.pieces.end(piece) - 1;
    const double* arcs = clipped.arc_px.data();
    const Index i = Index(std::upper_bound(arcs + first, arcs + last, arc) - arcs);
    if (i == first) return clipped.px[first];
    const double share = (arc - arcs[i - 1]) / std::max(arcs[i] - arcs[i - 1], 1e-9);
    return glm::mix(clipped.px[i - 1], clipped.px[i], float(std::clamp(share, 0.0, 1.0)));
}

}  // namespace

OwnBands own_bands(const ClippedPaths& clipped, const Runs& runs, In<Index> ranks, In<float> half_width_px) {
    check(half_width_px.size() == clipped.samples, "elision: one half width per atlas sample expected");
    check(ranks.size() == runs.size(), "elision: one rank per run expected");
    const Rows rows = runs_of_pieces(clipped, runs);
    OwnBands own;
    own.place.resize(clipped.samples);
    own.band.resize(clipped.samples);
    own.ends.resize(clipped.samples);
    own.run.resize(clipped.samples);
    Array<vec4> ends(runs.size());
    parallel_for(runs.size(), [&](std::size_t r) {
        const Index q = runs.piece[r];
        ends[r] = {place_at(clipped, q, runs.start_px[r]), place_at(clipped, q, runs.end_px[r])};
    });
    parallel_blocks(clipped.path.size(), 256, [&](auto, std::size_t first, std::size_t last) {
        for (Index q = Index(first); q < last; ++q) {
            Index r = rows.begin(q);
            for (Index i = clipped.pieces.begin(q); i + 1 < clipped.pieces.end(q); ++i) {
                const Index count = clipped.sample_count[i];
                if (count == 0) continue;
                const vec2 start = clipped.px[i], way = clipped.px[i + 1] - start;
                const float length = glm::length(way);
                const vec2 along = length > 0.0f ? way / length : vec2(1.0f, 0.0f);
                const double step = (clipped.arc_px[i + 1] - clipped.arc_px[i]) / count;
                for (Index j = 0; j < count; ++j) {
                    const double from = clipped.arc_px[i] + j * step, middle = from + 0.5 * step;
                    while (r < rows.end(q) && runs.end_px[r] <= from) ++r;
                    const Cover here = cover(runs, r, rows.end(q), from, from + step);
                    const Index s = clipped.sample_start[i] + j;
                    const float wanted =
                        half_width_px[s] > 0.0f ? std::min(half_width_px[s], most_half_width_px) : 0.0f;
                    own.place[s] = {start + way * ((float(j) + 0.5f) / float(count)), along};
                    own.run[s] = here.run;
                    own.band[s] = {std::max(least_half_width_px, wanted * float(here.share)), 0.0f, 0.0f, 0.0f};
                    own.ends[s] = vec4(0.0f);
                    if (here.run == none) continue;
                    own.ends[s] = ends[here.run];
                    own.band[s].y = float(ranks[here.run]);
                    own.band[s].z = float(middle - runs.start_px[here.run]);
                    own.band[s].w = float(runs.end_px[here.run] - middle);
                }
            }
        }
    });
    return own;
}

}  // namespace fovea
