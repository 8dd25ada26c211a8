// SPDX-License-Identifier: GPL-3.0-or-later
// Transfer functions: strength of an effect as a function of focus.
#pragma once

#include <algorithm>
#include <array>

#include <fovea/base/types.h>
#include <fovea/style/transfer.h>

namespace fovea::focus {

/// From a normalized value (focus; distance from the camera) in [0,1] to a mix in [0,1] (Cole 2009, 5.3.2): 0 up to
/// `start`, `strength` from `end` on, in between along the response curve. start > end reverses it; start == end is a
/// step. Backends and the panel all evaluate this class.
class Transfer {
   public:
    /// The identity.
    Transfer() : Transfer(0.0f, 1.0f, 1.0f, {}) {}

    /// `curve`: points (x, y) of the response, x ascending, all in [0,1], interpolated as in monotone_cubic.h;
    /// empty: linear. Throws std::invalid_argument for other points, and for non-finite numbers. `factor`: by which
    /// mixes are multiplied, up to 1.
    Transfer(float start, float end, float strength, In<vec2> curve, float factor = 1.0f);

    /// NaN counts as 0.
    float operator()(float value) const {
        const float x = position(value) * steps;
        const int k = x < steps ? int(x) : steps - 1;
        return std::min(1.0f, strength_ * (response_[k] + (response_[k + 1] - response_[k]) * (x - float(k))));
    }

   private:
    static constexpr int steps = 64;

    /// Position of a value between start and end, in [0,1].
    float position(float value) const {
        if (!(value == value)) value = 0.0f;
        if (start_ == end_) return value >= start_ ? 1.0f : 0.0f;
        const float x = (value - start_) / (end_ - start_);
        return x > 0.0f ? (x < 1.0f ? x : 1.0f) : 0.0f;
    }

    float start_, end_, strength_;
    std::array<float, steps + 1> response_;
};

/// Builds the transfer function from its settings. `emphasis`: of all effects of focus (style::Effects).
Transfer transfer_of(const style::Transfer& transfer, double emphasis = 1.0);

/// Combines the mixes in [0,1] of two causes of one effect (of several: as vectors); never less than either.
template <typename Mix>
Mix both(Mix a, Mix b) {
    return 1.0f - (1.0f - a) * (1.0f - b);
}

}  // namespace fovea::focus
