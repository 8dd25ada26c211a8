// SPDX-License-Identifier: GPL-3.0-or-later
// See-through surfaces: those that hide no lines, but whose material has some color of its own.
#pragma once

#include <fovea/color/items.h>
#include <fovea/color/shader.h>
#include <fovea/scene/tracer.h>

namespace fovea::color {

/// Composites see-through surfaces over the color layer, the farthest first: facets that do not occlude, of placements
/// that do, as far as they lie before all that occludes; a sheet covers what is behind it by ColorSlot::opacity. One
/// sample per pixel, and 16 where neighbors differ. No shadows. `items`: of the scene. `layer`: premultiplied.
void put_sheets(const Tracer& tracer, const SceneColor& colors, const ColorShader& shader, const Items& items,
                const Cancel& cancel, Array<vec4>& layer);

}  // namespace fovea::color
