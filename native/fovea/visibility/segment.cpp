// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/visibility/segment.h>

#include <string>

#include <fovea/base/check.h>
#include <fovea/line/registry.h>

namespace fovea::visibility {

Segment segment_at(const ClippedPaths& clipped, const Paths& paths, const Tracer& tracer, Index piece, Index i) {
    Segment s{dvec3(clipped.position_view[i]), dvec3(clipped.position_view[i + 1]), 1.0, 1.0, {}};
    const Index source = clipped.source[i], placement = paths.placement[clipped.path[piece]],
                place = paths.place[source];
    const auto& placements = tracer.scene().placements;
    check(placement < placements.size() && place < placements[placement].surface->place_count(),
          "visibility: the paths are not of this scene");
    const bool contour = (paths.kinds[source] & smooth_contours()) != 0;
    s.ignore = tracer.ignore_at(placement, place, paths.other_facet_at(source), contour);
    s.a += dvec3(s.ignore.above);
    s.b += dvec3(s.ignore.above);
    if (!tracer.view().orthographic) {
        s.wa = -s.a.z;
        s.wb = -s.b.z;
    }
    return s;
}

Interval hidden_by(const Occluding& by, const Tracer& tracer, const Segment& segment) {
    const Interval part = by.hides(tracer, segment.a, segment.b, segment.ignore);
    return part.is_empty() ? part : Interval{segment.to_screen(part.begin), segment.to_screen(part.end)};
}

void check_same_paths(const ClippedPaths& clipped, const Paths& paths, const char* what) {
    check(clipped.path.empty() || (clipped.path.back() < paths.count() && clipped.source.back() < paths.place.size()),
          std::string(what) + ": these are not the paths that were clipped");
}

}  // namespace fovea::visibility
