// SPDX-License-Identifier: GPL-3.0-or-later
// Image edge: where the tone of the shaded scene changes fastest. Canny, "A Computational Approach to Edge Detection",
// PAMI 1986; Cole 2009, section 3.2.2.
// In   the shaded scene, smoothed
// Out  zeros of the second derivative along the gradient at maxima of the slope, with hysteresis, to sub-pixel accuracy
#include <numbers>

#include <fovea/line/image_curves.h>

namespace fovea::line {
namespace {

const auto image_edge_parameters =
    image_parameters<ImageValues>(0.3, "Contrast of a sharp edge from which lines are drawn", 2.0);

/// Tone of the background: brighter than white, so that the outline of white surfaces has full contrast, too.
constexpr double beyond_white = 2.0;

struct Node {
    vec2 gradient;
    float growth;    // growth_of_slope: relative change of the gradient's length along the gradient
    float contrast;  // height of the step edge that has this slope after smoothing
};

Curves find_image_edge(const FrameView& frame, const ImageValues& values) {
    const auto tone = smooth_tone(frame, values, beyond_white);
    const auto per_slope = static_cast<float>(std::sqrt(2.0 * std::numbers::pi) * steps_per_sigma);
    const Array<Node> nodes = per_node<Node>(tone->lattice(), [&](int x, int y) {
        const LocalFit fit = fit_at(tone->value, tone->lattice(), x, y);
        return Node{fit.gradient, fit.growth_of_slope(), per_slope * glm::length(fit.gradient)};
    });
    // At a maximum of the slope its growth changes from positive to negative.
    const auto greatest = [&](const LatticeTriangle& triangle) {
        const Node &a = nodes[triangle.node[0]], &b = nodes[triangle.node[1]], &c = nodes[triangle.node[2]];
        return glm::dot(triangle.slope(a.growth, b.growth, c.growth), a.gradient + b.gradient + c.gradient) < 0.0f;
    };
    const auto contrast = [&](Index i) { return nodes[i].contrast; };
    return trace_in_image(frame, *tone, values, contrast, greatest, [&](Index, Index i) { return nodes[i].growth; });
}

}  // namespace

extern const LineDefinition image_edge = {
    .name = "image_edge",
    .label = "Image Edge",
    .source = "Canny 1986; Cole 2009, section 3.2.2",
    .description = "Where the tone of the shaded scene changes fastest",
    .scope = Scope::scene,
    .importance = 0.25,
    .parameters = image_edge_parameters,
    .rule = ImageRule{image_edge_parameters.of(find_image_edge)},
    .slow = true,
};

}  // namespace fovea::line
