// SPDX-License-Identifier: GPL-3.0-or-later
// Removal of coincidence: places where two surfaces run beside each other and cross at random.
#pragma once

#include <fovea/scene/contact.h>

namespace fovea::scene {

/// Removes crossings of two surfaces that stay beside each other: decals and roads laid on a ground, navigation meshes,
/// two meshes of one shape. There, where they cross depends on how each was cut into triangles, not on their shapes.
///
/// A crossing is removed if on one side of it both surfaces, up to three times the longest side of its triangles away,
/// are closer to the other one than 1/50 of the way gone, or than triangles of smooth surfaces differ from these; a
/// surface that rises out of another as slowly as a beach out of the sea, at 1 in 20, is not beside it. Of what is left
/// of a curve, parts shorter than four times such a side go, too, and gaps shorter than one are closed: a curve ends in
/// one place, or is not there.
Crossings without_coincidence(const Crossings& crossings, const Mapped& first, const Mapped& second,
                              const Cancel& cancel);

}  // namespace fovea::scene
