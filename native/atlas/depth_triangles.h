// Triangles as software depth tests draw them: projected, cut at the near plane, and drawn row by row.
#pragma once

#include <array>
#include <cmath>
#include <functional>

#include "atlas/depth.h"

namespace fovea {

/// A triangle on the screen, in texels of a layout. Corners are in a fixed order per edge when tested, so that two
/// triangles that share an edge leave no texel between them.
struct DepthTriangle {
    std::array<dvec2, 3> corner;
    dvec3 plane;            ///< depth (base/view.h) = plane . (x, y, 1)
    Index mesh, triangle;   ///< which of the meshes, and which triangle of it
    /// Which edges, from each corner to the next, are the mesh's; the near plane's cut is none, as on the GPU.
    std::array<bool, 3> of_mesh;
    int x0, x1, y0, y1;     ///< texels whose centres the bounding box holds, x1 and y1 excluded

    bool covers(dvec2 p) const;
};

/// Texels begin to end of a row: those whose centres a triangle covers, and those that lie so near to an edge that
/// `covers` must be asked: before `sure_begin` and from `sure_end` on.
struct TexelRow {
    int begin, end, sure_begin, sure_end;
};
TexelRow texel_row(const DepthTriangle& triangle, int y);

/// put(x, depth) for each texel (x, y) that the triangle covers and where in_front(x, depth).
template <typename InFront, typename Put>
void each_texel(const DepthTriangle& triangle, int y, const InFront& in_front, const Put& put) {
    const TexelRow row = texel_row(triangle, y);
    const double depth_y = triangle.plane.y * (y + 0.5) + triangle.plane.z;
    for (int x = row.begin; x < row.end; ++x) {
        const double depth = triangle.plane.x * (x + 0.5) + depth_y;
        if (!in_front(x, depth)) continue;
        if ((x < row.sure_begin || x >= row.sure_end) && !triangle.covers(dvec2(x + 0.5, y + 0.5))) continue;
        put(x, depth);
    }
}

/// draw(triangle, y0, y1) for every triangle that may cover a texel's centre in the rows y0 to y1 (excluded) of a
/// layout: side by side for bands of rows, within each in the order of the meshes. What lies nearer than the near plane
/// is cut off; the far plane cuts nothing off. Triangles without area on the screen or with a coordinate that is not
/// finite are left out. Throws std::invalid_argument on indices out of range.
void draw_triangles(const DepthBuffer& layout, const View& view, In<DepthMesh> meshes, const Cancel* cancel,
                    const std::function<void(const DepthTriangle&, int, int)>& draw);

}  // namespace fovea
