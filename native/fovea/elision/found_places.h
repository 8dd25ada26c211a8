// SPDX-License-Identifier: GPL-3.0-or-later
// Places of the lines of the view of one frame, found again on those of another one.
#pragma once

#include <vector>

#include <fovea/elision/view_lines.h>

namespace fovea::elision {

/// Where a place is on the lines of another frame.
struct FoundPlace {
    Index place = none;   ///< the nearest one there; none: it is on no line
    double beyond = 0.0;  ///< pixels from it along its line
    double trust = 0.0;   ///< in [0, 1]: 1 on the line
    bool same = true;     ///< whether both lines run the same way
    bool inside = false;  ///< whether its object is there, and its point of the surface in that picture
};

/// The points of the surface on which the lines of one frame lie, in another frame. What is looked for there, per
/// place, is the nearest place, within a few pixels, of a line of the same object that runs beside it at about the same
/// distance from the eye (what Kalnins et al. 2003, section 4, hand on marks along). Lines of the image have no places.
class MovedPlaces {
   public:
    /// Borrows.
    MovedPlaces(const ViewLines& now, const ViewLines& there);

    Array<FoundPlace> found() const;  ///< on lines of the same definition
    /// On lines of any definition, right beside a place there. `counts`: per place there, whether it does.
    Array<FoundPlace> beside(In<std::uint8_t> counts) const;

   private:
    friend Array<std::uint8_t> are_beside(const ViewLines& lines, In<std::uint8_t> counts);
    bool is_inside(const Pose::Seen& point) const;
    template <typename Accept>
    Array<FoundPlace> nearest(const Accept& accept) const;

    const ViewLines &now_, &there_;
    std::vector<Index> number_;  // of objects here, among those there; none if one is not
    Array<Pose::Seen> points_;   // per place
};

/// Per place: whether one that counts is right beside it, on another line or far along the same one.
Array<std::uint8_t> are_beside(const ViewLines& lines, In<std::uint8_t> counts);

}  // namespace fovea::elision
