// SPDX-License-Identifier: GPL-3.0-or-later
// Diffuse shading of a scene by one lamp, sampled on a lattice.
#pragma once

#include <fovea/base/parallel.h>
#include <fovea/image/lattice.h>
#include <fovea/scene/tracer.h>

namespace fovea::image {

/// Direction to a distant lamp, in degrees from the viewer; 0, 0 is a headlight.
struct Lamp {
    double right = 0.0, up = 0.0;
};

/// Samples per node: one ray, or 32 where the node differs from a neighbor. Placements that are not drawn occlude but
/// have no tone.
struct ShadedBuffer {
    Lattice lattice;
    Buffer tone;                ///< n . l in [0, 1], averaged over all rays (0 where they hit nothing drawn)
    Buffer coverage;            ///< share of the rays that hit a placement whose lines are drawn
    Buffer distance;            ///< of the nearest hit, along -z in view space; infinite if no ray hits
    Array<std::uint8_t> drawn;  ///< 1 if that nearest hit is on a placement whose lines are drawn
};

/// Shades by n . l with normals interpolated from field/corner_normals.h, flipped where their facet is back-facing.
ShadedBuffer shade(const Tracer& tracer, const Lattice& lattice, const Lamp& lamp, const Cancel& cancel);

}  // namespace fovea::image
