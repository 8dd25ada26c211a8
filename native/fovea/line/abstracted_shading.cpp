// SPDX-License-Identifier: GPL-3.0-or-later
// Abstracted shading: thin dark areas of the shaded scene as dark lines, thin light ones as light lines. Lee,
// Markosian, Lee & Hughes, "Line Drawings via Abstracted Shading", SIGGRAPH 2007.
// In   the shaded scene, smoothed
// Out  valleys (and ridges) of the tone: minima (maxima) along the principal direction of greatest curvature; strength
//      from that curvature
#include <fovea/line/image_curves.h>

namespace fovea::line {
namespace {

struct AbstractedShading : ImageValues {
    bool valleys, ridges;
};

const auto abstracted_shading_parameters =
    image_parameters<AbstractedShading>(0.05, "How far the tone rises beside a line from which lines are drawn", 4.0)
        .with({{&AbstractedShading::valleys, "valleys", "Valleys", true, "Lines along thin dark areas"},
               {&AbstractedShading::ridges, "ridges", "Ridges", false, "Lines along thin light areas"}});

constexpr double white = 1.0;  // tone of the background, before which the outline of a round shape is a thin dark area

/// The curvature times sigma squared: at a distance of sigma the tone is half of this above a valley.
Curves trace(const FrameView& frame, const SmoothTone& tone, const ImageValues& values, float sign) {
    const auto depth = [](Index, const Bend& bend) {
        return bend.curvature * float(steps_per_sigma * steps_per_sigma);
    };
    return trace_bends(frame, tone, values, sign, depth);
}

Curves find_abstracted_shading(const FrameView& frame, const AbstractedShading& values) {
    const auto tone = smooth_tone(frame, values, white);
    Curves curves;
    if (values.valleys) curves = trace(frame, *tone, values, 1.0f);
    if (!values.ridges) return curves;
    for (CurvePiece piece : trace(frame, *tone, values, -1.0f)) {
        piece.level = 1;
        curves.push_back(piece);
    }
    return curves;
}

}  // namespace

extern const LineDefinition abstracted_shading = {
    .name = "abstracted_shading",
    .label = "Abstracted Shading",
    .source = "Lee, Markosian, Lee & Hughes 2007",
    .description = "Thin dark areas of the shaded scene, and thin light ones, as lines",
    .scope = Scope::scene,
    .importance = 0.25,
    .parameters = abstracted_shading_parameters,
    .rule = ImageRule{abstracted_shading_parameters.of(find_abstracted_shading)},
    .slow = true,
};

}  // namespace fovea::line
