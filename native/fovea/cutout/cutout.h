// SPDX-License-Identifier: GPL-3.0-or-later
// Cuts out of a mesh what the opacity images of its materials leave transparent, before anything is derived from it: so
// every stage, on every backend, sees the cut-out as what it is, a surface with borders.
#pragma once

#include <array>
#include <memory>
#include <string>

#include <fovea/cutout/opacity.h>
#include <fovea/mesh/surface.h>

namespace fovea::cutout {

/// Opacity over a mesh.
struct Cut {
    Array<vec2> uvs;  ///< per corner, in the image's texture space
    std::shared_ptr<const Opacity> opacity;
};

struct CutOptions {
    In<int> cut_of_polygon;  ///< per polygon, an index into the cuts; -1: opaque
    /// Pixels of the drawing per unit of object space, where it is seen largest: images are halved as long as a texel
    /// covers less than texel_px of them. 0: not known.
    double px_per_unit = 0.0;
};

inline constexpr double texel_px = 1.0;

/// A mesh without what is transparent. Polygons that are opaque everywhere stay as they are, except that their sides
/// have the points at which neighbors are cut; others become a polygon per opaque piece of each of their triangles.
/// Vertices of the mesh keep their numbers; new ones follow.
class CutMesh : public OwnedMesh {
   public:
    /// Throws std::invalid_argument, naming the object, for an invalid mesh (as Surface does) or arrays of wrong sizes.
    CutMesh(const std::string& name, const MeshArrays& mesh, const std::vector<Cut>& cuts, const CutOptions& options);

    /// Positions of all vertices for moved ones of the mesh that was cut.
    Array<vec3> moved(In<vec3> positions) const;
    /// Values at the corners, for `columns` numbers at each corner of the mesh that was cut.
    Array<float> mix_corners(In<float> values, int columns) const;

   private:
    friend class Builder;
    /// A weighted mean of up to three vertices or corners.
    struct Mean {
        std::array<Index, 3> of{none, none, none};
        std::array<double, 3> weight{};
    };
    void build(const MeshArrays& mesh, const std::vector<Cut>& cuts, const CutOptions& options);

    std::string name_;
    std::size_t vertices_, corners_;  // of the mesh that was cut
    std::vector<Mean> new_vertices_, corner_means_;
};

/// The surface of a CutMesh, which moves with the mesh that was cut.
class CutSurface : public Surface {
   public:
    CutSurface(const std::string& name, const MeshArrays& mesh, const std::vector<Cut>& cuts, const CutOptions& options)
        : CutSurface(name, CutMesh(name, mesh, cuts, options)) {}

    /// Moves the vertices of the mesh that was cut. `refit`: see Surface::set_positions.
    void move(In<vec3> positions, bool refit = false) { set_positions(cut_.moved(positions), refit); }
    Array<float> mix_corners(In<float> values, int columns) const { return cut_.mix_corners(values, columns); }

   private:
    CutSurface(const std::string& name, CutMesh cut) : Surface(name, cut.arrays()), cut_(std::move(cut)) {}
    CutMesh cut_;
};

}  // namespace fovea::cutout
