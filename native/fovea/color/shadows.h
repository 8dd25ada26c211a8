// SPDX-License-Identifier: GPL-3.0-or-later
// Which lights reach what is seen of a scene, by rays: the shadows of the color layer.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include <fovea/color/light.h>
#include <fovea/scene/shade.h>
#include <fovea/scene/tracer.h>

namespace fovea::color {

/// Of each light two bits: the lower ones for a part of it, the upper ones for its middle.
using LightBits = std::uint16_t;

/// Which lights shine on places, and which do not. Both are 0 where there is none.
struct KnownLights {
    LightBits lit = 0, dark = 0;

    LightBits differ() const { return lit & dark; }
    /// Those of some of which rays decide: places differ, or there is none.
    LightBits open(LightBits of) const { return LightBits(~(lit ^ dark) & of); }
    void operator|=(const KnownLights& other) {
        lit |= other.lit;
        dark |= other.dark;
    }
};

/// Parts of lights that rays are sent to: an even choice of so many, or those of one of a pixel's 16 samples.
struct PartsOfLights {
    int count;
    std::optional<int> sample = {};
};
/// In a penumbra; from a sample that stands for others of its triangle in the pixel; and from each of 16, all of whose
/// parts are those of a penumbra.
inline constexpr PartsOfLights all_parts{64}, few_parts{16};
inline PartsOfLights parts_of_sample(int sample) { return {all_parts.count / 16, sample}; }
/// Every second pixel along each axis is looked at first, then all up to around_px from where those differ; of squares
/// of around_px times as many pixels, those take 16 parts. Any 5 x 5 pixels of those have a square of 4 x 4 of all
/// parts.
inline constexpr int first_px = 2, around_px = 4;

class Shadows {
   public:
    /// `casters`: of casting_lights, at most most_casters. The tracer must outlive it.
    Shadows(const Tracer& tracer, std::vector<Light> casters, const style::Color& style);

    /// A visible place; `point` in view space.
    ShadedPlace place(Index placement, Index triangle, const dvec3& point) const;
    /// Its normal in view space if it is on a smooth surface, else 0.
    vec3 smooth_normal(const ShadedPlace& place) const;
    /// What reaches the place at the center of a pixel, of each light a part that depends on the pixel; of lights that
    /// do not differ around it, as is known.
    KnownLights sampled(const ShadedPlace& place, int x, int y, const KnownLights& around) const;
    /// Whether rays decide of any light.
    bool is_open(const KnownLights& around) const { return around.open(asked_) != 0; }
    /// What shadows leave of the lights at a place: of those that differ around it by rays to parts of each, of others
    /// as is known.
    void leave(const ShadedPlace& place, const KnownLights& around, const PartsOfLights& parts, Reach& reach) const;
    /// Which of their middles it sees, alike.
    void see_middles(const ShadedPlace& place, const KnownLights& around, Reach& reach) const;

   private:
    float share(std::size_t light, const ShadedPlace& place, const PartsOfLights& parts) const;

    dmat4 view_to_world_;
    dmat3 world_to_view_;
    float strength_;
    scene::Shades shades_;
    LightBits asked_ = 0;                                                // of all lights, what the style needs to know
    std::vector<std::unique_ptr<const scene::ShadedSurface>> surfaces_;  // per placement; null: outside of the frame
};

/// What is known up to so many pixels around each, of what is known at all (width * height).
Array<KnownLights> known_around(const Array<KnownLights>& known, int width, int px);

}  // namespace fovea::color
