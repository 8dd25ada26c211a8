#include "atlas/depth.h"

#include <array>
#include <cmath>
#include <string>

#include "atlas/triangle_edges.h"
#include "base/check.h"
#include "scene/bodies.h"

namespace fovea {
namespace {

constexpr int band_rows = 16;
constexpr std::size_t block_triangles = 2048;
constexpr std::size_t group_blocks = 128;

/// A triangle on the screen, in texels. Corners are in a fixed order per edge when tested, so that two triangles that
/// share an edge leave no texel between them.
struct ScreenTriangle {
    std::array<dvec2, 3> corner;
    dvec3 plane;  // depth = plane . (x, y, 1)
    Index facet;
    /// Which edges, from each corner to the next, are the mesh's; the near plane's cut is none, as on the GPU.
    std::array<bool, 3> of_mesh;
    int x0, x1, y0, y1;  // texels whose centres the bounding box holds, x1 and y1 excluded
};

struct Target {
    int width, height;
    dmat4 view_to_depth_clip;
};

/// What is left out of a mesh, by the sign of a triangle's area on the screen; 0: nothing.
double away_sign(const DepthMesh& mesh) {
    if (!mesh.one_sided) return 0.0;
    return glm::determinant(dmat3(mesh.object_to_view)) < 0.0 ? 1.0 : -1.0;
}

/// Twice the signed area of (a, b, p). Computed the same way for (b, a), with the other sign.
double edge_function(dvec2 a, dvec2 b, dvec2 p) {
    const bool swapped = b.x < a.x || (b.x == a.x && b.y < a.y);
    if (swapped) std::swap(a, b);
    const double area = (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
    return swapped ? -area : area;
}

/// First texel whose centre is not below `edge`, clamped to [0, size].
int first_texel(double edge, int size) {
    return static_cast<int>(std::clamp(std::ceil(edge - 0.5), 0.0, double(size)));
}

/// Appends the triangle unless it covers no texel centre. `clip`: homogeneous corners of what is left of it in front
/// of the near plane; `plane`: depth over the texels.
void append_screen_triangle(const std::array<dvec3, 3>& clip, const dvec3& plane, Index facet, const Target& target,
                            double away, const std::array<bool, 3>& of_mesh, std::vector<ScreenTriangle>& out) {
    ScreenTriangle t;
    t.of_mesh = of_mesh;
    for (int i = 0; i < 3; ++i) t.corner[i] = dvec2(clip[i]) / clip[i].z;
    const auto [ax, bx, cx] = std::array{t.corner[0].x, t.corner[1].x, t.corner[2].x};
    const auto [ay, by, cy] = std::array{t.corner[0].y, t.corner[1].y, t.corner[2].y};
    t.x0 = first_texel(std::min({ax, bx, cx}), target.width);
    t.x1 = first_texel(std::max({ax, bx, cx}), target.width);
    t.y0 = first_texel(std::min({ay, by, cy}), target.height);
    t.y1 = first_texel(std::max({ay, by, cy}), target.height);
    if (t.x0 >= t.x1 || t.y0 >= t.y1) return;
    const double area = edge_function(t.corner[0], t.corner[1], t.corner[2]);
    if (!(area != 0.0) || !std::isfinite(area) || area * away > 0.0) return;
    if (area < 0.0) {
        std::swap(t.corner[1], t.corner[2]);
        std::swap(t.of_mesh[0], t.of_mesh[2]);
    }
    t.plane = plane;
    t.facet = facet;
    out.push_back(t);
}

/// Depth over texels as a plane: the screen image of the triangle's own plane, found without dividing by w, so that
/// corners behind the eye do no harm. `corner`: (x w, y w, depth w, w) in texels. False for a triangle seen edge on.
bool depth_plane(const std::array<dvec4, 3>& corner, dvec3& plane) {
    const dvec3 a(corner[0].x, corner[0].y, corner[0].w), b(corner[1].x, corner[1].y, corner[1].w),
        c(corner[2].x, corner[2].y, corner[2].w);
    const double det = glm::dot(a, glm::cross(b, c));
    plane = (glm::cross(b, c) * corner[0].z + glm::cross(c, a) * corner[1].z + glm::cross(a, b) * corner[2].z) / det;
    return std::isfinite(plane.x) && std::isfinite(plane.y) && std::isfinite(plane.z);
}

/// Cuts the triangle at the near plane (depth <= 1) and appends what is left, as one triangle or two.
void append_clipped(const std::array<dvec4, 3>& corner, Index facet, const Target& target, double away,
                    std::vector<ScreenTriangle>& out) {
    std::array<double, 3> inside;
    int kept = 0;
    for (int i = 0; i < 3; ++i) kept += (inside[i] = corner[i].w - corner[i].z) >= 0.0;
    dvec3 plane;
    if (kept == 0 || !depth_plane(corner, plane)) return;
    std::array<dvec3, 4> polygon;
    std::array<bool, 4> of_mesh;  // the edge from each corner to the next
    int count = 0;
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3;
        const dvec3 p(corner[i].x, corner[i].y, corner[i].w), q(corner[j].x, corner[j].y, corner[j].w);
        if (inside[i] >= 0.0) {
            of_mesh[count] = true;
            polygon[count++] = p;
        }
        if ((inside[i] >= 0.0) != (inside[j] >= 0.0)) {
            of_mesh[count] = inside[i] < 0.0;
            polygon[count++] = glm::mix(p, q, inside[i] / (inside[i] - inside[j]));
        }
    }
    for (int i = 2; i < count; ++i)
        append_screen_triangle({polygon[0], polygon[i - 1], polygon[i]}, plane, facet, target, away,
                               {i == 2 && of_mesh[0], of_mesh[i - 1], i + 1 == count && of_mesh[i]}, out);
}

/// A share of the work: triangles begin .. end of a mesh.
struct Block {
    const DepthMesh* mesh;
    std::size_t begin, end;
};

std::vector<Block> divide(In<DepthMesh> meshes) {
    std::vector<Block> blocks;
    for (const auto& mesh : meshes) {
        const std::size_t count = mesh.triangles.size();
        for (std::size_t begin = 0; begin < count; begin += block_triangles)
            blocks.push_back({&mesh, begin, std::min(begin + block_triangles, count)});
    }
    return blocks;
}

void append_triangles(const Block& block, const Target& target, std::vector<ScreenTriangle>& out) {
    const DepthMesh& mesh = *block.mesh;
    // Pixels of homogeneous points: (x / w * .5 + .5) * size, kept homogeneous.
    dmat4 to_texels(1.0);
    to_texels[0][0] = to_texels[3][0] = 0.5 * target.width;
    to_texels[1][1] = to_texels[3][1] = 0.5 * target.height;
    const dmat4 matrix = to_texels * target.view_to_depth_clip * mesh.object_to_view;
    const double away = away_sign(mesh);
    for (std::size_t i = block.begin; i < block.end; ++i) {
        std::array<dvec4, 3> corner;
        for (int k = 0; k < 3; ++k) corner[k] = matrix * dvec4(mesh.positions[mesh.triangles[i][k]], 1.0);
        append_clipped(corner, mesh.facet_base + mesh.triangle_facet[i], target, away, out);
    }
}

/// True where `depth` of `facet` is in front of what the texel shows.
bool in_front(float depth, Index facet, const DepthTexel& texel) {
    return texel.facet == none || depth > texel.depth || (depth == texel.depth && facet < texel.facet);
}

/// Slopes of triangles seen almost edge on stay finite.
float slope(double value) {
    return static_cast<float>(std::clamp(value, -double(max_depth_slope), double(max_depth_slope)));
}

bool covers(const ScreenTriangle& t, dvec2 p) {
    for (int i = 0; i < 3; ++i)
        if (edge_function(t.corner[i], t.corner[(i + 1) % 3], p) < 0.0) return false;
    return true;
}

/// An edge of a triangle along a row of texels.
struct RowEdge {
    int along;            ///< its code without the distance
    double inside, step;  ///< distance inside at texel 0, and its change from texel to texel

    /// What is no edge of the mesh cuts nothing off.
    RowEdge(dvec2 a, dvec2 b, int y, bool of_mesh) {
        const dvec2 way = b - a, inwards(-way.y, way.x);
        const double length = std::abs(way.x) + std::abs(way.y), unit = length > 0.0 && of_mesh ? 1.0 / length : 0.0;
        along = edge_code({0.0f, float(inwards.x * unit), float(inwards.y * unit)});
        inside = glm::dot(inwards, dvec2(0.5, y + 0.5) - a) * unit;
        step = inwards.x * unit;
    }
    int code(int x) const { return edge_code(along, float(inside + step * x)); }
};

void draw_row(const ScreenTriangle& t, int y, DepthBuffer& buffer) {
    // The part of the row inside all three edges, a texel or two wider for rounding: texels near its ends are tested.
    constexpr int unsure = 4;
    double left = t.x0, right = t.x1;
    for (int i = 0; i < 3; ++i) {
        const dvec2 a = t.corner[i], b = t.corner[(i + 1) % 3];
        if (a.y == b.y) continue;
        const double x = a.x + (b.x - a.x) * ((y + 0.5 - a.y) / (b.y - a.y)) - 0.5;
        if (a.y > b.y)
            left = std::max(left, std::floor(x) - 1.0);
        else
            right = std::min(right, std::ceil(x) + 2.0);
    }
    const int x0 = static_cast<int>(std::min(left, double(t.x1))), x1 = static_cast<int>(std::max(right, double(t.x0)));
    const DepthTexel plane{0.0f, slope(t.plane.x * buffer.scale), slope(t.plane.y * buffer.scale), t.facet, {}};
    const RowEdge first(t.corner[0], t.corner[1], y, t.of_mesh[0]), second(t.corner[1], t.corner[2], y, t.of_mesh[1]),
        third(t.corner[2], t.corner[0], y, t.of_mesh[2]);
    const double depth_y = t.plane.y * (y + 0.5) + t.plane.z;
    DepthTexel* row = &buffer.texels[std::size_t(y) * buffer.width];
    for (int x = x0; x < x1; ++x) {
        const float depth = static_cast<float>(t.plane.x * (x + 0.5) + depth_y);
        if (!in_front(depth, t.facet, row[x])) continue;
        if ((x < x0 + unsure || x >= x1 - unsure) && !covers(t, dvec2(x + 0.5, y + 0.5))) continue;
        row[x] = plane;
        row[x].depth = depth;
        row[x].edges = pack_edges(first.code(x), second.code(x), third.code(x));
    }
}

/// Bands of rows that each triangle touches, as rows of triangle numbers in drawing order.
Rows bin_triangles(const std::vector<ScreenTriangle>& triangles, int bands, Array<Index>& members) {
    Rows rows;
    rows.offsets.assign(bands, 0);
    for (const auto& t : triangles)
        for (int b = t.y0 / band_rows; b <= (t.y1 - 1) / band_rows; ++b) ++rows.offsets[b];
    counts_to_offsets(rows.offsets);
    members.resize(rows.offsets.back());
    Array<Index> next(rows.offsets.begin(), rows.offsets.end() - 1);
    for (Index i = 0; i < triangles.size(); ++i)
        for (int b = triangles[i].y0 / band_rows; b <= (triangles[i].y1 - 1) / band_rows; ++b) members[next[b]++] = i;
    return rows;
}

void draw_triangles(const std::vector<ScreenTriangle>& triangles, DepthBuffer& buffer) {
    Array<Index> members;
    const int bands = (buffer.height + band_rows - 1) / band_rows;
    const Rows rows = bin_triangles(triangles, bands, members);
    parallel_for(bands, [&](std::size_t band) {
        const int begin = int(band) * band_rows, end = std::min(begin + band_rows, buffer.height);
        for (Index m = rows.begin(Index(band)); m < rows.end(Index(band)); ++m) {
            const ScreenTriangle& t = triangles[members[m]];
            for (int y = std::max(begin, t.y0); y < std::min(end, t.y1); ++y) draw_row(t, y, buffer);
        }
    }, 1);
}

void check_mesh(const DepthMesh& mesh, std::size_t number) {
    const std::string name = "depth mesh " + std::to_string(number) + ": ";
    check(mesh.triangles.size() == mesh.triangle_facet.size(), name + "one facet per triangle expected");
    Index highest = 0;
    for (const auto& t : mesh.triangles) highest = std::max({highest, t.x, t.y, t.z});
    check(mesh.triangles.empty() || highest < mesh.positions.size(), name + "triangle refers to a missing vertex");
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

dmat4 view_to_depth_clip(const View& view, const DepthBuffer& layout) {
    dmat4 matrix = view.view_to_clip;
    const double range = view.far_clip - view.near_clip;
    // Third row: depth times w. Perspective: near / -z times -z. Orthographic: (far + z) / (far - near).
    const dvec4 row = view.orthographic ? dvec4(0.0, 0.0, 1.0 / range, view.far_clip / range)
                                        : dvec4(0.0, 0.0, 0.0, view.near_clip);
    // From the frame to the buffer: its share of the buffer, and how far their middles are apart.
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

std::vector<Occluder> occluders(const Scene& scene, const View& view, double margin) {
    std::vector<Occluder> result;
    for (Index i = 0; i < scene.placements.size(); ++i) {
        const Placement& placement = scene.placements[i];
        if ((placement.usage & usage_occlude) && placement.surface->occluding_triangles > 0 &&
            in_frame(placement, view, margin)) {
            const Sphere sphere = bounding_sphere(placement, view);
            const bool beyond_near = -sphere.center.z - sphere.radius > view.near_clip;
            result.push_back({i, view.world_to_view * placement.object_to_world,
                              beyond_near && bodies_of(*placement.surface)->all_outward});
        }
    }
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

std::vector<DepthMesh> depth_meshes(const Scene& scene, const View& view, double margin) {
    std::vector<DepthMesh> meshes;
    for (const Occluder& occluder : occluders(scene, view, margin)) {
        const Surface& surface = *scene.placements[occluder.placement].surface;
        meshes.push_back({surface.positions, In<glm::uvec3>(surface.triangles).first(surface.occluding_triangles),
                          In<Index>(surface.triangle_facet).first(surface.occluding_triangles),
                          occluder.object_to_view, scene.facet_base[occluder.placement], occluder.solid});
    }
    return meshes;
}

DepthBuffer draw_depth(const View& view, In<DepthMesh> meshes, const DepthOptions& options, const Cancel* cancel) {
    return draw_depth_into(depth_layout(view, options), view, meshes, cancel);
}

DepthBuffer draw_depth_into(DepthBuffer buffer, const View& view, In<DepthMesh> meshes, const Cancel* cancel) {
    for (std::size_t m = 0; m < meshes.size(); ++m) check_mesh(meshes[m], m);
    buffer.texels.resize(std::size_t(buffer.width) * buffer.height);
    parallel_blocks(buffer.texels.size(), std::size_t(1) << 18, [&](auto, std::size_t begin, std::size_t end) {
        std::fill(buffer.texels.begin() + begin, buffer.texels.begin() + end, DepthTexel());
    });
    const Target target{buffer.width, buffer.height, view_to_depth_clip(view, buffer)};
    const std::vector<Block> blocks = divide(meshes);
    // Groups bound the memory; their order, and the order inside, is that of the input.
    for (std::size_t start = 0; start < blocks.size(); start += group_blocks) {
        if (cancel) cancel->poll();
        std::vector<std::vector<ScreenTriangle>> parts(std::min(group_blocks, blocks.size() - start));
        parallel_for(parts.size(), [&](std::size_t i) { append_triangles(blocks[start + i], target, parts[i]); }, 1);
        std::vector<ScreenTriangle> triangles;
        for (const auto& part : parts) triangles.insert(triangles.end(), part.begin(), part.end());
        draw_triangles(triangles, buffer);
    }
    return buffer;
}

}  // namespace fovea
