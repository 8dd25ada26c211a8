// SPDX-License-Identifier: GPL-3.0-or-later
// An image laid over the camera's frame, along the lines.
#pragma once

#include <fovea/base/view.h>
#include <fovea/color/texture.h>
#include <fovea/project/clipped_paths.h>

namespace fovea::color {

/// Luminance in [0,1] (Rec. 709, scene-linear) of the image where each atlas sample lies; the image's borders are those
/// of the whole frame, of which a view may show a part, and beyond them it goes on as at them.
Array<float> map_of_samples(const ClippedPaths& clipped, const View& view, const ColorTexture& image);

}  // namespace fovea::color
