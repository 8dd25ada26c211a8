// SPDX-License-Identifier: GPL-3.0-or-later
// Bevels: edges rounded or cut off by faces that are narrow beside what they join. An artist draws the edge.
#pragma once

#include <fovea/field/facet_edges.h>

namespace fovea::line {

/// Per mesh edge: 1 if it is the middle one of a bevel. A bevel is two to 16 edges alongside each other that turn the
/// same way, by at least 75 degrees, or `angle`, and at most 120 together; as far again as twice its width, on both
/// sides, the surface turns by less than a quarter of that, and at no edge within its width by half as much as at its
/// own; and it is at least five times as long as wide. Of two edges that are equally near to the middle it is the one
/// towards the side that faces z, else y, else x, so that the edges of one bevel are in a row.
/// `known`: per mesh edge, whether it is a line anyway, which is not looked for again; empty: none is.
Array<std::uint8_t> find_bevels(const field::FacetEdges& edges, double angle, In<std::uint8_t> known = {});

}  // namespace fovea::line
