// SPDX-License-Identifier: GPL-3.0-or-later
// What is seen of the lines of one frame, for frames near it.
#pragma once

#include <optional>

#include <fovea/elision/line_parts.h>
#include <fovea/elision/view_lines.h>
#include <fovea/visibility/runs.h>

namespace fovea::elision {

/// Lines of the mesh, by the parts of it on which they lie, and those of the view, by places along them. Without lines
/// that are found in the image or make a tone.
struct SeenLines {
    /// Interval of a path, seen or hidden all along: from < to in arc length, object units.
    struct Stretch {
        double from, to;
        bool seen;
    };

    Array<LinePart> parts;  ///< by key, of paths of the mesh
    std::shared_ptr<const ViewLines> of_view;
    Array<std::uint8_t> seen;    ///< per place of the lines of the view
    Array<std::uint8_t> beside;  ///< per place of them, whether something is seen right beside it (found_places.h)
    Array<float> shown;  ///< what elision leaves of the lines of the view, per place, in [0, 1]; empty: not known
    /// Per path: its stretches, ascending and disjoint. What is between them is not in the picture.
    Lists<Stretch> stretches;
};

/// Whether a place of a path with these stretches is seen; none where they do not say it.
std::optional<bool> is_seen(In<SeenLines::Stretch> stretches, double arc);

/// `runs`: what is visible among them is seen. `of_view`: of the same paths.
SeenLines seen_lines(const ClippedPaths& clipped, const Paths& paths, const Scene& scene, const Runs& runs,
                     std::shared_ptr<const ViewLines> of_view);

}  // namespace fovea::elision
