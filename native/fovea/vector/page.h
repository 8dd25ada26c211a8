// SPDX-License-Identifier: GPL-3.0-or-later
// Where a picture lies on paper.
#pragma once

#include <fovea/base/view.h>
#include <fovea/style/ground.h>
#include <fovea/vector/options.h>

namespace fovea::vector {

struct Page {
    dvec2 size;      ///< in units of the document
    dvec2 lower;     ///< of the picture
    double scale;    ///< units per pixel of the picture
    double unit_mm;  ///< of a unit, on paper as high as the style says where units are pixels

    dvec2 place(const dvec2& px) const { return lower + scale * px; }
};

/// A rectangle on a page [mm].
struct Room {
    dvec2 lower, size;
};

/// Width and height of an upright sheet of paper [mm]; zero for those without a size of their own.
dvec2 sheet_size(Sheet sheet);

/// Where a picture may lie within the margins of paper of this size: all over, or above a title block and, if
/// that is not as wide, beside it.
/// Throws std::invalid_argument if there is no room.
std::vector<Room> rooms_of(const dvec2& size, const Options& options);

/// The picture in the middle of that room on a sheet where it can be largest, as large as there is room for, or to
/// scale as large as it is on the style's paper; a sheet lies as the picture does, on its long side or its short one.
/// Throws std::invalid_argument if there is no room, or less than the picture takes to scale.
Page page_of(const View& view, const style::Paper& paper, const Options& options);

}  // namespace fovea::vector
