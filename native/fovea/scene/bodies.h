// SPDX-License-Identifier: GPL-3.0-or-later
// Connected components of a surface, classified as solids and open shells.
#pragma once

#include <fovea/scene/scene.h>

namespace fovea::scene {

/// Connected components (over edges) of the occluding facets of a surface. A component is solid if it is closed and
/// consistently oriented: at each of its edges as many sides run one way as the other. All others are open shells,
/// however small their holes. Open edges whose ends lie in the same places are one edge: files split meshes along
/// texture seams and where normals differ.
struct Bodies {
    Array<Index> of_facet;        ///< component index, numbered by first facet; `none` for facets that do not occlude
    Array<std::uint8_t> solid;    ///< per component
    Array<std::uint8_t> outward;  ///< per component: it is solid and encloses positive volume
    bool all_outward = false;     ///< there is a component, and all are outward

    explicit Bodies(const Surface& surface);
};

/// Cached with the surface.
std::shared_ptr<const Bodies> bodies_of(const Surface& surface);

/// Per placement; null for those that do not occlude.
using SceneBodies = std::vector<std::shared_ptr<const Bodies>>;
SceneBodies bodies_of(const Scene& scene);

}  // namespace fovea::scene
