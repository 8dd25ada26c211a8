// SPDX-License-Identifier: GPL-3.0-or-later
// Lines on backs that are not seen, because their polygons are one-sided, or the backs are the inside of a solid that
// the section plane cuts: what is cut through hides it.
#pragma once

#include <fovea/path/paths.h>
#include <fovea/scene/bodies.h>

namespace fovea::project {

/// The one-sided surfaces and the cut solids of a scene in a view. Borrows the scene.
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
    Array<dvec4> eyes_;  // per placement, in its object space: see Surface::culled; empty: there are no such backs
    SceneBodies cut_;    // of placements that the viewer sees cut; null: of others; empty: there are none
    Kinds on_fronts_;    // lines that bound what faces the viewer, or lie on what is cut
};

}  // namespace fovea::project
