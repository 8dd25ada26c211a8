// SPDX-License-Identifier: GPL-3.0-or-later
// Places of the lines of the view of one frame, found again on those of another one.
#pragma once

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

/// Per place of `now`: the nearest one, within a few pixels of where its point of the surface is in the other frame, on
/// a line of the same object and definition that runs beside it at about the same distance from the eye (what Kalnins
/// et al. 2003, section 4, hand on marks along). Lines of another object, or of the image, have none.
Array<FoundPlace> found_places(const ViewLines& now, const ViewLines& there);

/// The same on lines of any definition, right beside a place there. `counts`: per place there, whether it does.
Array<FoundPlace> places_beside(const ViewLines& now, const ViewLines& there, In<std::uint8_t> counts);

/// Per place: whether one that counts is right beside it, on another line or far along the same one.
Array<std::uint8_t> are_beside(const ViewLines& lines, In<std::uint8_t> counts);

}  // namespace fovea::elision
