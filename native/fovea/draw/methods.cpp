// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/draw/methods.h>

#include <fovea/visibility/exact.h>
#include <fovea/visibility/item_buffer.h>
#include <fovea/visibility/sampled.h>
#include <fovea/visibility/spine.h>

namespace fovea::draw {
namespace {

Runs by_rays(Frame& frame) { return exact_visibility(*frame.clipped, *frame.paths, *frame.tracer, frame.cancel()); }

Runs by_atlas(Frame& frame) {
    frame.samples = frame.job.backend->visibility(frame);
    return runs_from_samples(*frame.clipped, frame.samples);
}

Array<float> look_by_atlas(const Frame& frame, const DepthBuffer& depth) {
    const OwnSides sides = own_sides(*frame.clipped, *frame.job.scene, frame.job.view);
    return sampled_visibility(*frame.clipped, sides, depth, {.probes = frame.job.options.probes}, &frame.cancel());
}

/// Visibility is decided later, in strokes.
Runs all(Frame& frame) { return whole_pieces(*frame.clipped); }

/// Frame::samples stays empty, so that ends of strokes are sharp: where lines share texels, a fraction of successful
/// probes is not partial visibility.
Runs by_items(Frame& frame) { return runs_from_samples(*frame.clipped, frame.job.backend->visibility(frame)); }

Array<float> look_by_items(const Frame& frame, const DepthBuffer& depth) {
    return item_visibility(*frame.clipped, depth, {.layers = frame.job.options.layers}, &frame.cancel());
}

/// Indexed by Visibility.
constexpr Method methods[] = {
    {.words = "exact", .visible = by_rays},
    {.words = "sampled", .visible = by_atlas, .look = look_by_atlas, .quality = &Options::probes, .counted = "samples"},
    {.words = "spine test",
     .visible = all,
     .look = look_by_atlas,
     .quality = &Options::probes,
     .counted = "samples",
     .in_strokes = true},
    {.words = "item buffer",
     .visible = by_items,
     .look = look_by_items,
     .quality = &Options::layers,
     .counted = "layers"},
};
static_assert(std::size(methods) == std::size(style::choices_of<Visibility>));

}  // namespace

const Method& method_of(Visibility visibility) { return methods[static_cast<int>(visibility)]; }

}  // namespace fovea::draw
