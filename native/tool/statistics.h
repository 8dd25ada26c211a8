// SPDX-License-Identifier: GPL-3.0-or-later
// What a model is, which lines it has in a view, and how long each stage takes.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <tool/drawing.h>

namespace fovea::tool {

/// Names of the line definitions that are found along edges, and quickly.
std::vector<std::string> default_lines();

/// Elements of the model and of its surface; of a frame of it whose lines are seen (Frame::see), paths of each
/// definition that its style asks for, pixels, strokes if it has them, and milliseconds per stage.
nlohmann::ordered_json statistics(const Model& model, const Frame& frame);

}  // namespace fovea::tool
