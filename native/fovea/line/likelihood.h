// SPDX-License-Identifier: GPL-3.0-or-later
// What has been learned of where lines are drawn, as far as drawing has to know of it.
#pragma once

#include <fovea/image/shaded_buffer.h>
#include <fovea/line/parameter.h>

namespace fovea::line {

struct Likelihood : FileContent {
    /// From which on there are lines, in [0, 1].
    virtual double threshold() const = 0;

    /// How likely a line is, in [0, 1], at the nodes of the lattice of the tracer's scene, shaded by a lamp at the eye;
    /// 0 where no surface is near, and at the lattice's border.
    virtual Buffer at(const Tracer& tracer, const ShadedBuffer& shaded, const Cancel& cancel) const = 0;
};

}  // namespace fovea::line
