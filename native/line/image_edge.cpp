// Image edge: where the tone of the shaded scene changes fastest.
// Canny, "A Computational Approach to Edge Detection", PAMI 1986; Cole 2009, section 3.2.2.
// In   the scene lit by a lamp, smoothed
// Out  zeros of the second derivative along the gradient where the slope is greatest, with hysteresis, to sub-pixels
#include <numbers>

#include "image/local_fit.h"
#include "line/image_curves.h"

namespace fovea {
namespace {

struct Node {
    vec2 gradient;
    float along;     // second derivative along the gradient
    float contrast;  // of the step edge that has this slope
};

Array<Node> look(const SmoothTone& tone) {
    const Lattice& lattice = tone.lattice();
    // The greatest slope of a unit step under all filters: the Gaussian, the node's own square and the difference.
    const double sigma = std::sqrt(steps_per_sigma * steps_per_sigma + 1.0 / 12.0 + 1.0 / 3.0);
    const auto per_slope = static_cast<float>(std::sqrt(2.0 * std::numbers::pi) * sigma);
    Array<Node> nodes(lattice.size());
    parallel_for(lattice.height - 2, [&](std::size_t row) {
        for (int y = int(row) + 1, x = 1; x + 1 < lattice.width; ++x) {
            const LocalFit fit = fit_at(tone.value, lattice, x, y);
            nodes[lattice.at(x, y)] = {fit.gradient, fit.along_gradient(), per_slope * glm::length(fit.gradient)};
        }
    }, 8);
    return nodes;
}

Curves find(const FrameView& frame, const Values& given) {
    const ImageValues values(given);
    const auto tone = smooth_tone(frame, values);
    const Lattice& lattice = tone->lattice();
    const Array<Node> nodes = look(*tone);
    const auto low = static_cast<float>(values.low);
    const auto emit = [&](const LatticeTriangle& triangle, std::vector<CurvePiece>& out) {
        const Node* n[3] = {&nodes[triangle.node[0]], &nodes[triangle.node[1]], &nodes[triangle.node[2]]};
        if (!(n[0]->contrast > low || n[1]->contrast > low || n[2]->contrast > low)) return;
        const vec2 change = triangle.slope(n[0]->along, n[1]->along, n[2]->along);
        // Up to the greatest slope the tone bends upwards, then downwards.
        if (!(glm::dot(change, n[0]->gradient + n[1]->gradient + n[2]->gradient) < 0.0f)) return;
        Crossing ends[2];
        int count = 0;
        for (const Index number : triangle.side) {
            const LatticeSide side = lattice_side(lattice, number);
            const float a = nodes[side.a].along, b = nodes[side.b].along;
            if ((a >= 0.0f) != (b >= 0.0f)) ends[count++] = {number, side.a, side.b, a / (a - b)};
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
    .parameters = image_parameters(0.2, "Contrast of a sharp edge from which lines are drawn", 2.0),
    .on_by_default = false,
    .find_in_image = find,
};

}  // namespace fovea
