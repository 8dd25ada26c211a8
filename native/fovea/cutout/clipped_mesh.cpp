// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/cutout/clipped_mesh.h>

#include <algorithm>
#include <cmath>

#include <fovea/base/parallel.h>
#include <fovea/mesh/ears.h>

namespace fovea::cutout {
namespace {

constexpr double least_piece = 1e-3;  // texels; smaller pieces are left out

bool finite(const vec2& p) { return std::isfinite(p.x) && std::isfinite(p.y); }

/// The triangles of each polygon: those of larger polygons come with the mesh.
class Triangulation {
   public:
    explicit Triangulation(const MeshArrays& mesh) : mesh_(mesh), given_(mesh) {}

    std::vector<Corners> of(std::size_t polygon) const {
        const Index begin = mesh_.polygon_offsets[polygon], end = mesh_.polygon_offsets[polygon + 1];
        const auto corner = [&](Index vertex) {
            const auto corners = mesh_.corner_verts.begin();
            return Index(std::find(corners + begin, corners + end, int(vertex)) - corners);
        };
        std::vector<Corners> found;
        for (const Triangle& t : given_.of(polygon)) found.push_back({corner(t.x), corner(t.y), corner(t.z)});
        if (!found.empty()) return found;
        std::vector<vec3> outline;
        for (Index c = begin; c < end; ++c) outline.push_back(mesh_.positions[mesh_.corner_verts[c]]);
        if (std::all_of(outline.begin(), outline.end(), [](const vec3& p) { return std::isfinite(p.x + p.y + p.z); }))
            for (const Triangle& t : cut_ears(outline)) found.push_back({begin + t.x, begin + t.y, begin + t.z});
        return found;
    }

   private:
    const MeshArrays& mesh_;
    NgonTriangles given_;
};

/// Side of a texel in object space: the mean over the polygons of a cut.
double texel_side(const MeshArrays& mesh, const Triangulation& triangles, const Cut& cut, In<Index> polygons) {
    double area = 0.0, texels = 0.0;
    for (const Index f : polygons)
        for (const Corners& c : triangles.of(f)) {
            const auto p = [&](int i) { return dvec3(mesh.positions[mesh.corner_verts[c[i]]]); };
            const auto t = [&](int i) { return dvec2(cut.uvs[c[i]]) * dvec2(cut.opacity->width, cut.opacity->height); };
            area += glm::length(glm::cross(p(1) - p(0), p(2) - p(0)));
            texels += std::abs(cross(t(1) - t(0), t(2) - t(0)));
        }
    return texels > 0.0 ? std::sqrt(area / texels) : 0.0;
}

class Clipping {
   public:
    Clipping(ClippedMesh& made, const MeshArrays& mesh, const std::vector<Cut>& cuts, const CutOptions& options)
        : made_(made), mesh_(mesh), cuts_(cuts), options_(options), triangles_(mesh) {}

    void clip_with(std::size_t number) {
        const Cut& cut = cuts_[number];
        Array<Index> mine;
        vec2 low(HUGE_VALF), high(-HUGE_VALF);
        for (Index f = 0; f < made_.polygons.size(); ++f) {
            if (options_.cut_of_polygon[f] != int(number)) continue;
            const In<vec2> uvs(cut.uvs.data() + mesh_.polygon_offsets[f],
                               cut.uvs.data() + mesh_.polygon_offsets[f + 1]);
            if (uvs.size() < 3 || !std::all_of(uvs.begin(), uvs.end(), finite)) continue;
            for (const vec2& uv : uvs) {
                low = glm::min(low, uv);
                high = glm::max(high, uv);
            }
            mine.push_back(f);
        }
        if (mine.empty()) return;
        Opacity opacity = *cut.opacity;
        const auto halve = [&] { opacity = halved(opacity); };
        const auto can = [&] { return opacity.width > 1 || opacity.height > 1; };
        if (options_.px_per_unit > 0.0) {
            double px = texel_side(mesh_, triangles_, cut, mine) * options_.px_per_unit;
            for (; px < texel_px && px > 0.0 && can(); px *= 2.0) halve();
        }
        while (Outlines::nodes(opacity, low, high) > Outlines::most_nodes && can()) halve();
        if (Outlines::nodes(opacity, low, high) > Outlines::most_nodes) return;  // repeated too often: opaque
        made_.outlines[number].emplace(opacity, low, high);
        parallel_blocks(mine.size(), 64, [&](auto, std::size_t begin, std::size_t end) {
            std::vector<Index> scratch;
            for (std::size_t i = begin; i < end; ++i)
                made_.polygons[mine[i]] = clip_polygon(mine[i], cut, *made_.outlines[number], scratch);
        });
    }

   private:
    ClippedPolygon clip_polygon(Index f, const Cut& cut, const Outlines& outlines, std::vector<Index>& scratch) const {
        ClippedPolygon result;
        std::size_t whole = 0, nothing = 0;
        for (const Corners& c : triangles_.of(f)) {
            TextureTriangle triangle;
            for (int i = 0; i < 3; ++i) {
                triangle.corner[i] = outlines.point(cut.uvs[c[i]]);
                triangle.vertex[i] = Index(mesh_.corner_verts[c[i]]);
            }
            auto& [corners, clipped] = result.triangles.emplace_back(c, clip(triangle, outlines, scratch));
            std::erase_if(clipped.pieces, [&](const auto& piece) { return is_crumb(piece, outlines.texel()); });
            whole += clipped.what == Clipped::whole;
            nothing += clipped.what == Clipped::nothing;
        }
        const std::size_t all = result.triangles.size();
        result.what = whole == all ? Clipped::whole : nothing == all ? Clipped::nothing : Clipped::part;
        return result;
    }

    static bool is_crumb(const std::vector<PieceCorner>& piece, double texel) {
        double twice = 0.0;
        for (std::size_t i = 0; i < piece.size(); ++i)
            twice += cross(piece[i].place - piece[0].place, piece[(i + 1) % piece.size()].place - piece[0].place);
        return piece.size() < 3 || std::abs(twice) < 2.0 * least_piece * texel * texel;
    }

    ClippedMesh& made_;
    const MeshArrays& mesh_;
    const std::vector<Cut>& cuts_;
    const CutOptions& options_;
    Triangulation triangles_;
};

}  // namespace

ClippedMesh::ClippedMesh(const MeshArrays& mesh, const std::vector<Cut>& cuts, const CutOptions& options)
    : polygons(mesh.polygon_offsets.empty() ? 0 : mesh.polygon_offsets.size() - 1), outlines(cuts.size()) {
    Clipping clipping(*this, mesh, cuts, options);
    for (std::size_t i = 0; i < cuts.size(); ++i) clipping.clip_with(i);
}

}  // namespace fovea::cutout
