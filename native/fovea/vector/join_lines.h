// SPDX-License-Identifier: GPL-3.0-or-later
// Lines as a plotter draws them: each once, and joined where they meet.
#pragma once

#include <fovea/vector/curve.h>

namespace fovea::vector {

/// A polyline that a pen draws without being lifted.
struct Line {
    Points points;
    bool closed = false;     ///< the last point repeats the first
    std::size_t origin = 0;  ///< number of the line that it is, or the first that it is made of
    Index dash_of = none;    ///< the stroke whose dash it is
};

/// Without what runs along lines that are kept, longer ones first: within `near` of one for more than `least`, in about
/// its direction. What is left of a line may be several.
std::vector<Line> without_doubles(std::vector<Line> lines, double near, double least);

/// Joins lines whose ends are within `near` of each other, in pairs: those first that go on most straight. Lines whose
/// own ends meet become closed. Dashes of one stroke are not joined, however short its gaps are, and an end where very
/// many lines meet may be left as it is.
std::vector<Line> joined(std::vector<Line> lines, double near);

}  // namespace fovea::vector
