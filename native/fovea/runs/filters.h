// SPDX-License-Identifier: GPL-3.0-or-later
// Filters of runs along their paths. They act on visible runs, in pixels of arc length, across segments, atlas rows and
// the seams of closed paths; visible runs replace hidden ones, which stay unchanged otherwise. Two filters remove
// hidden runs. Amounts per path have one entry per path of Paths. Parallel; results do not depend on the number of
// threads.
//
// Order: without_own_roughness (runs/own_roughness.h), join_folds (runs/join_folds.h), close_gaps, trim_folds,
// without_forks (runs/forks.h), without_tips, without_dots (runs/dots.h), without_narrow_strips (runs/narrow_strips.h),
// without_beside_visible, without_short_hidden, halo, meet_ends, overshoot. Halo must precede overshoot: otherwise the
// overshoot past the occluding line survives.
#pragma once

#include <fovea/visibility/runs.h>

namespace fovea::runs {

/// Joins visible runs separated by less than `gap_px`, then drops those shorter than the path's `spur_px`; of those
/// that begin or end at an end of their line, or at the frame, only the ones shorter than `speck_px`. A run that covers
/// its whole line stays.
Runs close_gaps(const ClippedPaths& clipped, const Runs& runs, double gap_px, In<float> spur_px, double speck_px = 0.0);

/// Trims folds: a contour along mesh edges doubles back where a smooth surface turns away, and the returning part is
/// hidden. On paths with `of_view` set (one entry per path of Paths), cuts folds of at most `fold_px` off the ends of
/// visible runs (not off ends of pieces, unless they end at cusps).
Runs trim_folds(const ClippedPaths& clipped, const Runs& runs, In<std::uint8_t> of_view, double fold_px);

/// Removes visible runs that peek out: groups that meet at the ends of their lines (runs/groups.h), are smaller than
/// `tip_px` together, go on where a surface hides them, and have an end that no other line comes nearer to than
/// `touch_px`. They come and go from frame to frame where parts of a body intersect. What fills a gap between other
/// lines stays. `placement`: per path of Paths.
Runs without_tips(const ClippedPaths& clipped, const Runs& runs, In<Index> placement, double tip_px, double touch_px);

/// Closes gaps where a contour along mesh edges breaks off because facets of its own rough outline hide it, and another
/// line begins nearby. Extends visible runs of paths with `of_view` set by at most `reach_px` along their hidden
/// continuation, and straight beyond their line's end by at most three eighths of it, to the point nearest to a facing
/// end of a run of another path of the same `placement` (per path of Paths), if that is near enough. Visible runs
/// replace hidden ones.
Runs meet_ends(const ClippedPaths& clipped, const Runs& runs, In<std::uint8_t> of_view, In<Index> placement,
               double reach_px);

/// Extends visible runs by the path's `amount_px` straight beyond the ends of their line: such a run starts before, or
/// ends after, the arc lengths of its piece. Runs cut by the frame end there, and a run that a surface hides stops at
/// the occluder's edge: with up to one pixel of its line hidden at the end it is extended in full, from two pixels on
/// not at all. Negative amounts erode runs at all their ends; empty runs are removed. The result grows continuously
/// with the amount except where runs meet; an amount of 0 leaves a path unchanged. Cole 2009, section 5.1.2, dilates
/// visibility instead, which extends lines behind their occluders. With `other_px` (may be empty), the amount at each
/// end is interpolated from `amount_px` to `other_px` by `mix` (per atlas sample, in [0,1]).
Runs overshoot(const ClippedPaths& clipped, const Runs& runs, In<float> amount_px, In<float> other_px = {},
               In<float> mix = {});

/// Haloes: cuts a line the path's `gap_px` (0 or more) short where it passes behind another one, i.e. where a visible
/// run crosses, in the image, a visible run that is nearer by more than eight pixels' size in space, or ends at one.
/// The gap is measured perpendicular to the nearer line, from its center, on both sides; below a crossing angle of 15
/// degrees it grows no further. Ends at which a line turns away on its own surface, or meets another line, are
/// unchanged, and so are ends behind an outline that is not drawn. Nothing passes behind image-space lines. A gap of 0
/// leaves a path unchanged. On paths with `of_view` set (one entry per path of Paths; may be empty), gaps are made only
/// at crossing angles of 15 degrees or more: contours along mesh edges graze themselves where their own surface folds
/// over them. Cf. Appel, Rohlf & Stein, "The Haloed Line Effect for Hidden Line Elimination", SIGGRAPH 1979.
Runs halo(const ClippedPaths& clipped, const Runs& runs, In<float> gap_px, In<std::uint8_t> of_view = {});

/// Removes hidden parts that run alongside, or beneath, a visible run at less than `near_px`: of coincident lines only
/// the visible one is drawn (as in ISO 128), and an outline of a coarse mesh is not doubled by its own returning part.
/// Hidden lines that cross visible ones stay whole.
Runs without_beside_visible(const ClippedPaths& clipped, const Runs& runs, double near_px);

/// Removes hidden stretches shorter than their path's `least_px`: spurs beside small holes, and the returning parts of
/// contours that fold. A stretch is the hidden part between two visible runs, whatever the invisibility of its parts;
/// one that is a whole piece stays.
Runs without_short_hidden(const ClippedPaths& clipped, const Runs& runs, In<float> least_px);

}  // namespace fovea::runs
