// SPDX-License-Identifier: GPL-3.0-or-later
// What is painted on surfaces, sampled along paths.
#pragma once

#include <fovea/path/paths.h>
#include <fovea/scene/scene.h>

namespace fovea::path {

/// Value where nothing is painted.
inline constexpr float unpainted = 0.5f;

inline constexpr float most_light = 1000.0f;  ///< of a channel of a painted color

/// What of a surface has one value each: a corner of its mesh (a vertex, if that has no polygons), a material by its
/// number (Surface::polygon_material), or all of it.
enum class PaintedOn : std::uint8_t { corners, materials, surface };

/// Per placement: its values; empty: nothing is painted. Numbers are clamped to [0, 1], channels of colors to
/// [0, most_light]; NaN counts as unpainted.
using Painted = std::vector<In<float>>;
using PaintedColors = std::vector<In<vec3>>;

/// A painted value within its limits; NaN gives `instead`.
float painted_value(float value, float instead = unpainted);
vec3 painted_value(const vec3& value, const vec3& instead);

/// Throws std::invalid_argument if there is not one array per placement, or an array does not match its surface.
void check_painted(const Painted& painted, const Scene& scene);

/// Painted value at each point of paths. On an edge: linear between its vertices, each with the mean of the polygons at
/// the edge. In a triangle: linear between its corners (at the nearest position inside, as points may be slightly
/// outside). An edge without polygons: the value of its vertices, of the first material or of the surface. `instead`:
/// image-space paths, and where nothing is painted. For a line on two surfaces the first one is sampled. Throws as
/// check_painted does.
Array<float> values_on_paths(const Paths& paths, const Scene& scene, const Painted& painted, float instead = unpainted,
                             PaintedOn on = PaintedOn::corners);
Array<vec3> values_on_paths(const Paths& paths, const Scene& scene, const PaintedColors& painted, const vec3& instead,
                            PaintedOn on);

}  // namespace fovea::path
