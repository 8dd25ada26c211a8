// SPDX-License-Identifier: GPL-3.0-or-later
// Marks as paths: their curves, their looks, and what lines they are.
#pragma once

#include <fovea/vector/document.h>
#include <fovea/vector/marks.h>
#include <fovea/vector/options.h>

namespace fovea::vector {

/// Makes paths of a frame's marks. Borrows all that it is given.
class Tracing {
   public:
    Tracing(const Frame& frame, const Options& options, const Page& page, const std::vector<Grain>& grains);

    /// A mark as a path, without its id: a line where its width is about the same all along, it has dashes or lines are
    /// asked for, else an outline.
    Path path_of(const Mark& mark) const;
    /// What its line is, without a look and curves.
    Path owner_of(const Mark& mark) const;
    /// The dashes of a mark, each a mark; itself if it has none, or so short ones that they are one line. Those that
    /// are fixed to paths divide where the line grows, as in the picture (stroke/octaves.h).
    std::vector<Mark> dashes_of(const Mark& mark) const;

    double tolerance() const { return tolerance_; }  ///< in units of the page

   private:
    Look dashed(const Mark& mark) const;
    std::vector<dvec2> divided(const Mark& mark, const Look& look) const;
    static std::vector<dvec2> repeated(const Look& look, double length);
    const Pen& pen_of(const Mark& mark) const { return inking_.pens[inking_.pen_of_run[mark.run]]; }
    const Grain& grain_of(const Mark& mark) const { return grains_[inking_.pen_of_run[mark.run]]; }

    const Frame& frame_;
    const Inking inking_;
    const Options& options_;
    const std::vector<Grain>& grains_;
    double tolerance_, least_pattern_, scale_;
};

}  // namespace fovea::vector
