// SPDX-License-Identifier: GPL-3.0-or-later
// Who decides what a depth buffer hides, what crowds, and who puts strokes on paper.
#pragma once

#include <string>

#include <fovea/elision/bands.h>
#include <fovea/elision/own_band.h>

namespace fovea::draw {

class Frame;

/// Runs on their way through elision: what both backends draw and read.
struct Elision : OwnBands, Bands {};

/// Arguments as of own_bands.
inline Elision elision_of(const ClippedPaths& clipped, const Runs& runs, In<Index> ranks, In<float> half_width_px,
                          float reach_px) {
    OwnBands own = own_bands(clipped, runs, ranks, half_width_px, reach_px);
    Bands bands = draw_bands(clipped, runs, ranks, own);
    return {std::move(own), std::move(bands)};
}

/// Three verbs over a Frame whose earlier members are filled. `CpuBackend` is the reference and draws the same picture
/// on every machine; others may need a context, and are called on the thread that draws.
class Backend {
   public:
    virtual ~Backend() = default;
    virtual std::string name() const = 0;

    /// How visible each atlas sample is, in [0, 1], by the frame's sampled method: Visibility::atlas or item_buffer.
    virtual Array<float> visibility(const Frame& frame) = 0;

    /// How crowded each sample of `elision` is, as elision/elide.h tells it.
    virtual Array<vec2> elide(const Frame& frame, const Elision& elision) = 0;

    /// The frame's strokes alone: scene-linear, premultiplied, bottom row first; by Visibility::spine what is hidden of
    /// them is left out here.
    virtual Array<vec4> draw(const Frame& frame) = 0;
};

/// All of it in software, in tiles that memory allows.
class CpuBackend : public Backend {
   public:
    explicit CpuBackend(int side = 6144) : most_side(side) {}

    std::string name() const override { return "cpu"; }
    Array<float> visibility(const Frame& frame) override;
    Array<vec2> elide(const Frame& frame, const Elision& elision) override;
    Array<vec4> draw(const Frame& frame) override;

    int most_side;  ///< texels of a tile of the depth buffer; of 6144 one takes 0.9 GB
};

}  // namespace fovea::draw
