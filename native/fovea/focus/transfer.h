// SPDX-License-Identifier: GPL-3.0-or-later
// Transfer functions: how strongly an effect answers to focus.
#pragma once

#include <array>

#include <fovea/base/types.h>

namespace fovea::focus {

/// From a normalized value (focus; distance from the camera) in [0,1] to a mix in [0,1] (Cole 2009, 5.3.2): 0 up to
/// `start`, `strength` from `end` on, in between along the response curve. `start` beyond `end` turns it round; where
/// they are equal, it is a step there. Backends and the panel all take their numbers from here.
class Transfer {
   public:
    /// The identity.
    Transfer() : Transfer(0.0f, 1.0f, 1.0f, {}) {}

    /// `curve`: points (x, y) of the response, x ascending, all in [0,1], joined by a monotone cubic (Fritsch & Carlson
    /// 1980), held beyond the first and the last; none: straight. Throws std::invalid_argument for other points, and
    /// for numbers that are not finite.
    Transfer(float start, float end, float strength, In<vec2> curve);

    /// What is no number counts as 0.
    float operator()(float value) const {
        const float x = position(value) * steps;
        const int k = x < steps ? int(x) : steps - 1;
        return strength_ * (response_[k] + (response_[k + 1] - response_[k]) * (x - float(k)));
    }

   private:
    static constexpr int steps = 64;

    /// Where a value lies between start and end, in [0,1].
    float position(float value) const {
        if (!(value == value)) value = 0.0f;
        if (start_ == end_) return value >= start_ ? 1.0f : 0.0f;
        const float x = (value - start_) / (end_ - start_);
        return x > 0.0f ? (x < 1.0f ? x : 1.0f) : 0.0f;
    }

    float start_, end_, strength_;
    std::array<float, steps + 1> response_;
};

/// What two causes make of one effect, each a mix in [0,1]: neither undoes the other.
inline float both(float a, float b) { return 1.0f - (1.0f - a) * (1.0f - b); }

}  // namespace fovea::focus
