// SPDX-License-Identifier: GPL-3.0-or-later
// What the artist has painted on meshes, along the lines.
#pragma once

#include <fovea/path/paths.h>
#include <fovea/scene/scene.h>

namespace fovea::path {

/// What counts where nothing is painted.
inline constexpr float unpainted = 0.5f;

/// By placement: a value per corner of its mesh, in [0,1] (others are clamped; what is not a number is unpainted).
/// Empty: nothing is painted on it.
using Painted = std::vector<In<float>>;

/// A painted value as it counts.
float painted_value(float value);

/// Throws std::invalid_argument where there is not one array per placement, or one does not fit its mesh.
void check_painted(const Painted& painted, const Scene& scene);

/// The painted value at each point of paths. On an edge it is linear between the edge's vertices, each with the mean of
/// the polygons beside the edge; in a triangle linear between its corners (at its nearest place, for points a hair
/// outside). Unpainted: paths found in the image, and edges without polygons. A line on two surfaces asks the first.
/// Throws as check_painted.
Array<float> values_on_paths(const Paths& paths, const Scene& scene, const Painted& painted);

}  // namespace fovea::path
