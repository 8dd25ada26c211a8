// SPDX-License-Identifier: GPL-3.0-or-later
// Where water leaves pigment as washes dry. Curtis et al., "Computer-Generated Watercolor", SIGGRAPH 1997; Bousseau et
// al., "Interactive Watercolor Rendering with Temporal Coherence and Abstraction", NPAR 2006.
#pragma once

#include <fovea/color/paper.h>

namespace fovea::color {

/// Factor of the optical density of a color layer, one per pixel, for on_paper; empty where the style has neither
/// darkened edges nor backruns. Edges: where a wash is denser than the mean around it, so that it darkens just inside
/// its border with the paper or a lighter wash. Backruns: by `water` as a height map, of which heights have least
/// pigment; the mean stays. `layer`: premultiplied, one entry per pixel, bottom row first; `water`: may be null.
Array<float> wash_density(In<vec4> layer, const View& view, const PaperTexture* water, const style::Paper& paper,
                          const style::Color& color);

}  // namespace fovea::color
