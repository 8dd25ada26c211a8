// SPDX-License-Identifier: GPL-3.0-or-later
// Strips: bevels and chamfers, faces between two edges that run alongside each other and turn the same way.
#pragma once

#include <memory>

#include <fovea/mesh/surface.h>

namespace fovea::field {

/// Per mesh edge: the other edge of the narrowest strip beside it, or none; empty if there are no strips. Both edges
/// turn by 15 to 65 degrees: by more, faces between them are those of a board. Cached with the surface.
std::shared_ptr<const Array<Index>> strips_of(const Surface& surface);

}  // namespace fovea::field
