// A depth buffer with what it shows.
#pragma once

#include <memory>

#include "atlas/depth.h"

namespace fovea::bindings {

struct SceneDepth {
    std::shared_ptr<Scene> scene;
    View view;
    DepthBuffer buffer;
};

}  // namespace fovea::bindings
