// SPDX-License-Identifier: GPL-3.0-or-later
// Learned line: where an artist would draw one, as a model has learned it of drawings. Cole 2009, sections 3.2.4
// and 6.1. In   the shaded scene, and a model's file Out  crests of how likely a line is, smoothed, with hysteresis, to
// sub-pixel accuracy
#include <fovea/image/gaussian.h>
#include <fovea/line/image_curves.h>
#include <fovea/line/likelihood.h>

namespace fovea::line {
namespace {

struct LearnedLine {
    double threshold, low, sigma;
};

const Parameters<LearnedLine> learned_line_parameters = {
    {&LearnedLine::threshold, "threshold", "Threshold", 1.0, 0.1, 4.0, Unit::none,
     "Likelihood from which lines are drawn, as a multiple of the model's own threshold"},
    {&LearnedLine::low, "low", "Low", 0.5, 0.0, 1.0, Unit::none,
     "Share of the threshold down to which a line goes on, fading"},
    // Less would be finer than what a model has learned from, and take memory.
    {&LearnedLine::sigma, "sigma", "Smoothing", 2.5, 2.0, 50.0, Unit::pixels,
     "Width of the smoothing, in pixels of a picture 1080 high"},
};

/// Bend over the smoothing's width, as a share of the likelihood, below which a crest is too flat for a line.
constexpr float least_bend = 0.02f;

Curves find_learned_line(const FrameView& frame, const LearnedLine& values, const Likelihood& likelihood) {
    const ImageValues as_image{.threshold = values.threshold * likelihood.threshold(),
                               .low = values.low,
                               .sigma = values.sigma,
                               .outline = true,
                               .light_right = 0.0,
                               .light_up = 0.0};
    SmoothTone smooth{shaded_scene(frame, as_image), {}};
    const Lattice& lattice = smooth.lattice();
    const Buffer found = likelihood.at(frame.tracer, *smooth.shaded, frame.cancel);
    smooth.value = gaussian(found, lattice.width, lattice.height, steps_per_sigma);
    frame.cancel.poll();
    return trace_bends(frame, smooth, as_image, -1.0f, [&](Index node, const Bend& bend) {
        const float value = smooth.value[node];
        return bend.curvature * float(steps_per_sigma * steps_per_sigma) >= least_bend * value ? value : 0.0f;
    });
}

}  // namespace

extern const LineDefinition learned_line = {
    .name = "learned_line",
    .label = "Learned Line",
    .source = "Cole 2009, sections 3.2.4 and 6.1",
    .description = "Where an artist would draw lines, by a model that has learned it from drawings",
    .scope = Scope::scene,
    .importance = 0.5,
    .parameters = learned_line_parameters,
    .file = FileParameter{"model", "Model", ".json", "The file of the model, as fovea learn writes it"},
    .rule = ImageRule{[](const FrameView& frame, const Values& values) {
        const auto* likelihood = dynamic_cast<const Likelihood*>(values.file.get());
        return likelihood ? find_learned_line(frame, learned_line_parameters.read(values), *likelihood) : Curves();
    }},
    .slow = true,
};

}  // namespace fovea::line
