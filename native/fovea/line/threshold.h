// SPDX-License-Identifier: GPL-3.0-or-later
// What definitions with a threshold share: lines that reach it somewhere go on below it, fading.
#pragma once

#include <fovea/field/fields.h>
#include <fovea/line/definition.h>

namespace fovea::line {

struct ThresholdValues {
    double threshold;
    double low;     ///< share of the threshold
    double length;  ///< in units of the feature size
};

/// The parameters of P, a ThresholdValues. `meaning` says what is measured, and its unit.
template <typename P>
Parameters<P> threshold_parameters(double threshold, double low, double length, const char* meaning) {
    return {{&P::threshold, "threshold", "Threshold", threshold, 0.0, 100.0, Unit::none, meaning},
            {&P::low, "low", "Low Threshold", low, 0.0, 1.0, Unit::none,
             "Share of the threshold above which a line goes on that reaches the threshold somewhere"},
            {&P::length, "length", "Length", length, 0.0, 1000.0, Unit::none,
             "Least length of a line as strong as the threshold, in units of the feature size; "
             "a stronger one may be shorter"}};
}

/// Threshold, low threshold, and how far above the low one a line has half its strength; all in the measure's own unit.
struct Thresholds {
    float high, low, fade;

    /// Of a measure in units of 1 / feature size or (`power` 2) its square.
    Thresholds(const Surface& surface, const ThresholdValues& values, int power) {
        const double size = fields_of(surface)->feature_size, unit = 1.0 / (power == 2 ? size * size : size);
        high = static_cast<float>(values.threshold * unit);
        low = static_cast<float>(values.threshold * values.low * unit);
        fade = 0.5f * high;
    }

    /// Strength of a line so far above the low threshold, as trace_zero_set and trace_maxima ask for it.
    float operator()(float above) const { return above > 0.0f ? above / (above + fade) : 0.0f; }
};

/// The rule of such a definition, whose lines are features that find(surface view, values, more...) finds. `power`: of
/// the measure, as Thresholds has it.
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
