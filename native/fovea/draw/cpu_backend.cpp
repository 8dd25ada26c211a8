// SPDX-License-Identifier: GPL-3.0-or-later
// The reference backend.
#include <algorithm>
#include <cmath>

#include <fovea/base/check.h>
#include <fovea/draw/frame.h>
#include <fovea/draw/methods.h>
#include <fovea/elision/elide.h>
#include <fovea/stroke/raster.h>
#include <fovea/visibility/depth.h>
#include <fovea/visibility/spine.h>

namespace fovea::draw {
namespace {

/// Calls look(depth buffer) for each tile of a frame's depth buffer; only one tile is in memory at a time.
template <typename Look>
void each_tile(const Frame& frame, int most_side, int overlap_px, const Look& look) {
    const std::vector<RasterMesh> meshes = depth_meshes(*frame.job.scene, frame.job.view, DepthOptions().margin);
    for (DepthBuffer& layout : frame.depth_layouts(most_side, overlap_px))
        look(draw_depth(std::move(layout), frame.job.view, meshes, &frame.cancel()));
}

/// Upper bound of the distance [px] between a stroke's spine and its fragments.
int reach_px(const Strokes& strokes) {
    const auto widest = std::ranges::max_element(strokes.half_width);
    return widest == strokes.half_width.end() ? 0 : static_cast<int>(std::ceil(2.0f * *widest));
}

template <typename T>
void add(Array<T>& sum, const Array<T>& more) {
    if (sum.empty()) sum.assign(more.size(), T(0.0f));
    parallel_for(sum.size(), [&](std::size_t i) { sum[i] += more[i]; });
}

}  // namespace

std::vector<DepthBuffer> Frame::depth_layouts(int most_side, int overlap_px) const {
    const int probes_px = static_cast<int>(std::ceil(8.0 * std::max(1.0, scale())));
    return depth_tiles(job.view, {.scale = job.options.depth_scale}, most_side, probes_px + overlap_px);
}

Array<float> CpuBackend::visibility(const Frame& frame) {
    const Method& method = method_of(frame.job.options.visibility);
    check(method.look != nullptr, "visibility: this method takes no samples");
    Array<float> sum;
    each_tile(frame, most_side, 0, [&](const DepthBuffer& depth) { add(sum, method.look(frame, depth)); });
    return sum;
}

Array<vec2> CpuBackend::elide(const Frame& frame, const Elision& elision) {
    const View& view = frame.job.view;
    return crowding(elision, draw_priorities(elision, view.width, view.height, &frame.cancel()), &frame.cancel());
}

Array<vec4> CpuBackend::draw(const Frame& frame) {
    const View& view = frame.job.view;
    const auto rasterized = [&](const SpineTest* spine) {
        return rasterize(*frame.strokes, frame.pens.pens, frame.pens.textures, view.width, view.height, spine);
    };
    if (!method_of(frame.job.options.visibility).in_strokes) return rasterized(nullptr);
    Array<vec4> image;
    const OwnSides sides = own_sides(*frame.clipped, *frame.job.scene, view);
    each_tile(frame, most_side, reach_px(*frame.strokes), [&](const DepthBuffer& depth) {
        const SpineTest spine(*frame.clipped, sides, depth, {.probes = frame.job.options.probes});
        add(image, rasterized(&spine));
    });
    return image;
}

}  // namespace fovea::draw
