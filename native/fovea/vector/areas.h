// SPDX-License-Identifier: GPL-3.0-or-later
// Colors below the lines as filled areas.
#pragma once

#include <fovea/draw/frame.h>
#include <fovea/vector/borders.h>
#include <fovea/vector/document.h>
#include <fovea/vector/page.h>

namespace fovea::vector {

/// The curves around each label, which is on their left: to be filled by the nonzero rule. Borders are fitted within
/// `tolerance`, of the units of the page.
std::vector<std::pair<Label, std::vector<Curve>>> outlines_of(const std::vector<Border>& borders, const Page& page,
                                                              double tolerance);

/// A layer with an area for each object, material and band of toon shading that is seen, of the mean color of its
/// pixels. Takes all steps of the frame, which has colors.
Layer colors_layer(Frame& frame, const Page& page, double tolerance);

}  // namespace fovea::vector
