// SPDX-License-Identifier: GPL-3.0-or-later
// The reference backend.
#include <fovea/base/check.h>
#include <fovea/draw/frame.h>
#include <fovea/draw/methods.h>
#include <fovea/draw/spine_tiles.h>
#include <fovea/elision/elide.h>
#include <fovea/stroke/raster.h>

namespace fovea::draw {
namespace {

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
    each_depth_tile(frame, most_side, 0, [&](const DepthBuffer& depth) { add(sum, method.look(frame, depth)); });
    return sum;
}

Array<vec2> CpuBackend::elide(const Frame& frame, const Elision& elision) {
    const View& view = frame.job.view;
    return crowding(elision, draw_priorities(elision, view.width, view.height, &frame.cancel()), &frame.cancel());
}

Array<vec4> CpuBackend::draw(const Frame& frame) {
    const View& view = frame.job.view;
    Array<vec4> image;
    each_spine_tile(frame, most_side, [&](const SpineTest* spine) {
        Array<vec4> part =
            rasterize(*frame.strokes, frame.pens.pens, frame.pens.textures, view.width, view.height, spine);
        if (image.empty())
            image = std::move(part);
        else
            add(image, part);
    });
    return image;
}

}  // namespace fovea::draw
