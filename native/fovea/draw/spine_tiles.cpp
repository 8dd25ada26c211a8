// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/draw/spine_tiles.h>

#include <algorithm>
#include <cmath>

#include <fovea/draw/methods.h>
#include <fovea/visibility/depth.h>

namespace fovea::draw {
namespace {

/// Upper bound of the distance [px] between a stroke's spine and its fragments.
int reach_px(const Strokes& strokes) {
    const auto widest = std::ranges::max_element(strokes.half_width);
    return widest == strokes.half_width.end() ? 0 : static_cast<int>(std::ceil(2.0f * *widest));
}

}  // namespace

void each_depth_tile(const Frame& frame, int most_side, int overlap_px,
                     const std::function<void(const DepthBuffer&)>& look) {
    const std::vector<RasterMesh> meshes = depth_meshes(*frame.job.scene, frame.job.view, DepthOptions().margin);
    for (DepthBuffer& layout : frame.depth_layouts(most_side, overlap_px))
        look(draw_depth(std::move(layout), frame.job.view, meshes, &frame.cancel()));
}

void each_spine_tile(const Frame& frame, int most_side, const std::function<void(const SpineTest*)>& draw) {
    if (!method_of(frame.job.options.visibility).in_strokes) return draw(nullptr);
    const OwnSides sides = own_sides(*frame.clipped, *frame.job.scene, frame.job.view);
    each_depth_tile(frame, most_side, reach_px(*frame.strokes), [&](const DepthBuffer& depth) {
        const SpineTest spine(*frame.clipped, sides, depth, {.probes = frame.job.options.probes});
        draw(&spine);
    });
}

}  // namespace fovea::draw
