// SPDX-License-Identifier: GPL-3.0-or-later
// The depth buffer that sampled visibility looks into: what the GPU's depth pass draws, drawn in software.
#pragma once

#include <fovea/base/parallel.h>
#include <fovea/base/types.h>
#include <fovea/base/view.h>
#include <fovea/raster/triangles.h>
#include <fovea/scene/scene.h>

namespace fovea::visibility {

/// Surfaces seen almost edge on have no steeper slope than this.
inline constexpr float max_depth_slope = 1e6f;

/// The nearest surface at a texel's center, as a plane over the image.
struct DepthTexel {
    float depth = 0.0f;  ///< reversed screen-linear depth (base/view.h), at the texel's center
    /// Its change per pixel of the view (not per texel), to the right and up; at most max_depth_slope.
    float ddx = 0.0f, ddy = 0.0f;
    Index facet = none;  ///< number over the whole scene; `none`: background
    vec2 edges{0.0f};    ///< of the triangle that covers the center (triangle_edges.h)
};

/// Texels of a view drawn at `scale` times its resolution, with `border_x` and `border_y` pixels left of and below the
/// frame (fewer than none in most tiles, depth_tiles); rows from bottom to top. The center of texel (x, y) lies at
/// ((x + .5) / scale - border_x, (y + .5) / scale - border_y) pixels.
struct DepthBuffer {
    int scale = 1;
    int border_x = 0, border_y = 0;
    int width = 0, height = 0;  ///< texels
    /// Left, lower, right and upper edge [px] of what it decides; a tile's neighbors decide the rest.
    vec4 core{-far_px, -far_px, far_px, far_px};
    Array<DepthTexel> texels;

    static constexpr float far_px = 1e9f;

    bool decides(vec2 px) const { return px.x >= core.x && px.y >= core.y && px.x < core.z && px.y < core.w; }
    const DepthTexel& at(int x, int y) const { return texels[std::size_t(y) * width + x]; }
    /// Texels of a pixel position: (.5, .5) is the center of texel (0, 0).
    vec2 to_texels(vec2 px) const { return (px + vec2(border_x, border_y)) * float(scale); }
};

/// How a view's depth buffer is laid out.
struct DepthOptions {
    int scale = 2;
    /// Room around the frame, as a share of its half size: as far as paths are clipped.
    double margin = 0.1;
};

/// Size and border of a view's depth buffer, without texels. Throws std::invalid_argument on an empty image, a scale
/// below 1 or a negative margin.
DepthBuffer depth_layout(const View& view, const DepthOptions& options);

/// The same in tiles, where it is larger than textures or than memory allows.
/// Layouts of at most `side` texels along each axis that together show what depth_layout shows. Their cores do not
/// overlap and leave nothing out; each shows `overlap_px` pixels around its core (less at the border), so that what is
/// decided inside the core looks at the very texels it would look at in the whole. One layout, the whole, where that is
/// small enough. Throws std::invalid_argument where a tile would have no core, and as depth_layout.
std::vector<DepthBuffer> depth_tiles(const View& view, const DepthOptions& options, int side, int overlap_px);

/// Maps homogeneous view-space points to (x w, y w, depth w, w), x and y in [-1, 1] over the buffer: clip space whose
/// third coordinate is the depth above. The GPU's depth pass uses the same matrix.
dmat4 view_to_depth_clip(const View& view, const DepthBuffer& layout);

/// A layout as triangles are drawn into it.
RasterTarget raster_target(const View& view, const DepthBuffer& layout);

/// A placement that hides lines in a view.
struct Occluder {
    Index placement;
    dmat4 object_to_view;
    bool solid;  ///< made of bodies that face outwards (scene/bodies.h), and wholly beyond the near plane
};

/// Placements with occluding triangles in the frame widened by `margin`.
std::vector<Occluder> occluders(const Scene& scene, const View& view, double margin);

/// How far away along the view they reach; 0: there are none.
double depth_reach(const Scene& scene, const View& view, double margin);

/// Their triangles, borrowed from the scene.
std::vector<RasterMesh> depth_meshes(const Scene& scene, const View& view, double margin);

/// Draws triangles into a layout (depth_layout, or a tile). What lies nearer than the near plane is cut off; the far
/// plane cuts nothing off. At equal depth the lower facet wins. Triangles without area on the screen or with a
/// coordinate that is not finite leave no trace. Throws std::invalid_argument on indices out of range.
DepthBuffer draw_depth(DepthBuffer layout, const View& view, In<RasterMesh> meshes, const Cancel* cancel = nullptr);

}  // namespace fovea::visibility
