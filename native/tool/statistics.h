// SPDX-License-Identifier: GPL-3.0-or-later
// What a model is, which lines it has in a view, and how long each stage takes.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <tool/camera.h>
#include <tool/model.h>

namespace fovea::tool {

/// Names of the line definitions that are found along edges, and quickly.
std::vector<std::string> default_lines();

/// Elements of the model and of its surface, paths and pixels of each of the definitions, all with their defaults, and
/// milliseconds per stage. Throws std::invalid_argument for a definition that does not exist.
nlohmann::ordered_json statistics(const Model& model, const Camera& camera, const std::vector<std::string>& lines);

}  // namespace fovea::tool
