// SPDX-License-Identifier: GPL-3.0-or-later
// Shared by image-space definitions: the shaded image, and the projection of lattice curves back into the scene.
#pragma once

#include <fovea/image/lattice_triangles.h>
#include <fovea/image/local_fit.h>
#include <fovea/image/shaded_buffer.h>
#include <fovea/line/definition.h>
#include <fovea/line/zero_set.h>

namespace fovea::line {

/// Lattice steps per sigma; constant, so that accuracy and filters are the same at every scale.
inline constexpr double steps_per_sigma = 2.0;

/// Parameters common to all image-space definitions; they come first.
struct ImageValues {
    double threshold;
    double low;    ///< share of `threshold`
    double sigma;  ///< reference pixels
    bool outline;
    double light_right, light_up;  ///< degrees

    double low_threshold() const { return threshold * low; }
    Lamp lamp() const { return {light_right, light_up}; }
};

/// Parameters of P, which derives from ImageValues. `meaning`: description of the threshold.
template <typename P>
Parameters<P> image_parameters(double threshold, const char* meaning, double sigma) {
    return {{&P::threshold, "threshold", "Threshold", threshold, 0.0, 1.0, Unit::none, meaning},
            {&P::low, "low", "Low", 0.4, 0.0, 1.0, Unit::none,
             "Share of the threshold down to which a line goes on, fading"},
            {&P::sigma, "sigma", "Smoothing", sigma, 1.0, 50.0, Unit::pixels,
             "Width of the smoothing, in pixels of a picture 1080 high"},
            {&P::outline, "outline", "Outline", true, "Also lines of the outline, against a light background"},
            {&P::light_right, "light_right", "Light Right", 0.0, -180.0, 180.0, Unit::degrees,
             "Direction of the light, to the right"},
            {&P::light_up, "light_up", "Light Up", 0.0, -90.0, 90.0, Unit::degrees,
             "Direction of the light, upwards from the viewer"}};
}

/// The scene, shaded on a lattice with steps_per_sigma steps to the smoothing's sigma; shared by definitions.
std::shared_ptr<const ShadedBuffer> shaded_scene(const FrameView& frame, const ImageValues& values);

/// The shaded scene after Gaussian smoothing. With `outline`, uncovered parts have the background's tone; else they
/// have weight zero (normalized convolution: Knutsson & Westin, CVPR 1993), and the value is NaN where the weighted
/// coverage is 1 % or less.
struct SmoothTone {
    std::shared_ptr<const ShadedBuffer> shaded;
    Buffer value;
    const Lattice& lattice() const { return shaded->lattice; }
};
std::shared_ptr<const SmoothTone> smooth_tone(const FrameView& frame, const ImageValues& values, double background);

/// Width, in nodes, of the lattice's border in which derivatives are not defined.
inline constexpr int lattice_border = fit_reach;

/// Evaluates make(x, y) at all nodes but those of the border, which get a default Node.
template <typename Node, typename Make>
Array<Node> per_node(const Lattice& lattice, const Make& make) {
    Array<Node> nodes(lattice.size());
    parallel_for(lattice.height - 2 * lattice_border, 8, [&](std::size_t row) {
        const int y = int(row) + lattice_border;
        for (int x = lattice_border; x < lattice.width - lattice_border; ++x) nodes[lattice.at(x, y)] = make(x, y);
    });
    return nodes;
}

/// Calls emit(triangle, out) for the lattice triangles whose sides' neighbors (lattice_side) are inside the border.
template <typename Emit>
Curves collect_in_lattice(const Lattice& lattice, const Emit& emit) {
    return collect_pieces(2 * lattice.size(), [&](Index number, Array<CurvePiece>& out) {
        const int node = int(number / 2), x = node % lattice.width, y = node / lattice.width;
        const int last_x = lattice.width - lattice_border - 2, last_y = lattice.height - lattice_border - 2;
        const bool inside = x > lattice_border && y > lattice_border && x < last_x && y < last_y;
        if (inside) emit(lattice_triangle(lattice, x, y, number % 2), out);
    });
}

/// Keeps connected curves (pieces that share sides) whose strength reaches 1 somewhere and whose length is at least
/// `least`, in the units of their points. Canny, "A Computational Approach to Edge Detection", PAMI 1986, section VI.
Curves keep_strong(const Curves& pieces, double least);

/// Projects lattice curves to view space. Keeps those that pass hysteresis and are at least five sigma long; each point
/// gets the depth of the nearest surface that is sampled around it, and pieces where that surface is not drawn are
/// dropped.
Curves lift(const FrameView& frame, const ShadedBuffer& shaded, const Curves& pieces);

/// Traces lines where `value` is zero and `measure` (per node) exceeds the low threshold; strength is 0 at the low
/// threshold and 1 at the high one. value(first, node): value at `node`, for a side whose first node is `first` (which
/// may fix a sign). Only triangles with a node above the low threshold and with wanted(triangle) are visited.
template <typename Measure, typename Wanted, typename Value>
Curves trace_in_image(const FrameView& frame, const SmoothTone& tone, const ImageValues& values, const Measure& measure,
                      const Wanted& wanted, const Value& value) {
    const Lattice& lattice = tone.lattice();
    const auto low = static_cast<float>(values.low_threshold()),
               range = static_cast<float>(values.threshold - values.low_threshold());
    const auto place = [&](Index node) { return vec3(lattice_place(lattice, node), 0.0f); };
    const auto margin = [&](Index node) { return measure(node) - low; };
    const auto strength = [&](float above) { return above >= range ? 1.0f : std::max(above, 0.0f) / range; };
    const auto emit = [&](const LatticeTriangle& triangle, Array<CurvePiece>& out) {
        const auto is_strong = [&](Index node) { return measure(node) > low; };
        if (std::none_of(triangle.node, triangle.node + 3, is_strong) || !wanted(triangle)) return;
        ZeroCrossing ends[3];
        int count = 0;
        for (const Index number : triangle.side) {
            const LatticeSide side = lattice_side(lattice, number);
            const auto at = [&](Index node) { return value(side.a, node); };
            const float a = at(side.a), b = at(side.b);
            if ((a >= 0.0f) == (b >= 0.0f)) continue;
            ends[count++] = {number, side.a, side.b, zero_on_side(at(side.before), a, b, at(side.after))};
        }
        if (count == 2) append_trimmed(place, triangle.number, {ends[0], ends[1]}, margin, strength, out);
    };
    return lift(frame, *tone.shaded, collect_in_lattice(lattice, emit));
}

/// Traces valleys (sign 1) or ridges (-1) of the value: minima or maxima along the direction of greatest curvature.
/// measure(node, bend): what is compared with the thresholds.
template <typename Measure>
Curves trace_bends(const FrameView& frame, const SmoothTone& tone, const ImageValues& values, float sign,
                   const Measure& measure) {
    struct Node {
        vec2 direction;  // principal direction of the value
        float slope;     // derivative along it
        float measure;
    };
    // Triangles in which the principal direction turns by more than about 45 degrees have no line.
    constexpr float least_cosine = 0.7f;
    const Array<Node> nodes = per_node<Node>(tone.lattice(), [&](int x, int y) {
        const LocalFit fit = fit_at(tone.value, tone.lattice(), x, y);
        const Bend bend = greatest_bend(fit, sign);
        return Node{bend.direction, sign * glm::dot(fit.gradient, bend.direction),
                    measure(Index(tone.lattice().at(x, y)), bend)};
    });
    const auto cosine = [&](Index a, Index b) { return glm::dot(nodes[a].direction, nodes[b].direction); };
    const auto agree = [&](const LatticeTriangle& triangle) {
        const auto& n = triangle.node;
        return std::abs(cosine(n[0], n[1])) > least_cosine && std::abs(cosine(n[1], n[2])) > least_cosine &&
               std::abs(cosine(n[2], n[0])) > least_cosine;
    };
    const auto of_node = [&](Index i) { return nodes[i].measure; };
    // Directions have no sign: flip the others to agree with that of the first node.
    const auto slope = [&](Index first, Index i) { return cosine(first, i) < 0.0f ? -nodes[i].slope : nodes[i].slope; };
    return trace_in_image(frame, tone, values, of_node, agree, slope);
}

}  // namespace fovea::line
