// SPDX-License-Identifier: GPL-3.0-or-later
// Folds: edges that are sharp against their neighborhood, for creases of surfaces whose faces approximate a rounded
// shape.
#pragma once

#include <functional>

#include <fovea/field/facet_edges.h>

namespace fovea::line {

/// Per mesh edge: 1 if it is on a fold. A fold starts at edges that turn by at least `angle` degrees and stand out
/// clearly from what lies beside them, and continues along edges that do so less (hysteresis, as Canny has it).
/// `shape`: of the surface, never automatic: on hard ones, all edges that turn by more than 75 degrees are on folds; on
/// others, folds start at half as much again as `angle`; grooves of rounded ones at a third more, if they turn more
/// than twice as much as the surface does on average beside them: noses, lips and lids are formed by such.
/// `is_short`: folds of a length, in object units, that is short by it, and that touch no edge that is marked sharp are
/// left out as noise, and so are folds of one edge, but no grooves of three edges of a rounded surface; empty: none is.
Array<std::uint8_t> find_folds(const field::FacetEdges& edges, Shape shape, double angle,
                               const std::function<bool(double)>& is_short);

}  // namespace fovea::line
