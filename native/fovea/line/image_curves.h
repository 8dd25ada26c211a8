// SPDX-License-Identifier: GPL-3.0-or-later
// What definitions that look at a picture of the scene share: the picture, and the way from its lattice to the scene.
#pragma once

#include <fovea/image/lattice_triangles.h>
#include <fovea/image/local_fit.h>
#include <fovea/image/shaded_buffer.h>
#include <fovea/line/definition.h>
#include <fovea/line/zero_set.h>

namespace fovea {

/// Lattice steps in a sigma: accuracy is the same at every scale, and so are the filters.
inline constexpr double steps_per_sigma = 2.0;

/// The parameters that come first in all of them.
struct ImageValues {
    double threshold;
    double low;    ///< share of the threshold
    double sigma;  ///< reference pixels
    bool outline;
    double light_right, light_up;  ///< degrees

    double low_threshold() const { return threshold * low; }
    Lamp lamp() const { return {light_right, light_up}; }
};

/// The parameters of P, an ImageValues. `meaning` is that of the threshold.
template <typename P>
Parameters<P> image_parameters(double threshold, const char* meaning, double sigma) {
    return {{&P::threshold, "threshold", "Threshold", threshold, 0.0, 1.0, Unit::none, meaning},
            {&P::low, "low", "Low", 0.4, 0.0, 1.0, Unit::none,
             "Share of the threshold down to which a line goes on, fading"},
            {&P::sigma, "sigma", "Sigma", sigma, 1.0, 50.0, Unit::pixels,
             "Width of the smoothing, in pixels of a picture 1080 high"},
            {&P::outline, "outline", "Outline", true, "Also lines of the outline, against a light background"},
            {&P::light_right, "light_right", "Light Right", 0.0, -180.0, 180.0, Unit::degrees,
             "Direction of the light, to the right"},
            {&P::light_up, "light_up", "Light Up", 0.0, -90.0, 90.0, Unit::degrees,
             "Direction of the light, upwards from the viewer"}};
}

/// The shaded scene under a Gaussian. With `outline` it stands on a background of the given tone; else what lies beyond
/// its outline takes no part (normalized convolution: Knutsson & Westin, CVPR 1993), and where nothing lies within
/// reach it is NaN.
struct SmoothTone {
    std::shared_ptr<const ShadedBuffer> shaded;
    Buffer value;
    const Lattice& lattice() const { return shaded->lattice; }
};
std::shared_ptr<const SmoothTone> smooth_tone(const FrameView& frame, const ImageValues& values, double background);

/// Nodes near the border of the lattice, where nothing is known.
inline constexpr int lattice_border = fit_reach;

/// make(x, y) for all other nodes.
template <typename Node, typename Make>
Array<Node> per_node(const Lattice& lattice, const Make& make) {
    Array<Node> nodes(lattice.size());
    parallel_for(
        lattice.height - 2 * lattice_border,
        [&](std::size_t row) {
            const int y = int(row) + lattice_border;
            for (int x = lattice_border; x < lattice.width - lattice_border; ++x) nodes[lattice.at(x, y)] = make(x, y);
        },
        8);
    return nodes;
}

/// emit(triangle, out) for all triangles of the lattice whose sides go on inside its border.
template <typename Emit>
Curves collect_in_lattice(const Lattice& lattice, const Emit& emit) {
    return collect_pieces(2 * lattice.size(), [&](Index number, std::vector<CurvePiece>& out) {
        const int node = int(number / 2), x = node % lattice.width, y = node / lattice.width;
        const int last_x = lattice.width - lattice_border - 2, last_y = lattice.height - lattice_border - 2;
        const bool inside = x > lattice_border && y > lattice_border && x < last_x && y < last_y;
        if (inside) emit(lattice_triangle(lattice, x, y, number % 2), out);
    });
}

/// Appends the part of a piece where `measure` (per node) exceeds the low threshold: strength 0 there, 1 at the high
/// one.
template <typename Measure>
void append_in_lattice(const Lattice& lattice, const LatticeTriangle& triangle, const ZeroCrossing (&ends)[2],
                       const Measure& measure, const ImageValues& values, std::vector<CurvePiece>& out) {
    const auto low = static_cast<float>(values.low_threshold()),
               range = static_cast<float>(values.threshold - values.low_threshold());
    const auto place = [&](Index node) { return vec3(lattice_place(lattice, node), 0.0f); };
    const auto strength = [&](float above) { return above >= range ? 1.0f : std::max(above, 0.0f) / range; };
    append_trimmed(place, triangle.number, ends, [&](std::uint32_t v) { return measure(v) - low; }, strength, out);
}

/// From pieces on the lattice to lines of the scene: those of curves that pass hysteresis and are no shorter than five
/// sigma, in view space, at the depth of the nearest surface that is seen beside them.
Curves lift(const FrameView& frame, const ShadedBuffer& shaded, const Curves& pieces);

}  // namespace fovea
