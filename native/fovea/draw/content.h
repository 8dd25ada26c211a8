// SPDX-License-Identifier: GPL-3.0-or-later
// A hash of everything that is drawn: whether a scene is the same as before.
#pragma once

#include <cstdint>

#include <fovea/base/view.h>
#include <fovea/draw/overrides.h>
#include <fovea/scene/scene.h>

namespace fovea::draw {

/// Hash of what the lines of a frame depend on, beside its style, options and backend.
std::uint64_t content_of(const Scene& scene, const View& view, const Overrides& overrides);

}  // namespace fovea::draw
