// SPDX-License-Identifier: GPL-3.0-or-later
// Modifiers along a stroke: how its place along its length, its direction, its distance from the camera, noise and what
// is painted on surfaces change its width, opacity and color.
#pragma once

#include <fovea/focus/transfer.h>
#include <fovea/stroke/center_line.h>
#include <fovea/stroke/noise.h>

namespace fovea::stroke {

/// Where a center line is on its path.
struct Course {
    const ClippedPaths& clipped;
    Index piece;
    bool closed;
    Hand hand;  ///< of its noise
};

/// The modifiers of a pen. Each takes away a fraction of width and of opacity, and mixes the color with the pen's
/// second one: the causes, each in [0,1], are
/// - along: the place between the start (0) and the end (1) of the stroke;
/// - nib: 1 - |sin| of the angle in the image between the stroke's direction and the nib, 1 along the nib;
/// - distance: that along the view axis, from near (0) to far (1), which may be the nearer one;
/// - noise: smooth noise along the whole path, fixed to it (noise_along).
/// What is painted takes away the rest of width and opacity to what they are multiplied by, and changes the first
/// color.
class Modifiers {
   public:
    explicit Modifiers(const Pen& pen, const PenPaint& paint = {});

    /// Whether strokes change at all.
    bool any() const { return along_ || nib_.any || distance_.any || noise_.any || paint_.any(); }
    /// Appends the arc lengths between which changes of this line are linear.
    void add_knots(const CenterLine& line, const Course& course, std::vector<double>& arcs) const;
    /// (width, opacity, color) taken at a point of the line, each in [0,1].
    vec3 at(const CenterLine& line, const Course& course, const CenterPoint& point) const;
    /// The first color.
    dvec3 color_at(const Course& course, double arc) const;

   private:
    /// A cause that acts by fixed fractions.
    struct Cause {
        vec3 share;
        bool any = share != vec3(0.0f);
    };

    void add_knots_of_paint(const Course& course, std::vector<double>& arcs) const;

    std::array<Transfer, 3> transfers_;
    std::vector<double> places_;  // knots along the stroke, as fractions of it
    bool along_;
    Cause nib_, distance_, noise_;
    dvec2 nib_direction_;
    double reach_px_, near_, far_, wave_px_;
    PenPaint paint_;
    dvec3 color_;
};

/// Distance from the camera along the view axis at an arc length of a piece, clamped to its ends.
double distance_at(const ClippedPaths& clipped, Index piece, double arc);

/// Changes a shaped line by the modifiers of its pen in focus and of that out of focus, mixed as their widths,
/// opacities and colors are. Lines of pens without modifiers stay as they are.
void modify(CenterLine& line, const PenPair& pens, const Modifiers& in_focus, const Modifiers& out_of_focus,
            const Course& course);

/// Sets the colors of a line's points, as `modify` has mixed them.
void color(CenterLine& line, const Modifiers& in_focus, const Modifiers& out_of_focus, const Course& course);

}  // namespace fovea::stroke
