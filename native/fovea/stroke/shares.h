// SPDX-License-Identifier: GPL-3.0-or-later
// Whose ink a pixel has: what remains visible of each contributor's fragments that lie over one another.
#pragma once

#include <vector>

#include <fovea/base/types.h>
#include <fovea/raster/fixed_triangle.h>

namespace fovea::stroke {

/// A contributor's share of a pixel's alpha.
struct Share {
    std::uint32_t id;
    float share;
};

/// Shares of the pixels of a box. At each pixel they add up to its alpha, but for what ids of 0, of nobody, have of it.
class Shares {
   public:
    explicit Shares(const PixelBox& box) : box_(box), first_(std::size_t(box.x1 - box.x0) * (box.y1 - box.y0), none) {}

    /// Adds a fragment over those that were added before.
    void add(int x, int y, std::uint32_t id, float alpha);

    /// The shares of a pixel above 0, greatest first, those of one size by id. Overwrites `out`.
    void ranked(int x, int y, std::vector<Share>& out) const;

   private:
    struct Entry {
        Share share;
        Index next;  ///< of the same pixel; `none`: the last
    };

    std::size_t at(int x, int y) const { return std::size_t(y - box_.y0) * (box_.x1 - box_.x0) + (x - box_.x0); }

    PixelBox box_;
    Array<Index> first_;
    std::vector<Entry> entries_;
};

}  // namespace fovea::stroke
