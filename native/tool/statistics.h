// SPDX-License-Identifier: GPL-3.0-or-later
// Statistics of a model, of its lines in a view, and of the time per stage.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <tool/drawing.h>

namespace fovea::tool {

/// Names of the default line definitions: those traced along mesh edges, which are fast.
std::vector<std::string> default_lines();

/// Elements of the model and of its surface; and, for a frame of it after Frame::see, paths per definition of its
/// style, pixels, strokes if there are any, and milliseconds per stage.
nlohmann::ordered_json statistics(const Model& model, const Frame& frame);

/// How much there is in a file of vectors.
nlohmann::ordered_json statistics(const vector::Drawing& drawing);

}  // namespace fovea::tool
