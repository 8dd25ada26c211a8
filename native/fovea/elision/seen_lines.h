// SPDX-License-Identifier: GPL-3.0-or-later
// What is seen of the lines of the mesh in one frame, for frames near it.
#pragma once

#include <fovea/elision/line_parts.h>
#include <fovea/visibility/runs.h>

namespace fovea::elision {

/// The lines of a frame that do not depend on its view.
struct SeenLines {
    /// Interval of a path, seen or hidden all along: from < to in arc length, object units.
    struct Stretch {
        double from, to;
        bool seen;
    };

    Array<LinePart> parts;  ///< by key, of paths with stretches
    /// Per path: its stretches, ascending and disjoint. What is between them is not in the picture.
    Lists<Stretch> stretches;
};

/// `runs`: what is visible among them is seen.
SeenLines seen_lines(const ClippedPaths& clipped, const Paths& paths, const Scene& scene, const Runs& runs);

}  // namespace fovea::elision
