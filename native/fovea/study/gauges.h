// SPDX-License-Identifier: GPL-3.0-or-later
// Places of a picture for gauges, which people turn until they seem to lie on the surface, and the normals that gauges
// should show there. Cole 2009, sections 4.2.2 and 4.2.5.
#pragma once

#include <fovea/base/columns.h>
#include <fovea/scene/tracer.h>

namespace fovea::study {

using namespace vector;  // as in bitmap.h

/// The unit normal of a gauge, drawn without perspective, that looks as a small disc with this normal and this place in
/// view space does to a view: its slant by how narrow the ellipse is, its tilt by the ellipse's minor axis, on the side
/// that the projected normal points to. x to the right, y up, z towards the viewer; a disc that is seen from below
/// looks as it does from above.
dvec3 gauge_normal(const View& view, const dvec3& place, const dvec3& normal);

/// What is seen at places of a picture.
struct GaugePlaces {
    /// `none` where all within the radius is not one surface: of one placement, without creases or steps in depth.
    Array<Index> placement;
    Array<dvec3> normal;  ///< as gauges show it; zero where there is none

    static constexpr auto columns =
        each_of(Column{"placement", &GaugePlaces::placement,
                       "(N,) uint32; 0xffffffff: not one surface, without creases and steps"},
                Column{"normal", &GaugePlaces::normal,
                       "(N, 3) float64 as gauges show it: x to the right, y up, z towards the viewer"});
};

/// Of pixels from the lower left; normals are those of the smooth surface, split at hard edges. `radius` [px].
GaugePlaces gauge_places(const Tracer& tracer, In<dvec2> px, double radius);

}  // namespace fovea::study
