// SPDX-License-Identifier: GPL-3.0-or-later
// Vector drawings of a cube.
#pragma once

#include <tool/drawing.h>
#include <tool/read_obj.h>

#include <fovea/vector/compose.h>

#include "model_files.h"

namespace fovea::vector_drawings {

inline constexpr int side = 540;  ///< half of the pixels that a page of 210 mm has in reference pixels

inline draw::Frame cube(const style::Style& style, int width = side, int height = side) {
    return tool::frame_of(tool::read_obj("cube.obj", model_files::cube_obj()), {.width = width, .height = height},
                          style, FOVEA_ADDON);
}

inline vector::Drawing drawn(const style::Style& style, const vector::Options& options = {}) {
    draw::Frame frame = cube(style);
    return vector::compose(frame, options);
}

inline std::vector<vector::Path> paths_of(const vector::Drawing& drawing) {
    std::vector<vector::Path> paths;
    vector::for_each_path(drawing.document.layers, [&](const vector::Path& path) { paths.push_back(path); });
    return paths;
}

}  // namespace fovea::vector_drawings
