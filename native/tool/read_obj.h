// SPDX-License-Identifier: GPL-3.0-or-later
// Reads the polygons of Wavefront OBJ files as they stand: no axis swap, no scaling, no welding.
#pragma once

#include <string_view>
#include <tool/model.h>

namespace fovea::tool {

/// `file`: its name, for messages. Takes v, f and usemtl; everything else, normals and texture coordinates at corners
/// among it, is passed over. Broken elements are counted; throws std::invalid_argument for what is no OBJ at all.
/// (Debian's tinyobjloader gives up a whole file for one broken face, and takes what is no number for 0.)
Model read_obj(const std::string& file, std::string_view text);

}  // namespace fovea::tool
