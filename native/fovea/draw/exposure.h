// SPDX-License-Identifier: GPL-3.0-or-later
// The ink of moments while a shutter is open, averaged: motion blur of lines.
#pragma once

#include <map>
#include <string>

#include <fovea/draw/line_passes.h>

namespace fovea::draw {

/// Means of premultiplied pixels over moments, which are frames of one size. Of what all moments agree in, the mean is
/// that to the last bit.
class Exposure {
   public:
    /// Draws the ink of a moment, and its passes of hidden lines and of line sets if it requests them. Takes them out
    /// of the frame. `weight`: above 0.
    void add(Frame& moment, double weight);
    /// Once more the moment that was added last.
    void again(double weight);

    bool empty() const { return weight_ == 0.0; }
    Array<vec4> lines() const { return mean(lines_); }
    /// Replaces the hidden lines and line sets in the passes of a frame.
    void replace(LinePasses& passes) const;

   private:
    /// Of one image: that of the last moment, and the sum of those before by their weights; empty: nothing.
    struct Sum {
        Array<vec4> last;
        Array<dvec4> before;
    };
    void close(Sum& sum) const;
    Array<vec4> mean(const Sum& sum) const;

    double weight_ = 0.0, weight_of_last_ = 0.0;
    std::size_t pixels_ = 0;
    Sum lines_, hidden_;
    std::map<std::string, Sum> line_sets_;  // by name
};

}  // namespace fovea::draw
