// SPDX-License-Identifier: GPL-3.0-or-later
// A depth buffer with what it shows.
#pragma once

#include <memory>

#include <fovea/visibility/depth.h>

namespace fovea::bindings {

struct SceneDepth {
    std::shared_ptr<Scene> scene;
    View view;
    DepthBuffer buffer;
};

}  // namespace fovea::bindings
