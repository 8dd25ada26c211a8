// SPDX-License-Identifier: GPL-3.0-or-later
// Solids and open sheets among the connected parts of a surface.
#pragma once

#include <fovea/scene/scene.h>

namespace fovea::scene {

/// Facets of a surface that hide, gathered in bodies: components connected by edges. A solid body is closed and
/// consistently oriented: at each of its edges as many sides run one way as the other. All others are sheets, however
/// small their holes.
struct Bodies {
    Array<Index> of_facet;      ///< body, numbered by first facet; `none` where a facet hides nothing
    Array<std::uint8_t> solid;  ///< per body
    bool all_outward = false;   ///< there are bodies, all are solid, and the volume inside each is positive

    explicit Bodies(const Surface& surface);
};

/// Kept with the surface.
std::shared_ptr<const Bodies> bodies_of(const Surface& surface);

/// Of every placement that hides something (null of others).
using SceneBodies = std::vector<std::shared_ptr<const Bodies>>;
SceneBodies bodies_of(const Scene& scene);

}  // namespace fovea::scene
