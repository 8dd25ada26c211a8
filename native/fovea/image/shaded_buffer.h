// SPDX-License-Identifier: GPL-3.0-or-later
// The tone of a scene lit by one lamp, as the camera sees it.
#pragma once

#include <fovea/base/parallel.h>
#include <fovea/image/lattice.h>
#include <fovea/scene/tracer.h>

namespace fovea::image {

/// Direction of a distant lamp, in degrees from the viewer: 0, 0 is a lamp at the eye.
struct Lamp {
    double right = 0.0, up = 0.0;
};

/// What each node sees, one ray each, and 32 where neighbors differ. Placements that are not drawn hide what lies
/// behind them, but have no tone.
struct ShadedBuffer {
    Lattice lattice;
    Buffer tone;                ///< n . l in [0, 1], times coverage
    Buffer coverage;            ///< share of the rays that meet a surface whose lines are drawn
    Buffer distance;            ///< along the view, of the nearest surface its rays meet; infinite where there is none
    Array<std::uint8_t> drawn;  ///< 1 where the lines of that surface are drawn
};

/// Shades by n . l with normals interpolated between field/corner_normals.h, turned to the viewer with their facet.
ShadedBuffer shade(const Tracer& tracer, const Lattice& lattice, const Lamp& lamp, const Cancel& cancel);

}  // namespace fovea::image
