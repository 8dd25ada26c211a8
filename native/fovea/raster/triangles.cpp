// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/raster/triangles.h>

#include <algorithm>
#include <string>

#include <fovea/base/check.h>

namespace fovea::raster {
namespace {

constexpr std::size_t block_triangles = 2048;
constexpr std::size_t group_blocks = 128, group_triangles = 65536;

/// Sign of the screen-space area of back-facing triangles. A mirroring transform flips it.
double away_sign(const RasterMesh& mesh) { return glm::determinant(dmat3(mesh.object_to_view)) < 0.0 ? 1.0 : -1.0; }

/// Twice the signed area of (a, b, p). Antisymmetric in a and b without rounding differences.
double edge_function(dvec2 a, dvec2 b, dvec2 p) {
    const bool swapped = b.x < a.x || (b.x == a.x && b.y < a.y);
    if (swapped) std::swap(a, b);
    const double area = (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
    return swapped ? -area : area;
}

/// First texel whose center is at or above `edge`, clamped to [0, size].
int first_texel(double edge, int size) {
    const double center = std::clamp(edge - 0.5, 0.0, double(size));
    const int below = static_cast<int>(center);
    return below + (below < center);
}

/// Homogeneous image coordinates of a corner.
dvec3 without_depth(const dvec4& corner) { return {corner.x, corner.y, corner.w}; }

/// Depth as a linear function of texel coordinates, solved in homogeneous coordinates without dividing by w, so that
/// corners behind the eye are allowed. `corner`: (x w, y w, depth w, w) in texels. False if the triangle is seen
/// edge-on.
bool depth_plane(const std::array<dvec4, 3>& corner, dvec3& plane) {
    const dvec3 a = without_depth(corner[0]), b = without_depth(corner[1]), c = without_depth(corner[2]);
    const double det = glm::dot(a, glm::cross(b, c));
    plane = (glm::cross(b, c) * corner[0].z + glm::cross(c, a) * corner[1].z + glm::cross(a, b) * corner[2].z) / det;
    return std::isfinite(plane.x) && std::isfinite(plane.y) && std::isfinite(plane.z);
}

dvec2 in_texels(const dvec4& corner) { return dvec2(corner) / corner.w; }

/// RasterTriangle::few. As `covers`, without branches: which of them would be taken is hard to foretell.
std::uint8_t covered_few(const RasterTriangle& t) {
    dvec2 start[3], way[3];
    double sign[3];
    for (int i = 0; i < 3; ++i) {
        const dvec2 a = t.corner[i], b = t.corner[(i + 1) % 3];
        const bool swapped = (b.x < a.x) | ((b.x == a.x) & (b.y < a.y));
        start[i] = {swapped ? b.x : a.x, swapped ? b.y : a.y};
        way[i] = {std::abs(b.x - a.x), swapped ? a.y - b.y : b.y - a.y};
        sign[i] = swapped ? -1.0 : 1.0;
    }
    unsigned bits = 0, next = 1;
    for (int y = t.y0; y < t.y1; ++y)
        for (int x = t.x0; x < t.x1; ++x, next <<= 1) {
            unsigned covered = next;
            for (int i = 0; i < 3; ++i) {
                const double px = x + 0.5 - start[i].x, py = y + 0.5 - start[i].y;
                covered &= sign[i] * (way[i].x * py - way[i].y * px) < 0.0 ? 0u : next;
            }
            bits |= covered;
        }
    return static_cast<std::uint8_t>(bits);
}

/// Sets the place of a triangle with these corners, in texels, after clipping. False if it covers no texel
/// center, which of large ones is not always known. `away`: sign of the area of triangles to cull; 0: none.
bool place_on_screen(const std::array<dvec2, 3>& corner, const RasterTarget& target, double away,
                     const std::array<bool, 3>& of_mesh, RasterTriangle& t) {
    const double area = edge_function(corner[0], corner[1], corner[2]);
    if (!(area != 0.0) || !std::isfinite(area) || area * away > 0.0) return false;
    t.x0 = first_texel(std::min({corner[0].x, corner[1].x, corner[2].x}), target.width);
    t.x1 = first_texel(std::max({corner[0].x, corner[1].x, corner[2].x}), target.width);
    if (t.x0 >= t.x1) return false;
    t.y0 = first_texel(std::min({corner[0].y, corner[1].y, corner[2].y}), target.height);
    t.y1 = first_texel(std::max({corner[0].y, corner[1].y, corner[2].y}), target.height);
    if (t.y0 >= t.y1) return false;
    t.corner = corner;
    t.of_mesh = of_mesh;
    if (area < 0.0) {
        std::swap(t.corner[1], t.corner[2]);
        std::swap(t.of_mesh[0], t.of_mesh[2]);
    }
    t.few = (t.x1 - t.x0) * (t.y1 - t.y0) <= RasterTriangle::most_of_few ? covered_few(t) : 0;
    return t.few != 0 || (t.x1 - t.x0) * (t.y1 - t.y0) > RasterTriangle::most_of_few;
}

/// Where the triangles of a block go.
struct Placed {
    const std::function<void(const RasterTriangle&)>& draw_few;  ///< may be empty: all are appended
    Array<RasterTriangle> triangles;

    /// Takes a triangle that is on the screen. `source`: its corners before clipping, (x w, y w, depth w, w) in texels.
    void take(RasterTriangle& t, const std::array<dvec4, 3>& source) {
        if (!depth_plane(source, t.plane)) return;
        if (t.few && draw_few)
            draw_few(t);
        else
            triangles.push_back(t);
    }
};

/// A corner of a clipped triangle.
struct Corner {
    dvec4 place;                   ///< homogeneous
    std::array<double, 2> inside;  ///< how far beyond the near plane (w - depth w), and behind the section plane
    bool of_mesh;                  ///< whether the edge to the next corner is the mesh's
};

struct Polygon {
    std::array<Corner, 5> corner;
    int count = 0;
};

/// Sutherland & Hodgman, "Reentrant Polygon Clipping", CACM 1974, for one plane.
Polygon clipped(const Polygon& whole, int plane) {
    Polygon kept;
    for (int i = 0; i < whole.count; ++i) {
        const Corner &a = whole.corner[i], &b = whole.corner[(i + 1) % whole.count];
        const double of_a = a.inside[plane], of_b = b.inside[plane];
        if (of_a >= 0.0) kept.corner[kept.count++] = a;
        if ((of_a >= 0.0) == (of_b >= 0.0)) continue;
        const double t = of_a / (of_a - of_b);
        Corner& cut = kept.corner[kept.count++];
        cut = {glm::mix(a.place, b.place, t), {}, a.of_mesh && of_a < 0.0};
        for (int k = 0; k < 2; ++k) cut.inside[k] = k == plane ? 0.0 : glm::mix(a.inside[k], b.inside[k], t);
    }
    return kept;
}

/// Appends what both planes leave of a triangle, at most three triangles. `placed`: its mesh and number.
void append_clipped(const std::array<Corner, 3>& whole, const RasterTarget& target, double away, RasterTriangle placed,
                    Placed& out) {
    for (int plane = 0; plane < 2; ++plane)
        if (std::all_of(whole.begin(), whole.end(), [&](const Corner& c) { return !(c.inside[plane] >= 0.0); })) return;
    const Polygon polygon = clipped(clipped({{whole[0], whole[1], whole[2]}, 3}, 0), 1);
    const auto texel = [&](int i) { return in_texels(polygon.corner[i].place); };
    const auto of_mesh = [&](int i) { return polygon.corner[i].of_mesh; };
    for (int i = 2; i < polygon.count; ++i)
        if (place_on_screen({texel(0), texel(i - 1), texel(i)}, target, away,
                            {i == 2 && of_mesh(0), of_mesh(i - 1), i + 1 == polygon.count && of_mesh(i)}, placed))
            out.take(placed, {whole[0].place, whole[1].place, whole[2].place});
}

/// Unit of work: triangles [begin, end) of one mesh.
struct Block {
    Index mesh;
    std::size_t begin, end;
};

std::vector<Block> divide(In<RasterMesh> meshes) {
    std::vector<Block> blocks;
    for (Index m = 0; m < meshes.size(); ++m) {
        const std::size_t count = meshes[m].triangles.size();
        for (std::size_t begin = 0; begin < count; begin += block_triangles)
            blocks.push_back({m, begin, std::min(begin + block_triangles, count)});
    }
    return blocks;
}

std::string name_of(Index mesh) { return "depth mesh " + std::to_string(mesh) + ": "; }

void check_vertices(const RasterMesh& mesh, const Block& block) {
    Index highest = 0;
    for (const auto& t : mesh.triangles.subspan(block.begin, block.end - block.begin))
        highest = std::max({highest, t.x, t.y, t.z});
    check(highest < mesh.positions.size(), name_of(block.mesh) + "triangle refers to a missing vertex");
}

/// Maps vertices of a mesh to texels, still homogeneous: (x / w * .5 + .5) * size.
dmat4 to_texels(const RasterMesh& mesh, const RasterTarget& target) {
    dmat4 of_clip(1.0);
    of_clip[0][0] = of_clip[3][0] = 0.5 * target.width;
    of_clip[1][1] = of_clip[3][1] = 0.5 * target.height;
    return of_clip * target.view_to_clip * mesh.object_to_view;
}

Corner corner_of(const RasterMesh& mesh, const dmat4& to_texels, Index vertex) {
    const dvec4 point(mesh.positions[vertex], 1.0), place = to_texels * point;
    return {place, {place.w - place.z, mesh.cut ? -glm::dot(*mesh.cut, point) : 0.0}, true};
}

/// A vertex in texels; not a number where one of the planes cuts it off.
dvec2 texel_of(const Corner& corner) {
    return corner.inside[0] >= 0.0 && corner.inside[1] >= 0.0 ? in_texels(corner.place) : dvec2(std::nan(""));
}

/// All vertices of a mesh in texels, which is worth it where its triangles use most of them more than once.
Array<dvec2> vertices_in_texels(const RasterMesh& mesh, const RasterTarget& target) {
    Array<dvec2> texels;
    if (mesh.positions.size() > 2 * mesh.triangles.size()) return texels;
    texels.resize(mesh.positions.size());
    const dmat4 map = to_texels(mesh, target);
    parallel_for(texels.size(), 4096, [&](std::size_t i) { texels[i] = texel_of(corner_of(mesh, map, Index(i))); });
    return texels;
}

/// Whether a triangle in texels is turned away for certain, with sides up to `reach`: twice its area has an error far
/// below the bound. `away`: sign of the area of triangles to cull; 0: none.
bool surely_away(double area, double away, double reach) { return area * away > 1e-12 * reach * reach; }

/// `texels`: of the mesh's vertices; empty: they are computed as they are asked for.
void place_triangles(const RasterMesh& mesh, const Block& block, const RasterTarget& target, In<dvec2> texels,
                     Placed& out) {
    check_vertices(mesh, block);
    const dmat4 map = to_texels(mesh, target);
    const double away = away_sign(mesh);
    for (std::size_t i = block.begin; i < block.end; ++i) {
        const glm::uvec3& of = mesh.triangles[i];
        const double cull = i < mesh.one_sided_from ? 0.0 : away;
        const auto texel = [&](int k) {
            return texels.empty() ? texel_of(corner_of(mesh, map, of[k])) : texels[of[k]];
        };
        const std::array<dvec2, 3> corner{texel(0), texel(1), texel(2)};
        const dvec2 first = corner[1] - corner[0], second = corner[2] - corner[0];
        const double area = first.x * second.y - first.y * second.x;
        if (surely_away(area, cull, std::abs(first.x) + std::abs(first.y) + std::abs(second.x) + std::abs(second.y)))
            continue;
        RasterTriangle placed;
        const bool whole = !std::isnan(corner[0].x) && !std::isnan(corner[1].x) && !std::isnan(corner[2].x);
        if (whole && !place_on_screen(corner, target, cull, {true, true, true}, placed)) continue;
        placed.mesh = block.mesh;
        placed.triangle = static_cast<Index>(i);
        const std::array<Corner, 3> corners{corner_of(mesh, map, of.x), corner_of(mesh, map, of.y),
                                            corner_of(mesh, map, of.z)};
        if (whole)
            out.take(placed, {corners[0].place, corners[1].place, corners[2].place});
        else
            append_clipped(corners, target, cull, placed, out);
    }
}

/// Vertices of those meshes of a group of blocks that consist of several blocks, in texels.
class GroupVertices {
   public:
    GroupVertices(In<RasterMesh> meshes, const RasterTarget& target) : meshes_(meshes), target_(target) {}

    /// To the next group; a mesh that goes on in it is not computed again.
    void go_on_to(In<Block> group) {
        std::vector<Array<dvec2>> next(group.back().mesh - group.front().mesh + 1);
        if (!texels_.empty() && first_ + texels_.size() - 1 == group.front().mesh) next[0] = std::move(texels_.back());
        first_ = group.front().mesh;
        texels_ = std::move(next);
        for (std::size_t i = 0; i < texels_.size(); ++i)
            if (texels_[i].empty() && meshes_[first_ + i].triangles.size() > block_triangles)
                texels_[i] = vertices_in_texels(meshes_[first_ + i], target_);
    }
    /// Empty for others.
    In<dvec2> of(Index mesh) const { return texels_[mesh - first_]; }

   private:
    In<RasterMesh> meshes_;
    const RasterTarget& target_;
    Index first_ = 0;
    std::vector<Array<dvec2>> texels_;
};

/// Screen triangles of a block, and per band of rows the indices of those in it, in mesh order.
struct Binned {
    Array<RasterTriangle> triangles;
    Lists<Index> bands;
};

Binned bin(Array<RasterTriangle> triangles, int bands) {
    Binned binned{std::move(triangles), {}};
    binned.bands = lists_of<Index>(bands, [&](const auto& give) {
        for (Index i = 0; i < binned.triangles.size(); ++i) {
            const int first = binned.triangles[i].y0 / raster_band_rows;
            const int last = (binned.triangles[i].y1 - 1) / raster_band_rows;
            for (int band = first; band <= last; ++band) give(band, i);
        }
    });
    return binned;
}

}  // namespace

bool RasterTriangle::covers(dvec2 p) const {
    for (int i = 0; i < 3; ++i)
        if (edge_function(corner[i], corner[(i + 1) % 3], p) < 0.0) return false;
    return true;
}

TriangleRows::TriangleRows(const RasterTriangle& t) : triangle_(t) {
    left_.fill({-HUGE_VAL, 0.0});
    right_.fill({HUGE_VAL, 0.0});
    int lefts = 0, rights = 0;
    double reach = 1.0;
    for (int i = 0; i < 3; ++i) {
        const dvec2 a = t.corner[i], b = t.corner[(i + 1) % 3];
        reach = std::max({reach, std::abs(a.x), std::abs(a.y)});
        if (a.y == b.y) continue;
        const double step = (b.x - a.x) / (b.y - a.y);
        const Side side{a.x - 0.5 + step * (0.5 - a.y), step};
        if (!std::isfinite(side.at)) {  // an almost horizontal edge: the slope overflows
            unsure_ = HUGE_VAL;
            continue;
        }
        reach = std::max(reach, std::abs(side.at));
        (a.y > b.y ? left_[lefts++] : right_[rights++]) = side;
    }
    unsure_ = std::max(unsure_, 1e-9 * reach);  // far above the rounding error of a crossing
}

TriangleRows::Texels TriangleRows::covered(int y) const {
    const auto in_box = [&](double x) { return std::clamp(x, double(triangle_.x0), double(triangle_.x1)); };
    const auto from = [&](double x) {  // ceil of x, clamped to the box
        const double edge = in_box(x);
        const int whole = static_cast<int>(edge);
        return whole + (whole < edge);
    };
    const auto up_to = [&](double x) { return static_cast<int>(in_box(x + 1.0)); };
    const double left = std::max(left_[0].at + left_[0].step * y, left_[1].at + left_[1].step * y);
    const double right = std::min(right_[0].at + right_[0].step * y, right_[1].at + right_[1].step * y);
    int begin = from(left - unsure_), end = up_to(right + unsure_);
    const int sure_begin = from(left + unsure_), sure_end = up_to(right - unsure_);
    const auto covers = [&](int x) { return triangle_.covers(dvec2(x + 0.5, y + 0.5)); };
    while (begin < std::min(sure_begin, end) && !covers(begin)) ++begin;
    while (end > std::max(sure_end, begin) && !covers(end - 1)) --end;
    return {begin, end};
}

void draw_triangles(const RasterTarget& target, In<RasterMesh> meshes, const Cancel* cancel,
                    const std::function<void(const RasterTriangle&, int, int)>& draw,
                    const std::function<void(const RasterTriangle&)>& draw_few) {
    for (Index m = 0; m < meshes.size(); ++m)
        check(meshes[m].triangles.size() == meshes[m].triangle_facet.size(),
              name_of(m) + "one facet per triangle expected");
    const std::vector<Block> blocks = divide(meshes);
    const int bands = (target.height + raster_band_rows - 1) / raster_band_rows;
    GroupVertices vertices(meshes, target);
    // Groups bound the memory. Groups, and the triangles in them, are processed in input order.
    for (std::size_t start = 0, stop = 0; start < blocks.size(); start = stop) {
        if (cancel) cancel->poll();
        for (std::size_t count = 0; stop < std::min(blocks.size(), start + group_blocks) && count < group_triangles;)
            count += blocks[stop].end - blocks[stop].begin, ++stop;
        const In<Block> group = In<Block>(blocks).subspan(start, stop - start);
        vertices.go_on_to(group);
        std::vector<Binned> binned(group.size());
        parallel_for(group.size(), 1, [&](std::size_t i) {
            const RasterMesh& mesh = meshes[group[i].mesh];
            const bool whole = group[i].end - group[i].begin == mesh.triangles.size();
            const Array<dvec2> own = whole ? vertices_in_texels(mesh, target) : Array<dvec2>();
            Placed placed{draw_few, {}};
            place_triangles(mesh, group[i], target, whole ? In<dvec2>(own) : vertices.of(group[i].mesh), placed);
            binned[i] = bin(std::move(placed.triangles), bands);
        });
        parallel_for(bands, 1, [&](std::size_t band) {
            const int begin = int(band) * raster_band_rows, end = std::min(begin + raster_band_rows, target.height);
            for (const Binned& part : binned)
                for (const Index member : part.bands[Index(band)]) {
                    const RasterTriangle& t = part.triangles[member];
                    draw(t, std::max(begin, t.y0), std::min(end, t.y1));
                }
        });
    }
}

}  // namespace fovea::raster
