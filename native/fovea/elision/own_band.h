// SPDX-License-Identifier: GPL-3.0-or-later
// Per atlas sample: its position, and the band that its line reserves in the priority buffer.
#pragma once

#include <fovea/visibility/runs.h>

namespace fovea::elision {

/// The atlas samples covered by runs, in atlas order and hence in that of the runs: input of the elision test on both
/// backends. A sample belongs to the run that covers most of it.
struct OwnBands {
    /// Samples of each run: entries runs.begin(r) .. runs.end(r) of the arrays; a run shorter than a sample may have
    /// none.
    Rows runs;
    Array<Index> sample;
    Array<vec4> place, band, ends;
    Array<vec3> figure;

    static constexpr auto columns = each_of(
        Column{"sample", &OwnBands::sample, "(D,) uint32 number of the sample in the atlas"},
        Column{"place", &OwnBands::place, "(D, 4) float32: pixel position, direction (unit length)"},
        Column{
            "band", &OwnBands::band,
            "(D, 4) float32: half the band's width [px], at least half a pixel, so that no line slips between pixels; "
            "rank of the run; pixels back to its start, and ahead to its end"},
        Column{"ends", &OwnBands::ends, "(D, 4) float32: where the run starts, and where it ends [px]"},
        Column{
            "figure", &OwnBands::figure,
            "(D, 3) float32: number of the run's figure (elision/figures.h), -1: none; weight in [0, 1] with which it "
            "is thinned as a whole; pixels of the run, or, with that weight, of the figure"});

    /// Per rank: number of the figure of its run; -1: none. May be empty: there are no figures.
    Array<float> figure_of_rank;

    /// Per run: how far it belongs to a dot, in [0, 1] (elision/figures.h). May be empty: there are none.
    Array<float> dot;

    /// Distance before its end at which a line begins to hand over to one that continues there [px].
    float reach_px = 0.0f;
};

/// `ranks`: per run (elision/priority.h). `half_width_px`: per atlas sample, half the width of the band of a fully
/// drawn line; scaled down where runs cover the sample in part. NaN and negative values count as 0. `reach_px`: 1.5
/// times the smoothing window of elision_scores, so that a line that begins where another ends is whole there; above 0.
OwnBands own_bands(const ClippedPaths& clipped, const Runs& runs, In<Index> ranks, In<float> half_width_px,
                   float reach_px);

}  // namespace fovea::elision
