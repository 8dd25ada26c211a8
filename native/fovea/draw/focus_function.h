// SPDX-License-Identifier: GPL-3.0-or-later
// A style's places to look at, as one view of a scene has them.
#pragma once

#include <fovea/focus/focus.h>
#include <fovea/style/style.h>

namespace fovea {

/// `objects`: per placement of the scene the names that it is known by. Of an object that shows nothing, its place
/// counts. `scene` may be null where places lie in the image or the scene.
Focus focus_function(const style::Focus& focus, const Scene* scene, const View& view,
                     const std::vector<std::vector<std::string>>& objects);

}  // namespace fovea
