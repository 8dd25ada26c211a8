// SPDX-License-Identifier: GPL-3.0-or-later
// The depth buffer that sampled visibility reads: the GPU's depth pass in software.
#pragma once

#include <fovea/base/parallel.h>
#include <fovea/base/types.h>
#include <fovea/base/view.h>
#include <fovea/raster/triangles.h>
#include <fovea/scene/scene.h>

namespace fovea::visibility {

/// Upper bound of depth slopes, for surfaces seen almost edge-on.
inline constexpr float max_depth_slope = 1e6f;

/// The nearest surface at a texel's center, as a plane over the image.
struct DepthTexel {
    float depth = 0.0f;  ///< reversed screen-linear depth (base/view.h), at the texel's center
    /// Its change per pixel of the view (not per texel), to the right and up; at most max_depth_slope.
    float ddx = 0.0f, ddy = 0.0f;
    Index facet = none;  ///< number over the whole scene; `none`: background
    vec2 edges{0.0f};    ///< packed edges of the triangle at the center (triangle_edges.h)
};

/// Texels of a view drawn at `scale` times its resolution, with `border_x` and `border_y` pixels left of and below the
/// frame (negative in most tiles, see depth_tiles); rows from bottom to top. The center of texel (x, y) lies at ((x +
/// .5) / scale - border_x, (y + .5) / scale - border_y) pixels.
struct DepthBuffer {
    int scale = 1;
    int border_x = 0, border_y = 0;
    int width = 0, height = 0;  ///< texels
    /// Left, lower, right and upper bound [px] of the region in which this buffer determines visibility; outside of a
    /// tile's core its neighbors do.
    vec4 core{-far_px, -far_px, far_px, far_px};
    Array<DepthTexel> texels;

    static constexpr float far_px = 1e9f;

    bool decides(vec2 px) const { return px.x >= core.x && px.y >= core.y && px.x < core.z && px.y < core.w; }
    const DepthTexel& at(int x, int y) const { return texels[std::size_t(y) * width + x]; }
    /// Texel coordinates of a pixel position: (.5, .5) is the center of texel (0, 0).
    vec2 to_texels(vec2 px) const { return (px + vec2(border_x, border_y)) * float(scale); }
};

/// How a view's depth buffer is laid out.
struct DepthOptions {
    int scale = 2;
    /// Margin around the frame, as a fraction of its half size: the one to which paths are clipped.
    double margin = 0.1;
};

/// Size and border of a view's depth buffer, without texels. Throws std::invalid_argument on an empty image, a scale
/// below 1 or a negative margin.
DepthBuffer depth_layout(const View& view, const DepthOptions& options);

/// The same region in tiles, for buffers larger than a texture or than memory: layouts of at most `side` texels along
/// each axis. Their cores partition the region; each tile extends `overlap_px` pixels beyond its core (less at the
/// border), so that visibility inside the core reads the very texels of the whole buffer. A single layout, the whole,
/// where that is small enough. Throws std::invalid_argument where a tile would have no core, and as depth_layout.
std::vector<DepthBuffer> depth_tiles(const View& view, const DepthOptions& options, int side, int overlap_px);

/// Maps homogeneous view-space points to (x w, y w, depth w, w), x and y in [-1, 1] over the buffer: clip space whose
/// third coordinate is the depth above. The GPU's depth pass uses the same matrix.
dmat4 view_to_depth_clip(const View& view, const DepthBuffer& layout);

/// Raster target of a layout.
RasterTarget raster_target(const View& view, const DepthBuffer& layout);

/// A placement that occludes lines in a view.
struct Occluder {
    Index placement;
    dmat4 object_to_view;
    bool solid;                     ///< closed, outward-facing bodies (scene/bodies.h), which no clip plane opens
    std::optional<dvec4> cut = {};  ///< RasterMesh::cut
    /// The first of its triangles whose backs need not be drawn, or must not be.
    Index one_sided_from(const Surface& surface) const { return solid ? 0 : surface.two_sided_triangles; }
};

/// Placements with occluding triangles in the frame widened by `margin` that the section plane does not cut away.
std::vector<Occluder> occluders(const Scene& scene, const View& view, double margin);

/// Greatest distance of occluders along the view axis; 0 without occluders.
double depth_reach(const Scene& scene, const View& view, double margin);

/// Triangles of the occluders, borrowed from the scene.
std::vector<RasterMesh> depth_meshes(const Scene& scene, In<Occluder> occluders);
std::vector<RasterMesh> depth_meshes(const Scene& scene, const View& view, double margin);

/// Rasterizes triangles into a layout (depth_layout, or a tile). They are clipped at the near plane and at
/// their section plane, not at the far plane. At equal depth the lower facet wins. Triangles without area on the screen
/// or with a non-finite coordinate are skipped. Throws std::invalid_argument on indices out of range.
DepthBuffer draw_depth(DepthBuffer layout, const View& view, In<RasterMesh> meshes, const Cancel* cancel = nullptr);

}  // namespace fovea::visibility
