// SPDX-License-Identifier: GPL-3.0-or-later
// Decides what the polygons of a surface stand for, from its shading and from how it bends.
//
// A vertex counts as rounded where the surface bends along both principal directions (the curvature tensor of its
// edges: Cohen-Steiner & Morvan, "Restricted Delaunay Triangulations and Normal Cycle", SoCG 2003), by little: by up to
// 15 degrees at an edge on average, 45 where shading is smooth, and has no fold. Planes, cylinders and cones bend in
// one direction or none, so machine parts and furniture have few such vertices.
#pragma once

#include <memory>
#include <string>

#include <fovea/mesh/surface.h>

namespace fovea::field {

struct DecidedShape {
    Shape shape;         ///< never automatic
    std::string reason;  ///< one sentence
};

/// The surface's own shape, where one is set. Else smooth if it is a subdivision's limit; hard if less than 42 % of its
/// area is rounded; of others smooth if that part turns by at most 8.5 degrees at an edge on average, triangles with
/// rounded corners only, inside of which lines of curvature can run, are at least 30 % of the area, and the normals of
/// the fitted surface (field/fields.h) are within 25 degrees of the triangles' on all but 13 % of the area, else
/// rounded. Depends on positions up to rotation and scale, and on marks; cached with the surface. A stretched surface
/// has the shape of its source.
std::shared_ptr<const DecidedShape> decided_shape(const Surface& surface);
inline Shape shape_of(const Surface& surface) { return decided_shape(surface)->shape; }

/// The decided shape if it is cached, else null; never waits.
std::shared_ptr<const DecidedShape> known_shape(const Surface& surface);

}  // namespace fovea::field
