// SPDX-License-Identifier: GPL-3.0-or-later
// Reads the polygons of PLY files: text, or binary of either byte order.
#pragma once

#include <string_view>
#include <tool/model.h>

namespace fovea::tool {

/// `file`: its name, for messages. Reads x, y and z of 'vertex' and the list vertex_indices (or vertex_index) of
/// 'face', of any type; everything else is ignored. Faces that refer to missing vertices are counted; throws
/// std::invalid_argument, naming the place, if the header or values cannot be read. (Debian's rply reads beyond its
/// buffer in broken files, and reports no position.)
Model read_ply(const std::string& file, std::string_view bytes);

}  // namespace fovea::tool
