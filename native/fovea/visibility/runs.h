// SPDX-License-Identifier: GPL-3.0-or-later
// The canonical form of visibility: runs, intervals of arc length; and conversion between runs and atlas samples.
#pragma once

#include <fovea/base/parallel.h>
#include <fovea/path/paths.h>
#include <fovea/project/clipped_paths.h>

namespace fovea::visibility {

/// Ends of runs and of pieces closer than this coincide.
inline constexpr double same_place_px = 1e-6;

/// Intervals of pieces, sorted by piece, then by start, disjoint. start < end, in pixels of the piece's own arc_px; a
/// run that overshoots its line starts before the piece or ends after it, where the line is continued straight. Methods
/// of visibility return visible runs only; `with_hidden` adds the hidden ones.
struct Runs {
    Array<Index> piece;
    Array<double> start_px, end_px;
    Array<std::uint8_t> invisibility;

    static constexpr auto columns = each_of(
        Column{"piece", &Runs::piece, "(R,) uint32"}, Column{"start_px", &Runs::start_px, "(R,) float64"},
        Column{"end_px", &Runs::end_px, "(R,) float64"},
        Column{"invisibility", &Runs::invisibility,
               "(R,) uint8, how many surfaces hide it (quantitative invisibility, Appel 1967), as far as they were "
               "counted; 0: visible"});

    std::size_t size() const { return piece.size(); }
    /// Appends a run, unless its ends coincide.
    void push(Index of, double start, double end, std::uint8_t hidden_by = 0);
    /// Appends a copy of run number `run` of `others`.
    void push(const Runs& others, std::size_t run) {
        push(others.piece[run], others.start_px[run], others.end_px[run], others.invisibility[run]);
    }
    void append(const Runs& more);
};

/// Throws std::invalid_argument if the runs are not of these pieces. Runs ascend by piece, so only the last one is
/// checked.
void check_runs(const ClippedPaths& clipped, const Runs& runs);

/// Of parallel loops whose elements take usual time.
inline constexpr std::size_t runs_per_block = 256, pieces_per_block = 256;

/// Concatenates the runs that add(runs, begin, end) appends for each block of `size` of `count` elements, in order.
/// Parallel; the result does not depend on the number of threads.
template <typename Add>
Runs runs_by_blocks(std::size_t count, std::size_t size, const Add& add) {
    Runs all;
    for (const Runs& part : parallel_parts<Runs>(count, size, add)) all.append(part);
    return all;
}

/// Range of runs of each piece.
Rows runs_of_pieces(const ClippedPaths& clipped, const Runs& runs);

/// Runs where the sampled visibility (atlas order, in [0,1]) is at least `threshold`; ends are interpolated between
/// the two samples on either side.
Runs runs_from_samples(const ClippedPaths& clipped, In<float> visibility, float threshold = 0.5f);

/// Share of each atlas sample that visible runs cover, in [0,1].
Array<float> samples_from_runs(const ClippedPaths& clipped, const Runs& runs);

/// Adds to visible runs the hidden ones between them, with invisibility 1 (one surface or more). Image-space lines,
/// whose path's `placement` is `none` (one entry per path of Paths), have no hidden runs: they lie on no surface, and
/// nothing occludes them.
Runs with_hidden(const ClippedPaths& clipped, const Runs& visible, In<Index> placement);

}  // namespace fovea::visibility
