// SPDX-License-Identifier: GPL-3.0-or-later
// Image edge: where the tone of the shaded scene changes fastest.
// Canny, "A Computational Approach to Edge Detection", PAMI 1986; Cole 2009, section 3.2.2.
// In   the scene lit by a lamp, smoothed
// Out  zeros of the second derivative along the gradient where the slope is greatest, with hysteresis, to sub-pixels
#include <numbers>

#include <fovea/line/image_curves.h>

namespace fovea {
namespace {

const auto parameters = image_parameters<ImageValues>(0.3, "Contrast of a sharp edge from which lines are drawn", 2.0);

/// Of the background: the outline has all contrast that a threshold may ask for, also where the surface is white.
constexpr double beyond_white = 2.0;

struct Node {
    vec2 gradient;
    float growth;    // of the slope, along the gradient
    float contrast;  // of the step edge that has this slope
};

Array<Node> look(const SmoothTone& tone) {
    const Lattice& lattice = tone.lattice();
    const auto per_slope = static_cast<float>(std::sqrt(2.0 * std::numbers::pi) * steps_per_sigma);
    return per_node<Node>(lattice, [&](int x, int y) {
        const LocalFit fit = fit_at(tone.value, lattice, x, y);
        return Node{fit.gradient, fit.growth_of_slope(), per_slope * glm::length(fit.gradient)};
    });
}

Curves find(const FrameView& frame, const ImageValues& values) {
    const auto tone = smooth_tone(frame, values, beyond_white);
    const Lattice& lattice = tone->lattice();
    const Array<Node> nodes = look(*tone);
    const auto low = static_cast<float>(values.low_threshold());
    const auto emit = [&](const LatticeTriangle& triangle, std::vector<CurvePiece>& out) {
        const Node* n[3] = {&nodes[triangle.node[0]], &nodes[triangle.node[1]], &nodes[triangle.node[2]]};
        if (!(n[0]->contrast > low || n[1]->contrast > low || n[2]->contrast > low)) return;
        const vec2 change = triangle.slope(n[0]->growth, n[1]->growth, n[2]->growth);
        // Up to the greatest slope the tone bends upwards, then downwards.
        if (!(glm::dot(change, n[0]->gradient + n[1]->gradient + n[2]->gradient) < 0.0f)) return;
        ZeroCrossing ends[2];
        int count = 0;
        for (const Index number : triangle.side) {
            const LatticeSide side = lattice_side(lattice, number);
            const float a = nodes[side.a].growth, b = nodes[side.b].growth;
            if ((a >= 0.0f) == (b >= 0.0f)) continue;
            const float t = zero_on_side(nodes[side.before].growth, a, b, nodes[side.after].growth);
            ends[count++] = {number, side.a, side.b, t};
        }
        if (count == 2)
            append_in_lattice(lattice, triangle, ends, [&](Index i) { return nodes[i].contrast; }, values, out);
    };
    return lift(frame, *tone->shaded, collect_in_lattice(lattice, emit));
}

}  // namespace

extern const LineDefinition image_edge;
const LineDefinition image_edge = {
    .name = "image_edge",
    .label = "Image Edge",
    .source = "Canny 1986; Cole 2009, section 3.2.2",
    .description = "Where the tone of the shaded scene changes fastest",
    .scope = Scope::scene,
    .importance = 0.25,
    .parameters = parameters,
    .rule = ImageRule{parameters.of(find)},
    .slow = true,
};

}  // namespace fovea
