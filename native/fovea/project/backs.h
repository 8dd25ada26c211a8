// SPDX-License-Identifier: GPL-3.0-or-later
// Lines on backs that are not seen, because their polygons are one-sided.
#pragma once

#include <fovea/path/paths.h>
#include <fovea/scene/scene.h>

namespace fovea::project {

/// The one-sided surfaces of a scene in a view. Borrows the scene.
class Backs {
   public:
    Backs(const Scene& scene, const View& view);

    /// Whether there are any; else no line is on a back.
    bool any() const { return !eyes_.empty(); }
    /// Whether the segment that starts at a point of a path lies on nothing but backs, or, if it lies on two surfaces,
    /// on one. Smooth contours may run across triangles that face away already, but what they bound faces the viewer.
    bool hold(const Paths& paths, Index path, Index point) const;

   private:
    bool culled(Index placement, Index facet) const;

    const Scene& scene_;
    Array<dvec4> eyes_;  // per placement, in its object space: see Surface::culled; empty: no surface is one-sided
    Kinds contours_;
};

}  // namespace fovea::project
