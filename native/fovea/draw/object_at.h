// SPDX-License-Identifier: GPL-3.0-or-later
// Which object a place of the picture shows.
#pragma once

#include <string>

#include <fovea/draw/frame.h>

namespace fovea::draw {

/// Name of the object that a disc of the picture shows most of, the middle of it counting most; empty: it shows none
/// that has a name. Pixels are from the lower left. Requires find().
std::string object_at(const Frame& frame, const dvec2& px, double radius);

}  // namespace fovea::draw
