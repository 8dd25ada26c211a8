// SPDX-License-Identifier: GPL-3.0-or-later
// Pen textures from files.
#pragma once

#include <string>

#include <fovea/stroke/pen.h>

namespace fovea {

/// Reads a PNG as grey: white is full ink. Throws std::invalid_argument, naming the file, when it cannot be read.
PenTexture read_texture(const std::string& path);

}  // namespace fovea
