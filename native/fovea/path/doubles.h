// SPDX-License-Identifier: GPL-3.0-or-later
// Removal of duplicates: lines that several definitions would draw almost at the same place.
#pragma once

#include <functional>
#include <map>

#include <fovea/line/definition.h>
#include <fovea/path/chain_curves.h>
#include <fovea/path/marked_edges.h>

namespace fovea::path {

/// Ownership of triangles: where two definitions trace the same curve, the first line set keeps it.
class Claims {
   public:
    explicit Claims(const Surface& surface) : surface_(surface) {}
    /// The parts of `chains` on triangles that are not owned yet; then marks their triangles as owned for the rule's
    /// definition (the one that it is part of, if any).
    CurveChains claim(const CurveRule& rule, CurveChains chains);

   private:
    const Surface& surface_;
    std::map<const CurveRule*, Array<std::uint8_t>> taken_;  // per triangle, per rule (of the whole definition)
};

/// Per vertex: 1 if it is within two triangles of the contour of the smooth surface. `without`: 1 for triangles on
/// which contours are not drawn; or empty.
Array<std::uint8_t> near_smooth_contour(const SurfaceView& seen, In<std::uint8_t> without = {});

/// Per vertex: 1 if it is within two triangles of some curves, but not at their ends: there another line goes on.
Array<std::uint8_t> near_curves(const Surface& surface, const std::vector<const CurveChains*>& curves);

/// Without the kinds doubled(edge) of edges close to a smooth contour, which replaces them, except where the mesh has a
/// hard edge. `near`: from near_curves.
MarkedEdges without_doubled(const MarkedEdges& marked, const Surface& surface, In<std::uint8_t> near,
                            const std::function<Kinds(Index edge)>& doubled);

/// Per vertex: 1 at the ends of hard edges with lines of one of `kinds`.
Array<std::uint8_t> at_hard_edges(const Surface& surface, Kinds kinds, const std::vector<MarkedEdges>& of_sets);

/// Removes stretches longer than four mean side lengths on whose triangles at least `corners` vertices are `near` a
/// line, which is drawn instead. Lines that cross or continue that line remain.
CurveChains without_doubles(const CurveChains& chains, const Surface& surface, In<std::uint8_t> near, int corners = 3);

}  // namespace fovea::path
