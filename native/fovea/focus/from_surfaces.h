// SPDX-License-Identifier: GPL-3.0-or-later
// Focus by distance from surfaces: asked for at few places, in between where it cannot change much (focus_tolerance).
#pragma once

#include <fovea/focus/focus.h>

namespace fovea {

/// f of each atlas sample: pieces are halved until f cannot change by more than the tolerance over a part.
Array<float> focus_along_pieces(const ClippedPaths& clipped, const Focus& focus);

/// f of each pixel: of a lattice first, then of what lies between, where the surface seen goes on there.
class FocusBetweenPixels {
   public:
    /// Borrows all of them; `distance` as for focus_of_pixels.
    FocusBetweenPixels(const View& view, In<float> distance, const Focus& focus);
    Array<float> all() const;

   private:
    struct Known {
        vec3 place;
        float f;
    };
    vec3 place(int x, int y) const;
    float exact(const vec3& place) const;
    Known known(int x, int y) const;
    float at(int x, int y, const Known corners[4]) const;

    const View& view_;
    In<float> distance_;
    const Focus& focus_;
    dmat4 clip_to_view_;
    float reach_;  // over which f cannot change by more than the tolerance
};

}  // namespace fovea
