// SPDX-License-Identifier: GPL-3.0-or-later
// Meshes as others hand them over: mostly sound, often broken.
#pragma once

#include "choices.h"
#include "meshes.h"

namespace fovea::fuzz {

/// Polygons of any number of corners, with up to a few faults and marks; sometimes its arrays contradict each other.
meshes::Mesh random_mesh(Choices& choices);

/// Adds a fault.
void spoil(Choices& choices, meshes::Mesh& mesh);

std::vector<vec3> places(Choices& choices, int count);

}  // namespace fovea::fuzz
