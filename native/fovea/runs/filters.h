// SPDX-License-Identifier: GPL-3.0-or-later
// Filters along the path. They act on visible runs (those that nothing hides), in pixels of arc length, over segments,
// atlas rows and the seams of closed paths; hidden runs give way to visible ones and stay as they are otherwise. The
// last two leave out hidden ones. Amounts per path are one entry per path of Paths. Parallel; the same for any number
// of threads.
//
// Order: close_gaps, trim_folds, without_beside_visible, without_short_hidden, halo, meet_ends, overshoot. Halo must
// precede overshoot: otherwise the overshoot past the occluding line survives.
#pragma once

#include <fovea/visibility/runs.h>

namespace fovea::runs {

/// Joins visible runs whose gap is shorter than `gap_px`, then drops those shorter than the path's `spur_px`; of those
/// that begin or end where their line does, or the frame, only the ones shorter than `speck_px`. What is all of a line
/// stays.
Runs close_gaps(const ClippedPaths& clipped, const Runs& runs, double gap_px, In<float> spur_px, double speck_px = 0.0);

/// A contour of mesh edges folds back on itself where a smooth surface turns away, and the way back is hidden. On paths
/// with `of_view` set (one entry per path of Paths), cuts folds of at most `fold_px` off the ends of visible runs (not
/// of pieces, unless they end at cusps), and ends a run where the next one goes on beside it.
Runs trim_folds(const ClippedPaths& clipped, const Runs& runs, In<std::uint8_t> of_view, double fold_px);

/// Where a contour of mesh edges breaks off because facets of its own rough outline hide it, and another line goes on
/// a little farther: draws visible runs of paths with `of_view` set on, by at most `reach_px` along their hidden way,
/// and straight on beyond their line's end by three eighths of it, to where they come nearest to the end of a run of
/// another path of the same `placement` (per path of Paths) that faces theirs, if they come near. Hidden runs give way.
Runs meet_ends(const ClippedPaths& clipped, const Runs& runs, In<std::uint8_t> of_view, In<Index> placement,
               double reach_px);

/// Lengthens visible runs by the path's `amount_px` where their line ends, straight on beyond it: such a run starts
/// before, or ends after, the arc lengths of its piece. What the frame cuts stays at the frame, and a line that a
/// surface hides stops at its edge; a pixel of it may be hidden at its end, and from two on it goes no farther.
/// Negative amounts erode runs at all their ends; empty runs are removed. The result grows with the
/// amount, without steps but where runs meet; an amount of 0 leaves a path as it is. Cole 2009, section 5.1.2, dilates
/// visibility instead, which draws lines on behind what hides them.
/// With `other_px` (may be empty), by the amount mixed with the path's other one as `mix` (per atlas sample, in [0,1])
/// says at each end.
Runs overshoot(const ClippedPaths& clipped, const Runs& runs, In<float> amount_px, In<float> other_px = {},
               In<float> mix = {});

/// Where a line passes behind another one, it stops the path's `gap_px` (0 or more) short: where a visible run crosses,
/// in the image, a visible run that is nearer by more than eight pixels' size in space, or ends at one. The gap is
/// measured across the nearer line, from its middle, on both sides; where they cross at less than 15 degrees it grows
/// no further. Ends at which a line turns away on its own surface, or meets another line, stay. So do those behind an
/// outline that is not drawn. Nothing passes behind lines found in the image. A gap of 0 leaves a path as it is.
/// On paths with `of_view` set (one entry per path of Paths; may be empty) a gap is only where a line crosses at 15
/// degrees or more: contours of mesh edges graze themselves where their own surface folds over them.
/// Cf. Appel, Rohlf & Stein, "The Haloed Line Effect for Hidden Line Elimination", SIGGRAPH 1979.
Runs halo(const ClippedPaths& clipped, const Runs& runs, In<float> gap_px, In<std::uint8_t> of_view = {});

/// Runs without the hidden parts that go along a visible run, or on under it, at less than `near_px`: where lines
/// coincide, the visible one is drawn (as ISO 128 has it), and no outline of a coarse mesh is accompanied by its own
/// way back. Hidden lines that cross visible ones stay whole.
Runs without_beside_visible(const ClippedPaths& clipped, const Runs& runs, double near_px);

/// Runs without the hidden stretches that are shorter than their path's `least_px`: crumbs beside small holes, and the
/// ways back of contours that fold. A stretch is what lies hidden between two visible runs, however many surfaces hide
/// its parts; one that is a whole piece stays.
Runs without_short_hidden(const ClippedPaths& clipped, const Runs& runs, In<float> least_px);

}  // namespace fovea::runs
