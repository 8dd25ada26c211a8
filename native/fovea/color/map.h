// SPDX-License-Identifier: GPL-3.0-or-later
// Values along lines of an image that covers the camera's frame.
#pragma once

#include <fovea/base/view.h>
#include <fovea/color/texture.h>
#include <fovea/project/clipped_paths.h>

namespace fovea::color {

/// Luminance in [0,1] (Rec. 709, scene-linear) of the image at each atlas sample. The image covers the whole frame, of
/// which a view may show a part, and is clamped beyond its borders.
Array<float> map_of_samples(const ClippedPaths& clipped, const View& view, const ColorTexture& image);

}  // namespace fovea::color
