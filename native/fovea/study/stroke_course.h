// SPDX-License-Identifier: GPL-3.0-or-later
// Where strokes of a picture run beside the lines that they were drawn after, and how far beyond their ends.
#pragma once

#include <fovea/base/columns.h>
#include <fovea/color/png.h>
#include <fovea/study/bitmap.h>

namespace fovea::study {

/// Samples along lines, a pixel apart from half a pixel on; line i has the samples first[i] to first[i + 1].
struct StrokeCourses {
    Array<float> away;  ///< [px] of the stroke's middle to the left of the line; NaN: it cannot be told
    Array<std::int64_t> first;
    Array<vec2> beyond;  ///< per line, beyond its start and its end: how far the stroke goes on [px]; NaN: not told

    static constexpr auto columns = each_of(
        Column{"away", &StrokeCourses::away,
               "(S,) float32 [px] of strokes to the left of lines, a pixel apart along them; NaN: not told"},
        Column{"first", &StrokeCourses::first, "(R + 1,) int64: line i has the samples first[i] to first[i + 1]"},
        Column{
            "beyond", &StrokeCourses::beyond,
            "(R, 2) float32 [px] that strokes go on beyond starts and ends of lines, below 0: they stop before; NaN: "
            "not told"});
};

struct CourseOptions {
    double reach = 5.0;  ///< [px] farthest that a stroke is from its line
    double cap = 0.5;    ///< of a stroke's width that is beyond its end
};

/// `px`, `offsets`: lines, as for pixels_of. `is_free`: two values per line, whether its start and its end are
/// told. `every`: the pixels of all lines that may be in the picture: near to others, and where another one goes on
/// ahead, nothing is told.
StrokeCourses courses_of(const color::GrayImage& picture, In<vec2> px, In<std::int64_t> offsets,
                         In<std::uint8_t> is_free, const Bitmap& every, const CourseOptions& options);

}  // namespace fovea::study
