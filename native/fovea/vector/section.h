// SPDX-License-Identifier: GPL-3.0-or-later
// The filled inside of a section as outlines.
#pragma once

#include <fovea/draw/frame.h>
#include <fovea/vector/document.h>
#include <fovea/vector/page.h>

namespace fovea::vector {

/// A layer with one path, the inside of what the section plane cuts; without paths where the style does not fill it, or
/// there is none.
Layer section_layer(const Frame& frame, const Page& page);

}  // namespace fovea::vector
