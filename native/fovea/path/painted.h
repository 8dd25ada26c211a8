// SPDX-License-Identifier: GPL-3.0-or-later
// Painted mesh attributes, sampled along paths.
#pragma once

#include <fovea/path/paths.h>
#include <fovea/scene/scene.h>

namespace fovea::path {

/// Value where nothing is painted.
inline constexpr float unpainted = 0.5f;

/// Per placement: a value per corner of its mesh, clamped to [0, 1]; NaN counts as unpainted. Empty: nothing is
/// painted.
using Painted = std::vector<In<float>>;

/// Clamps a painted value to [0, 1]; NaN gives `unpainted`.
float painted_value(float value);

/// Throws std::invalid_argument if there is not one array per placement, or an array does not match its mesh.
void check_painted(const Painted& painted, const Scene& scene);

/// Painted value at each point of paths. On an edge: linear between its vertices, each with the mean of the polygons at
/// the edge. In a triangle: linear between its corners (at the nearest position inside, as points may be slightly
/// outside). Unpainted: image-space paths and edges without polygons. For a line on two surfaces the first one is
/// sampled. Throws as check_painted does.
Array<float> values_on_paths(const Paths& paths, const Scene& scene, const Painted& painted);

}  // namespace fovea::path
