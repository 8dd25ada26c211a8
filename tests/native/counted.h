// SPDX-License-Identifier: GPL-3.0-or-later
// Runs of whole pictures with the surfaces that hide them counted.
#pragma once

#include <fovea/runs/invisibility.h>

#include "wires.h"

namespace fovea::wires {
using namespace draw;

/// All runs of paths, hidden ones counted.
struct Counted {
    ClippedPaths clipped;
    Runs runs;

    Counted(const Scene& scene, const Paths& paths, const View& view, Index levels, const ProjectOptions& options = {})
        : clipped(project::project(paths, scene, view, options, Cancel())) {
        const Tracer tracer(scene, view);
        const Runs visible = exact_visibility(clipped, paths, tracer, Cancel());
        const Runs all = with_hidden(clipped, visible, paths.placement);
        runs = count_invisibility(clipped, paths, tracer, all, levels, Cancel());
    }
    Counted(const Wires& wires, const View& view, Index levels) : Counted(wires.scene, wires.paths, view, levels) {}

    /// Of a piece that is one straight segment: the numbers along it, and the pixels where they change.
    std::vector<int> numbers(Index piece = 0) const {
        std::vector<int> found;
        for (std::size_t r = 0; r < runs.size(); ++r)
            if (runs.piece[r] == piece) found.push_back(runs.invisibility[r]);
        return found;
    }
    std::vector<dvec2> changes(Index piece = 0) const {
        std::vector<dvec2> found;
        const Index first = first_of(clipped, piece), last = last_of(clipped, piece);
        const double from = clipped.arc_px[first], length = clipped.arc_px[last] - from;
        for (std::size_t r = 0; r + 1 < runs.size(); ++r)
            if (runs.piece[r] == piece && runs.piece[r + 1] == piece)
                found.push_back(
                    glm::mix(dvec2(clipped.px[first]), dvec2(clipped.px[last]), (runs.end_px[r] - from) / length));
        return found;
    }
    std::map<int, double> lengths() const {
        std::map<int, double> sum;
        for (std::size_t r = 0; r < runs.size(); ++r) sum[runs.invisibility[r]] += runs.end_px[r] - runs.start_px[r];
        return sum;
    }
};

}  // namespace fovea::wires
