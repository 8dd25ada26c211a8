// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/raster/triangles.h>

#include <algorithm>
#include <bit>
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

/// Texels from which on a triangle's box is not looked through for one that it covers.
constexpr int few_texels = 8;

bool covers_any(const RasterTriangle& t) {
    for (int y = t.y0; y < t.y1; ++y)
        for (int x = t.x0; x < t.x1; ++x)
            if (t.covers(dvec2(x + 0.5, y + 0.5))) return true;
    return false;
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
    return (t.x1 - t.x0) * (t.y1 - t.y0) >= few_texels || covers_any(t);
}

/// Appends a triangle that is placed. `source`: its corners before clipping, (x w, y w, depth w, w) in texels.
void append(RasterTriangle& placed, const std::array<dvec4, 3>& source, Array<RasterTriangle>& out) {
    if (depth_plane(source, placed.plane)) out.push_back(placed);
}

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
                    Array<RasterTriangle>& out) {
    const Polygon polygon = clipped(clipped({{whole[0], whole[1], whole[2]}, 3}, 0), 1);
    const auto texel = [&](int i) { return in_texels(polygon.corner[i].place); };
    const auto of_mesh = [&](int i) { return polygon.corner[i].of_mesh; };
    for (int i = 2; i < polygon.count; ++i)
        if (place_on_screen({texel(0), texel(i - 1), texel(i)}, target, away,
                            {i == 2 && of_mesh(0), of_mesh(i - 1), i + 1 == polygon.count && of_mesh(i)}, placed))
            append(placed, {whole[0].place, whole[1].place, whole[2].place}, out);
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

/// Vertices of a mesh in texels. Most are asked for again soon, and are not computed again then.
class Vertices {
   public:
    /// `asks`: how often vertices will be asked for.
    Vertices(const RasterMesh& mesh, const dmat4& to_texels, std::size_t asks)
        : mesh_(mesh), to_texels_(to_texels), last_(std::bit_floor(std::min(most, asks)) - 1) {
        for (std::size_t i = 0; i <= last_; ++i) kept_[i].vertex = none;
    }

    struct Kept {
        Index vertex;
        std::array<double, 2> inside;  ///< Corner::inside; not negative where it is kept
        dvec2 texel;
        dvec4 place;  ///< homogeneous
    };

    const Kept& at(Index vertex) {
        Kept& kept = kept_[vertex & last_];
        if (kept.vertex != vertex) {
            const dvec4 point(mesh_.positions[vertex], 1.0), place = to_texels_ * point;
            kept = {
                vertex, {place.w - place.z, mesh_.cut ? -glm::dot(*mesh_.cut, point) : 0.0}, in_texels(place), place};
        }
        return kept;
    }

   private:
    static constexpr std::size_t most = 512;
    const RasterMesh& mesh_;
    dmat4 to_texels_;
    std::size_t last_;
    std::array<Kept, most> kept_;  // by the last digits of their indices
};

void append_triangles(In<RasterMesh> meshes, const Block& block, const RasterTarget& target,
                      Array<RasterTriangle>& out) {
    const RasterMesh& mesh = meshes[block.mesh];
    check_vertices(mesh, block);
    // Maps to texels, still homogeneous: (x / w * .5 + .5) * size.
    dmat4 to_texels(1.0);
    to_texels[0][0] = to_texels[3][0] = 0.5 * target.width;
    to_texels[1][1] = to_texels[3][1] = 0.5 * target.height;
    Vertices vertices(mesh, to_texels * target.view_to_clip * mesh.object_to_view, 3 * (block.end - block.begin));
    const double away = away_sign(mesh);
    for (std::size_t i = block.begin; i < block.end; ++i) {
        const glm::uvec3& of = mesh.triangles[i];
        std::array<dvec2, 3> texel;
        int kept = 0, of_plane[2] = {0, 0};  // corners that both planes keep, and that each does
        for (int k = 0; k < 3; ++k) {
            const Vertices::Kept& vertex = vertices.at(of[k]);
            const bool beyond = vertex.inside[0] >= 0.0, behind = vertex.inside[1] >= 0.0;
            of_plane[0] += beyond;
            of_plane[1] += behind;
            kept += beyond && behind;
            texel[k] = vertex.texel;
        }
        const double cull = i < mesh.one_sided_from ? 0.0 : away;
        RasterTriangle placed;
        if (of_plane[0] == 0 || of_plane[1] == 0 ||
            (kept == 3 && !place_on_screen(texel, target, cull, {true, true, true}, placed)))
            continue;
        placed.mesh = block.mesh;
        placed.triangle = static_cast<Index>(i);
        const auto corner = [&](int k) {
            const Vertices::Kept& vertex = vertices.at(of[k]);
            return Corner{vertex.place, vertex.inside, true};
        };
        const std::array<Corner, 3> corners{corner(0), corner(1), corner(2)};
        if (kept == 3)
            append(placed, {corners[0].place, corners[1].place, corners[2].place}, out);
        else
            append_clipped(corners, target, cull, placed, out);
    }
}

/// Screen triangles of a block, and per band of rows the indices of those in it, in mesh order.
struct Binned {
    Array<RasterTriangle> triangles;
    Lists<Index> bands;
};

Binned bin_block(In<RasterMesh> meshes, const Block& block, const RasterTarget& target, int bands) {
    Binned binned;
    binned.triangles.reserve(block.end - block.begin);
    append_triangles(meshes, block, target, binned.triangles);
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
                    const std::function<void(const RasterTriangle&, int, int)>& draw) {
    for (Index m = 0; m < meshes.size(); ++m)
        check(meshes[m].triangles.size() == meshes[m].triangle_facet.size(),
              name_of(m) + "one facet per triangle expected");
    const std::vector<Block> blocks = divide(meshes);
    const int bands = (target.height + raster_band_rows - 1) / raster_band_rows;
    // Groups bound the memory. Groups, and the triangles in them, are processed in input order.
    for (std::size_t start = 0, stop = 0; start < blocks.size(); start = stop) {
        if (cancel) cancel->poll();
        for (std::size_t count = 0; stop < std::min(blocks.size(), start + group_blocks) && count < group_triangles;)
            count += blocks[stop].end - blocks[stop].begin, ++stop;
        std::vector<Binned> binned(stop - start);
        const auto bin = [&](std::size_t i) { binned[i] = bin_block(meshes, blocks[start + i], target, bands); };
        parallel_for(binned.size(), 1, bin);
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
