// SPDX-License-Identifier: GPL-3.0-or-later
// Where an object ends, in the image, along its contour and border edges.
#pragma once

#include <fovea/line/definition.h>

namespace fovea::line {

/// Tests what is behind the edges of one placement, by rays.
class OuterEdges {
   public:
    /// `seen` must outlive this. Its facing may be empty: then it is found for each edge that is asked for.
    explicit OuterEdges(const SurfaceView& seen);

    /// Whether neither the placement nor one of its group continues behind the middle of an edge, or next to it. On
    /// coarse meshes, facets seen almost edge-on lie slightly behind one another along a contour: a continuation
    /// narrower than a pen is ignored.
    bool ends_at(Index e) const;

    /// Share of a strip outside of an edge, `width_px` reference pixels wide and as long as the edge, in which neither
    /// continues: from rays at so many places, spread evenly.
    double share_outside(Index e, double width_px, int places) const;

   private:
    /// An edge in the view, and the direction in the image to the outside of it.
    struct Seen {
        dvec4 a, b;
        dvec2 outside{0.0};  ///< unit length; 0 where the edge has no length in the image
        Ignore ignore;
    };

    Seen see(Index e) const;
    bool ends_beside(const Seen& edge, const dvec4& place, double px) const;
    dvec3 beside(const dvec2& px, double away) const;
    dvec4 in_view(Index vertex) const;
    bool lies_left(Index e) const;

    const SurfaceView& seen_;
    const View& view_;
    const dmat4 clip_to_view_;
    const bool mirrored_;
};

}  // namespace fovea::line
