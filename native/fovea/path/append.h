// SPDX-License-Identifier: GPL-3.0-or-later
// Chains of edges and of curves, as paths.
#pragma once

#include <fovea/path/find_curves.h>
#include <fovea/path/find_edges.h>
#include <fovea/path/paths.h>

namespace fovea::path {

/// Appends the chains that are found on placements of a scene, or in the image, to Paths.
class Appender {
   public:
    /// Paths of a single segment that is in front of the near plane, and not longer than `least_px` in the image, are
    /// left out: of instances far away there may be many millions.
    Appender(const Scene& scene, const View& view, double least_px) : scene_(scene), view_(view), least_px_(least_px) {}

    /// `placement`: `none` for curves in the image. `of_view`: the chains depend on the view.
    void append(Index placement, const EdgeChains& found, bool of_view, Paths& paths);
    void append(Index placement, const FoundCurves& found, bool of_view, Paths& paths);

   private:
    /// Where chains are written, and what their paths have in common.
    struct Slot {
        Index placement, path;
        bool of_view;
    };
    /// Chooses the chains to write, and adds rows for them. `point`: position of a point of the chains.
    template <typename Point>
    Slot add_rows(Index placement, const Rows& rows, bool of_view, const Point& point, Paths& paths);
    template <typename Chains, typename LineSet, typename Free, typename Id, typename Point, typename AtRest,
              typename More>
    void write(const Chains& chains, Slot slot, const LineSet& line_set, const Free& free, const Id& id,
               const Point& point, const AtRest& at_rest, const More& more, Paths& paths) const;
    /// Length in the image; infinite if an end is not in front of the near plane.
    double length_px(const vec3& a, const vec3& b) const;
    void look_at(Index placement);

    const Scene& scene_;
    const View& view_;
    const double least_px_;
    Array<Index> chosen_;     // chains that are written
    Index placement_ = none;  // whose transforms are set; none: view space
    dmat4 object_to_view_{1.0};
    dmat4 object_to_clip_ = view_.view_to_clip;
};

/// Concatenates parts; each is freed once it is copied.
Paths join(std::vector<Paths>& parts);

}  // namespace fovea::path
