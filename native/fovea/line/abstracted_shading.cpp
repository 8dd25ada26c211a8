// SPDX-License-Identifier: GPL-3.0-or-later
// Abstracted shading: thin dark areas of the shaded scene as dark lines, thin light ones as light lines.
// Lee, Markosian, Lee & Hughes, "Line Drawings via Abstracted Shading", SIGGRAPH 2007.
// In   the scene lit by a lamp, smoothed
// Out  valleys (and ridges) of the tone: where it is least (greatest) along the direction in which it bends most; as
//      strong as it bends
#include <fovea/line/image_curves.h>

namespace fovea {
namespace {

struct AbstractedShading : ImageValues {
    bool valleys, ridges;
};

const auto parameters =
    image_parameters<AbstractedShading>(0.05, "How far the tone rises beside a line from which lines are drawn", 4.0)
        .with({{&AbstractedShading::valleys, "valleys", "Valleys", true, "Lines along thin dark areas"},
               {&AbstractedShading::ridges, "ridges", "Ridges", false, "Lines along thin light areas"}});

constexpr double white = 1.0;  // of the background: on it, the outline of a round shape is a thin dark area

struct Node {
    vec2 direction;  // in which the tone bends most
    float slope;     // along it
    float depth;     // curvature times sigma squared: at sigma from a valley the tone is half of this above it
};

Array<Node> look(const SmoothTone& tone, float sign) {
    const Lattice& lattice = tone.lattice();
    return per_node<Node>(lattice, [&](int x, int y) {
        const LocalFit fit = fit_at(tone.value, lattice, x, y);
        const Bend bend = greatest_bend(fit, sign);
        return Node{bend.direction, sign * glm::dot(fit.gradient, bend.direction),
                    bend.curvature * float(steps_per_sigma * steps_per_sigma)};
    });
}

Curves trace(const FrameView& frame, const SmoothTone& tone, const ImageValues& values, float sign) {
    // A curvature tensor turns by no more than this from node to node where it means anything.
    constexpr float least_cosine = 0.7f;
    const Lattice& lattice = tone.lattice();
    const Array<Node> nodes = look(tone, sign);
    const auto low = static_cast<float>(values.low_threshold());
    const auto emit = [&](const LatticeTriangle& triangle, std::vector<CurvePiece>& out) {
        const auto deep = [&](int k) { return nodes[triangle.node[k]].depth > low; };
        if (!deep(0) && !deep(1) && !deep(2)) return;
        ZeroCrossing ends[3];
        int count = 0;
        for (const Index number : triangle.side) {
            const LatticeSide side = lattice_side(lattice, number);
            const Node& a = nodes[side.a];
            // Directions have no sign: those of the others are turned to the first one's.
            const auto slope = [&](Index i) {
                return glm::dot(a.direction, nodes[i].direction) < 0.0f ? -nodes[i].slope : nodes[i].slope;
            };
            if (!(std::abs(glm::dot(a.direction, nodes[side.b].direction)) > least_cosine)) return;
            const float at_b = slope(side.b);
            if ((a.slope >= 0.0f) == (at_b >= 0.0f)) continue;
            const float t = zero_on_side(slope(side.before), a.slope, at_b, slope(side.after));
            ends[count++] = {number, side.a, side.b, t};
        }
        if (count != 2) return;
        append_in_lattice(lattice, triangle, {ends[0], ends[1]}, [&](Index i) { return nodes[i].depth; }, values, out);
    };
    return lift(frame, *tone.shaded, collect_in_lattice(lattice, emit));
}

Curves find(const FrameView& frame, const AbstractedShading& values) {
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

extern const LineDefinition abstracted_shading;
const LineDefinition abstracted_shading = {
    .name = "abstracted_shading",
    .label = "Abstracted Shading",
    .source = "Lee, Markosian, Lee & Hughes 2007",
    .description = "Thin dark areas of the shaded scene, and thin light ones, as lines",
    .scope = Scope::scene,
    .importance = 0.25,
    .parameters = parameters,
    .rule = ImageRule{parameters.of(find)},
    .slow = true,
};

}  // namespace fovea
