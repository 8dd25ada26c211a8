// SPDX-License-Identifier: GPL-3.0-or-later
// Tone of surfaces: how bright the lights of the scene make them, with the shadows that they cast.
#pragma once

#include <memory>
#include <vector>

#include <fovea/line/definition.h>
#include <fovea/scene/shade.h>

namespace fovea::line {

/// 1 where a surface faces the light of a typical place head on (scene/irradiance.h), 0 where none reaches it. Without
/// any effective light there is one at the eye, without shadows.
class Tone {
   public:
    /// Lights are those that cast shadows, at most `lights`, the strongest amid the scene first. The tracer must
    /// outlive it.
    Tone(const Tracer& tracer, int lights, bool shadows);

    /// Lights that reach a place, as bits.
    using Lit = std::uint64_t;
    static constexpr Lit all = ~Lit(0);

    /// Both in view space; `normal`: of unit length, facing the viewer.
    double at(const dvec3& point, const dvec3& normal, Lit lit = all) const;
    /// By rays from a triangle of a surface. `point`: in view space.
    Lit lit_at(const ShadedSurface& surface, Index triangle, const dvec3& point) const;
    /// Whether rays decide which lights reach a place; else all do.
    bool has_shadows() const { return shades_ != nullptr; }

   private:
    const View& view_;
    dmat4 to_world_;
    std::vector<Light> lights_;  // in view space; of unit irradiance at a typical place
    std::unique_ptr<const Shades> shades_;
};

}  // namespace fovea::line
