// SPDX-License-Identifier: GPL-3.0-or-later
// One line where several definitions would draw nearly the same.
#pragma once

#include <map>

#include <fovea/line/definition.h>
#include <fovea/path/chain_curves.h>

namespace fovea {

/// Pieces of curves that a line set has already: of definitions that find the same ones, the first has them.
class Claims {
   public:
    explicit Claims(const Surface& surface) : surface_(surface) {}
    /// Those of `chains` that nobody has yet, which the rule's definition has from now on.
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

/// What is left of chains without the stretches that run for more than four side lengths through triangles with at
/// least so many corners that are `near` a line: that one is drawn there. Lines that cross it, or go on from its end,
/// stay.
CurveChains without_doubles(const CurveChains& chains, const Surface& surface, In<std::uint8_t> near, int corners = 3);

}  // namespace fovea
