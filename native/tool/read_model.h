// SPDX-License-Identifier: GPL-3.0-or-later
// Reads a model from a file, by its extension.
#pragma once

#include <filesystem>
#include <tool/model.h>

namespace fovea::tool {

/// An .obj or a .ply. Throws std::invalid_argument with one sentence that names the file.
Model read_model(const std::filesystem::path& path);

}  // namespace fovea::tool
