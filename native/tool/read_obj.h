// SPDX-License-Identifier: GPL-3.0-or-later
// Reads the polygons of Wavefront OBJ files unchanged: no axis swap, no scaling, no welding.
#pragma once

#include <string_view>
#include <tool/model.h>

namespace fovea::tool {

/// `file`: its name, for messages. Reads v, f and usemtl; everything else, including normals and texture coordinates of
/// corners, is ignored. Broken elements are counted; throws std::invalid_argument if the text is not an OBJ at all.
/// (Debian's tinyobjloader rejects a whole file for one broken face, and reads invalid numbers as 0.)
Model read_obj(const std::string& file, std::string_view text);

}  // namespace fovea::tool
