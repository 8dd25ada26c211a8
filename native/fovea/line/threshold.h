// SPDX-License-Identifier: GPL-3.0-or-later
// Shared by definitions with a threshold and a low threshold: lines that reach the first continue, fading, to the
// second.
#pragma once

#include <fovea/field/fields.h>
#include <fovea/line/definition.h>

namespace fovea::line {

struct ThresholdValues {
    double threshold;
    double low;     ///< share of `threshold`
    double length;  ///< in units of the feature size
};

/// Parameters of P, which derives from ThresholdValues. `meaning`: what is measured, and its unit.
template <typename P>
Parameters<P> threshold_parameters(double threshold, double low, double length, const char* meaning) {
    return {{&P::threshold, "threshold", "Threshold", threshold, 0.0, 100.0, Unit::none, meaning},
            {&P::low, "low", "Low Threshold", low, 0.0, 1.0, Unit::none,
             "Share of the threshold above which a line goes on that reaches the threshold somewhere"},
            {&P::length, "length", "Length", length, 0.0, 1000.0, Unit::none,
             "Least length of a line as strong as the threshold, in sizes of the features; "
             "a stronger one may be shorter"}};
}

/// Threshold, low threshold, and the excess over the low one at which strength is 0.5; all in the measure's unit.
struct Thresholds {
    float high, low, fade;

    /// `power`: the measure is in units of 1 / feature size (1), or of its square (2).
    Thresholds(const Surface& surface, const ThresholdValues& values, int power) {
        const double size = fields_of(surface)->feature_size, unit = 1.0 / (power == 2 ? size * size : size);
        high = static_cast<float>(values.threshold * unit);
        low = static_cast<float>(values.threshold * values.low * unit);
        fade = 0.5f * high;
    }

    /// Strength in [0, 1) for an excess `above` over the low threshold; the `strength` of trace_zero_set and
    /// trace_maxima.
    float operator()(float above) const { return above > 0.0f ? above / (above + fade) : 0.0f; }
};

/// Rule of a feature definition with a threshold; find(surface view, values, more...) finds its pieces. `power`: as in
/// Thresholds.
template <typename P, typename Find, typename... More>
CurveRule feature_rule(const Parameters<P>& parameters, int power, Find find, More... more) {
    const auto found = [=](const SurfaceView& seen, const P& values) { return find(seen, values, more...); };
    const auto select = [power](const Surface& surface, const ThresholdValues& values) -> Selection {
        const Thresholds t(surface, values, power);
        const float reach = t.high > t.low ? t(t.high - t.low) : 0.0f;
        return {.reach = reach, .least = values.length * fields_of(surface)->feature_size};
    };
    return {CurveType::feature, parameters.of(found), parameters.of(select)};
}

}  // namespace fovea::line
