// SPDX-License-Identifier: GPL-3.0-or-later
// Families of parallel planes for hatching, and which planes of a family have lines on a part of a surface: those at
// multiples of a power of two of units, namely that which is nearest to the spacing on paper there.
#pragma once

#include <array>
#include <vector>

#include <fovea/base/types.h>
#include <fovea/base/view.h>

namespace fovea::line {

/// Planes dot(along, p) + offset = any number, p in view space.
struct HatchFamily {
    dvec3 along;
    double offset;
    double tone;  ///< below which there are lines
    Index number;
    double at(const dvec3& p) const { return glm::dot(along, p) + offset; }
};

/// Point of a triangle or of a chord across it.
struct HatchSpot {
    dvec3 at;      ///< view space
    dvec3 normal;  ///< of unit length, to the viewer's side of the facet
};

HatchSpot mix(const HatchSpot& a, const HatchSpot& b, double t);

/// A level of a family: a multiple of 2^power, and of no higher one.
struct HatchLevel {
    double value;
    int power;
};

/// Part of a chord from its beginning, 0, to its end, 1; empty unless from < to.
struct ChordPart {
    double from = 0.0, to = 1.0;
    bool empty() const { return !(from < to); }
    /// Clips to where a linear quantity with these values at 0 and 1 is positive.
    void clip(double at_0, double at_1);
};

class HatchLevels {
   public:
    /// `spacing`: of lines [px]. Borrows the view.
    HatchLevels(const View& view, double spacing);

    using Corners = std::array<HatchSpot, 3>;
    /// Levels that may have a line on a triangle, ascending. `whole`: all of it is in the frame.
    std::vector<HatchLevel> on(const HatchFamily& family, const Corners& corners, bool whole) const;

    /// The planes around what is in the frame, or near it, as bits: those that a point lies beyond.
    int outcode(const dvec3& p) const;
    /// Clips a chord to the frame.
    ChordPart in_frame(const dvec3& from, const dvec3& to) const;

    /// Length in space of a pixel at a point, where it is longest.
    double px_at(const dvec3& p) const;
    /// The lowest power of two whose multiples are as far apart as the spacing, or nearly so, where multiples of 1 are
    /// `apart` pixels apart.
    int power_for(double apart) const;
    /// Pixels between levels that are 1 apart, as they lie on the surface there; negative beyond its contour.
    double apart_px(const HatchFamily& family, const HatchSpot& spot) const;
    /// Pixels between levels that are 1 apart from which on a level has lines: its power is that of the spacing, or
    /// higher. 0 of a level that always has some.
    double least_apart(const HatchLevel& level) const;
    /// Clips part of a chord to where levels that are 1 apart are at least so many pixels apart. Across a flat triangle
    /// they are closer in proportion to distance, across others the distance between them is interpolated.
    ChordPart where_apart(const HatchFamily& family, const HatchSpot& from, const HatchSpot& to, double least,
                          const ChordPart& part) const;

   private:
    using Polygon = std::vector<HatchSpot>;
    static constexpr int planes = 5;
    double distance_to(int plane, const dvec3& p) const;
    dvec2 sides_of_px(const dvec3& p) const { return per_px_ * (view_.orthographic ? 1.0 : -p.z); }
    double most_apart(const HatchFamily& family, const Polygon& polygon, const dvec3& normal, double low,
                      double high) const;
    void append(const HatchFamily& family, const Polygon& polygon, const dvec3& normal,
                std::vector<HatchLevel>& found) const;

    const View& view_;
    const dvec2 per_px_;
    const double spacing_;
};

}  // namespace fovea::line
