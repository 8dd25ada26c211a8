// SPDX-License-Identifier: GPL-3.0-or-later
// What pens take from surfaces (style::Pen::paint_width and others), along the paths of a picture.
#pragma once

#include <array>
#include <map>
#include <utility>
#include <vector>

#include <fovea/draw/overrides.h>
#include <fovea/path/paths.h>
#include <fovea/stroke/pen.h>

namespace fovea::draw {

/// Of what a value of this paint is.
PaintedOn painted_on(const style::Paint& paint);

/// Owns the values; what is the same for several pens is there once.
class PenPaints {
   public:
    PenPaints() = default;
    PenPaints(const std::vector<Pen>& pens, const Paths& paths, const Scene& scene, const Overrides& overrides);

    /// One per pen; empty: no pen takes anything.
    In<PenPaint> of_pens() const { return of_pens_; }

   private:
    using Color = std::array<double, 3>;  // of a pen, where nothing is painted

    std::map<style::Paint, Array<float>> numbers_;
    std::map<std::pair<style::Paint, Color>, Array<vec3>> colors_;
    std::vector<PenPaint> of_pens_;
};

}  // namespace fovea::draw
