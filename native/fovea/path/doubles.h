// SPDX-License-Identifier: GPL-3.0-or-later
// One line where several definitions would draw nearly the same.
#pragma once

#include <map>

#include <fovea/line/definition.h>
#include <fovea/path/chain_curves.h>

namespace fovea::path {

/// Which triangles' curves a line set has already: where two definitions trace the same curve, the first keeps it.
class Claims {
   public:
    explicit Claims(const Surface& surface) : surface_(surface) {}
    /// The parts of `chains` on triangles that are not claimed yet; claims them for the rule's definition.
    CurveChains claim(const CurveRule& rule, CurveChains chains);

   private:
    const Surface& surface_;
    std::map<const CurveRule*, Array<std::uint8_t>> taken_;  // per triangle, by what the definitions are part of
};

/// Per vertex: 1 within two triangles of where the smooth surface turns away from the viewer. `without`: 1 on triangles
/// where no contour is drawn; or empty.
Array<std::uint8_t> near_smooth_contour(const SurfaceView& seen, In<std::uint8_t> without = {});

/// Clears an edge's `bits` near a smooth contour, which is drawn instead, but where the mesh has a hard edge.
void drop_doubled_edges(const Surface& surface, In<std::uint8_t> near, In<Kinds> bits, Array<Kinds>& kinds);

/// Per vertex: 1 at the ends of hard edges of the mesh that have one of `bits`.
Array<std::uint8_t> at_hard_edges(const Surface& surface, Kinds bits, In<Kinds> kinds);

/// Chains without the stretches longer than four side lengths whose triangles have at least `corners` vertices `near`
/// a line: that line is drawn there. What crosses it, or continues it, stays.
CurveChains without_doubles(const CurveChains& chains, const Surface& surface, In<std::uint8_t> near, int corners = 3);

}  // namespace fovea::path
