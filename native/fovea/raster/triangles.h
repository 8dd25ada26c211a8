// SPDX-License-Identifier: GPL-3.0-or-later
// Software rasterizer: projects triangles, clips them at the near plane, and scan-converts them row by row.
#pragma once

#include <array>
#include <functional>
#include <optional>

#include <fovea/base/parallel.h>
#include <fovea/base/types.h>

namespace fovea::raster {

/// Triangles of one placement; arrays are borrowed.
struct RasterMesh {
    In<vec3> positions;        ///< vertex indices
    In<glm::uvec3> triangles;  ///< per triangle, facet index within the mesh
    In<Index> triangle_facet;  ///< per triangle, numbered over the mesh
    dmat4 object_to_view{1.0};
    Index facet_base = 0;  ///< added to triangle_facet: facet index over the scene
    /// From this triangle on, back-facing ones are culled: they are not seen, or front-facing ones cover them.
    Index one_sided_from = none;
    /// Section plane in object space: what is before it, where dot(cut, (p, 1)) is positive, is clipped.
    std::optional<dvec4> cut = {};
};

/// A triangle in screen space, in texels. Edge functions are evaluated with the two ends in a fixed order, so triangles
/// that share an edge leave no texel between them uncovered.
struct RasterTriangle {
    std::array<dvec2, 3> corner;
    dvec3 plane;           ///< depth (base/view.h) = plane . (x, y, 1)
    Index mesh, triangle;  ///< index of the mesh, and of the triangle in it
    /// Per edge, from corner i to corner i + 1: whether it is an edge of the source triangle. Edges made by near-
    /// or section-plane clipping and by cutting the clipped polygon in two are not, as on the GPU.
    std::array<bool, 3> of_mesh;
    int x0, x1, y0, y1;  ///< texels whose centers are within the bounding box, x1 and y1 exclusive
    /// If these are at most `most_of_few`: which of them it covers, row by row from the first bit on; else 0.
    std::uint8_t few;
    static constexpr int most_of_few = 8;

    bool covers(dvec2 p) const;
    double depth(int x, double depth_y) const { return plane.x * (x + 0.5) + depth_y; }
    /// The term of `depth` that is constant along row y.
    double depth_y(int y) const { return plane.y * (y + 0.5) + plane.z; }
};

/// Texels covered by a triangle, row by row. The triangle is borrowed and must outlive this.
class TriangleRows {
   public:
    explicit TriangleRows(const RasterTriangle& triangle);

    /// Texels [begin, end) of a row.
    struct Texels {
        int begin, end;
    };
    /// Texels of row y whose centers are covered; contiguous, as the triangle is convex.
    Texels covered(int y) const;

    const RasterTriangle& triangle() const { return triangle_; }

   private:
    /// Line of an edge, as x over rows, at texel centers: x = at + step * y.
    struct Side {
        double at, step;
    };
    const RasterTriangle& triangle_;
    std::array<Side, 2> left_, right_;  // without a second edge on that side: a line that clips nothing
    double unsure_ = 0.0;               // centers closer than this to an edge are decided by `covers`
};

/// Calls put(x, depth) for each covered texel x of row y for which in_front(x, depth) is true.
template <typename InFront, typename Put>
void each_texel(const TriangleRows& rows, int y, const InFront& in_front, const Put& put) {
    const RasterTriangle& triangle = rows.triangle();
    const double depth_y = triangle.depth_y(y);
    const auto [begin, end] = rows.covered(y);
    for (int x = begin; x < end; ++x) {
        const double depth = triangle.depth(x, depth_y);
        if (in_front(x, depth)) put(x, depth);
    }
}

/// Viewport and projection of a rasterization.
struct RasterTarget {
    int width, height;   ///< texels
    dmat4 view_to_clip;  ///< to (x w, y w, depth w, w), with x and y in [-1, 1] over the viewport
};

/// Rows per band; bands run in parallel, and the first starts at row 0.
inline constexpr int raster_band_rows = 16;

/// Calls draw(triangle, y0, y1) for every triangle that may cover a texel center in rows [y0, y1). Bands of rows run in
/// parallel; within a band, triangles come in the order of the meshes. Triangles are clipped at the near plane but not
/// at the far plane. Triangles with zero screen area or non-finite coordinates are dropped. With `draw_few`, those of
/// few texels are given to it instead, in any order and from several threads at once, but never while `draw` is called.
/// Throws std::invalid_argument for indices out of range.
void draw_triangles(const RasterTarget& target, In<RasterMesh> meshes, const Cancel* cancel,
                    const std::function<void(const RasterTriangle&, int, int)>& draw,
                    const std::function<void(const RasterTriangle&)>& draw_few = {});

}  // namespace fovea::raster
