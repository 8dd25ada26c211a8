// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/visibility/depth.h>

#include <cmath>

#include <fovea/base/check.h>
#include <fovea/scene/bodies.h>
#include <fovea/scene/section.h>
#include <fovea/visibility/triangle_edges.h>

namespace fovea::visibility {
namespace {

/// Clamps slopes of triangles seen almost edge-on.
float slope(double value) {
    return static_cast<float>(std::clamp(value, -double(max_depth_slope), double(max_depth_slope)));
}

/// An edge of a triangle, evaluated along a row of texels.
struct RowEdge {
    int along;            ///< its code without the distance
    double inside, step;  ///< distance inside at texel 0, and its change from texel to texel

    /// `of_mesh`: false for an edge that is not of the mesh, which excludes nothing, as one with an end so far away
    /// that the distance to it is no number.
    RowEdge(dvec2 a, dvec2 b, int y, bool of_mesh) {
        const dvec2 way = b - a, inwards(-way.y, way.x);
        const double length = std::abs(way.x) + std::abs(way.y);
        const double distance = glm::dot(inwards, dvec2(0.5, y + 0.5) - a) / length;
        const bool excludes = of_mesh && length > 0.0 && length < HUGE_VAL && std::abs(distance) < HUGE_VAL;
        const dvec2 normal = excludes ? inwards / length : dvec2(0.0);
        along = formulas::Edges().edge_code_of(0.0f, normal);
        inside = excludes ? distance : 0.0;
        step = normal.x;
    }
    int code(int x) const { return formulas::Edges().edge_code(along, float(inside + step * x)); }
};

/// Rasterizes rows y0 to y1 (excluded) of a triangle of a facet.
void draw_rows(const RasterTriangle& t, int y0, int y1, Index facet, DepthBuffer& buffer) {
    const TriangleRows rows(t);
    const DepthTexel plane{0.0f, slope(t.plane.x * buffer.scale), slope(t.plane.y * buffer.scale), facet, {}};
    for (int y = y0; y < y1; ++y) {
        const RowEdge first(t.corner[0], t.corner[1], y, t.of_mesh[0]),
            second(t.corner[1], t.corner[2], y, t.of_mesh[1]), third(t.corner[2], t.corner[0], y, t.of_mesh[2]);
        DepthTexel* row = &buffer.texels[std::size_t(y) * buffer.width];
        const auto in_front = [&](int x, double exact) {
            const float depth = static_cast<float>(exact);
            const DepthTexel& texel = row[x];
            return texel.facet == none || depth > texel.depth || (depth == texel.depth && facet < texel.facet);
        };
        each_texel(rows, y, in_front, [&](int x, double depth) {
            row[x] = plane;
            row[x].depth = static_cast<float>(depth);
            row[x].edges = formulas::Edges().pack_edges(first.code(x), second.code(x), third.code(x));
        });
    }
}

/// Extent of a tile along one axis [px of the whole, including its border].
struct TileSpan {
    int begin, end;  // with the overlap
    int core_begin, core_end;
};

std::vector<TileSpan> spans(int size, int most, int overlap) {
    if (size <= most) return {{0, size, 0, size}};
    const int inner = most - 2 * overlap;
    check(inner > 0,
          "options.visibility: too few texels in a tile of the depth buffer for strokes as wide; take narrower "
          "pens, or exact visibility");
    const int count = (size + inner - 1) / inner;
    std::vector<TileSpan> result;
    for (int i = 0; i < count; ++i) {
        const int begin = int(std::int64_t(size) * i / count), end = int(std::int64_t(size) * (i + 1) / count);
        result.push_back({std::max(begin - overlap, 0), std::min(end + overlap, size), begin, end});
    }
    return result;
}

}  // namespace

DepthBuffer depth_layout(const View& view, const DepthOptions& options) {
    check(view.width > 0 && view.height > 0, "depth buffer: the image is empty");
    check(options.scale >= 1, "depth buffer: scale must be at least 1");
    check(options.margin >= 0.0, "depth buffer: margin must not be negative");
    DepthBuffer layout;
    layout.scale = options.scale;
    layout.border_x = static_cast<int>(std::ceil(0.5 * options.margin * view.width));
    layout.border_y = static_cast<int>(std::ceil(0.5 * options.margin * view.height));
    layout.width = (view.width + 2 * layout.border_x) * options.scale;
    layout.height = (view.height + 2 * layout.border_y) * options.scale;
    return layout;
}

std::vector<DepthBuffer> depth_tiles(const View& view, const DepthOptions& options, int side, int overlap_px) {
    const DepthBuffer whole = depth_layout(view, options);
    const int width = whole.width / whole.scale, height = whole.height / whole.scale;
    std::vector<DepthBuffer> tiles;
    for (const TileSpan& y : spans(height, side / whole.scale, overlap_px))
        for (const TileSpan& x : spans(width, side / whole.scale, overlap_px)) {
            DepthBuffer tile = whole;
            tile.border_x = whole.border_x - x.begin;
            tile.border_y = whole.border_y - y.begin;
            tile.width = (x.end - x.begin) * whole.scale;
            tile.height = (y.end - y.begin) * whole.scale;
            // Cores of the outermost tiles extend beyond the border.
            if (x.core_begin > 0) tile.core.x = float(x.core_begin - whole.border_x);
            if (y.core_begin > 0) tile.core.y = float(y.core_begin - whole.border_y);
            if (x.core_end < width) tile.core.z = float(x.core_end - whole.border_x);
            if (y.core_end < height) tile.core.w = float(y.core_end - whole.border_y);
            tiles.push_back(std::move(tile));
        }
    return tiles;
}

dmat4 view_to_depth_clip(const View& view, const DepthBuffer& layout) {
    dmat4 matrix = view.view_to_clip;
    const double range = view.far_clip - view.near_clip;
    // Third row: depth times w. Perspective: near / -z times -z. Orthographic: (far + z) / (far - near).
    const dvec4 row =
        view.orthographic ? dvec4(0.0, 0.0, 1.0 / range, view.far_clip / range) : dvec4(0.0, 0.0, 0.0, view.near_clip);
    // From the frame's NDC to the buffer's: scale, and offset of the centers.
    const dvec2 size = dvec2(layout.width, layout.height) / double(layout.scale), frame(view.width, view.height);
    const dvec2 share = frame / size, shift = (frame + 2.0 * dvec2(layout.border_x, layout.border_y)) / size - 1.0;
    for (int column = 0; column < 4; ++column) {
        dvec4& m = matrix[column];
        m.x = m.x * share.x + m.w * shift.x;
        m.y = m.y * share.y + m.w * shift.y;
        m.z = row[column];
    }
    return matrix;
}

RasterTarget raster_target(const View& view, const DepthBuffer& layout) {
    return {layout.width, layout.height, view_to_depth_clip(view, layout)};
}

std::vector<Occluder> occluders(const Scene& scene, const View& view, double margin) {
    std::vector<Occluder> result;
    for (Index i = 0; i < scene.placements.size(); ++i) {
        const Placement& placement = scene.placements[i];
        if (!(placement.usage & usage_occlude) || placement.surface->occluding_triangles == 0 ||
            !in_frame(placement, view, margin))
            continue;
        const Cut cut = cut_of(scene, placement);
        if (cut.kept == Cut::nothing) continue;
        result.push_back({i, view.world_to_view * placement.object_to_world, false});
        if (cut.kept == Cut::part) result.back().cut = cut.plane;
    }
    parallel_for(result.size(), 1, [&](std::size_t i) {
        const Placement& placement = scene.placements[result[i].placement];
        const Sphere sphere = bounding_sphere(placement, view);
        const bool beyond_near = -sphere.center.z - sphere.radius > view.near_clip;
        result[i].solid = beyond_near && !result[i].cut && bodies_of(*placement.surface)->all_outward;
    });
    return result;
}

double depth_reach(const Scene& scene, const View& view, double margin) {
    double reach = 0.0;
    for (const Occluder& occluder : occluders(scene, view, margin)) {
        const Sphere sphere = bounding_sphere(scene.placements[occluder.placement], view);
        reach = std::max(reach, sphere.radius - sphere.center.z);
    }
    return reach;
}

std::vector<RasterMesh> depth_meshes(const Scene& scene, const View& view, double margin) {
    return depth_meshes(scene, occluders(scene, view, margin));
}

std::vector<RasterMesh> depth_meshes(const Scene& scene, In<Occluder> occluders) {
    std::vector<RasterMesh> meshes;
    for (const Occluder& occluder : occluders) {
        const Surface& surface = *scene.placements[occluder.placement].surface;
        meshes.push_back({surface.positions, In<glm::uvec3>(surface.triangles).first(surface.occluding_triangles),
                          In<Index>(surface.triangle_facet).first(surface.occluding_triangles), occluder.object_to_view,
                          scene.facet_base[occluder.placement], occluder.one_sided_from(surface), occluder.cut});
    }
    return meshes;
}

DepthBuffer draw_depth(DepthBuffer buffer, const View& view, In<RasterMesh> meshes, const Cancel* cancel) {
    buffer.texels.resize(std::size_t(buffer.width) * buffer.height);
    parallel_blocks(buffer.texels.size(), std::size_t(1) << 18, [&](auto, std::size_t begin, std::size_t end) {
        std::fill(buffer.texels.begin() + begin, buffer.texels.begin() + end, DepthTexel());
    });
    draw_triangles(raster_target(view, buffer), meshes, cancel, [&](const RasterTriangle& t, int y0, int y1) {
        const RasterMesh& mesh = meshes[t.mesh];
        draw_rows(t, y0, y1, mesh.facet_base + mesh.triangle_facet[t.triangle], buffer);
    });
    return buffer;
}

}  // namespace fovea::visibility
