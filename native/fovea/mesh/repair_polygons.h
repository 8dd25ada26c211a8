// SPDX-License-Identifier: GPL-3.0-or-later
// Polygons while they are being repaired.
#pragma once

#include <unordered_map>

#include <fovea/mesh/repair.h>

namespace fovea {

/// Marks of edges by their vertices.
class EdgeMarks {
   public:
    std::uint8_t at(Index a, Index b) const {
        const auto it = bits_.find(key(a, b));
        return it == bits_.end() ? 0 : it->second;
    }
    void add(Index a, Index b, std::uint8_t bits) {
        if (bits && a != b) bits_[key(a, b)] |= bits;
    }
    bool empty() const { return bits_.empty(); }
    template <typename Visit>
    void each(const Visit& visit) const {
        for (const auto& [k, bits] : bits_) visit(Index(k >> 32), Index(k), bits);
    }

   private:
    static std::uint64_t key(Index a, Index b) { return std::uint64_t(std::min(a, b)) << 32 | std::max(a, b); }
    std::unordered_map<std::uint64_t, std::uint8_t> bits_;
};

struct Polygon {
    std::vector<Index> vertices;
    int origin = 0;                        ///< the mesh's polygon that it comes from
    std::vector<Triangle> triangles = {};  ///< where it has more than four corners
};

struct Polygons {
    std::vector<dvec3> positions;
    std::vector<Polygon> polygons;
    EdgeMarks marks;
};

Polygons polygons_of(const MeshArrays& mesh);

/// Joins vertices; returns how many are gone from the polygons.
Index weld(Polygons& all, double distance);

/// Turns polygons around; returns how many.
Index orient(Polygons& all);

/// Smooths, then resamples; returns how many polygons were left out. `mesh`: what the origins are of.
Index remesh(Polygons& all, const Repair& repair, const MeshArrays& mesh);

}  // namespace fovea
