// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/runs/passes_behind.h>

#include <cmath>
#include <optional>
#include <tuple>

#include <fovea/runs/stretch_grid.h>

namespace fovea::runs {
namespace {

constexpr double reach_px = 2.0;  // extension of runs, to find the lines that hide them at their ends despite sampling
constexpr double direction_px = 3.0;  // to both sides, for directions: segments on dense meshes zigzag
constexpr double joint_px = 1e-3;     // tolerance at joints, so that no crossing is missed between two segments
constexpr double least_pixels = 8.0;  // minimum depth difference in pixels' size; rough outlines differ by less
constexpr double steepness = 16.0;    // added to it per pixel beyond the end of a run

/// Calls body(stretch) for the segments of a piece between two arc lengths.
template <typename Body>
void for_stretches(const ClippedPaths& clipped, Index piece, double start, double end, const Body& body) {
    const Index last = clipped.pieces.end(piece) - 1;
    for (Index i = clipped.segment_at(piece, start); i < last && clipped.arc_px[i] < end; ++i) {
        const double arc = clipped.arc_px[i], length = clipped.arc_px[i + 1] - arc;
        if (!(length > 0.0)) continue;
        const double from = std::max(0.0, (start - arc) / length), to = std::min(1.0, (end - arc) / length);
        const dvec2 a(clipped.px[i]), b(clipped.px[i + 1]);
        if (!std::isfinite(a.x + a.y + b.x + b.y)) continue;
        const float far = 0.5f * (clipped.position_view[i].z + clipped.position_view[i + 1].z);
        body(Stretch{vec2(glm::mix(a, b, from)), vec2(glm::mix(a, b, to)), i, -far});
    }
}

/// Whether a piece is of an image-space line, which neither hides nor is hidden.
bool in_image(const ClippedPaths& clipped, Index piece) {
    return clipped.depth[clipped.pieces.begin(piece)] >= before_all;
}

Array<Stretch> visible_stretches(const ClippedPaths& clipped, const Runs& runs) {
    return parallel_collect<Stretch>(runs.size(), runs_per_block, [&](std::size_t r, std::size_t last, auto& part) {
        for (; r < last; ++r)
            if (runs.invisibility[r] == 0 && !in_image(clipped, runs.piece[r]))
                for_stretches(clipped, runs.piece[r], runs.start_px[r], runs.end_px[r],
                              [&](const Stretch& stretch) { part.push_back(stretch); });
    });
}

/// A position on a segment, by its screen fraction.
struct OnPiece {
    Index point;
    double s;
};

/// Distance from the eye along the view axis.
double distance(const ClippedPaths& clipped, const OnPiece& at) {
    const double a = -clipped.position_view[at.point].z, b = -clipped.position_view[at.point + 1].z;
    return clipped.orthographic ? glm::mix(a, b, at.s) : 1.0 / glm::mix(1.0 / a, 1.0 / b, at.s);
}

/// Size of a pixel in space at a position of a segment.
double pixel_size(const ClippedPaths& clipped, const OnPiece& at) {
    const dvec3 a(clipped.position_view[at.point]), b(clipped.position_view[at.point + 1]);
    const double pixels = glm::length(dvec2(clipped.px[at.point + 1]) - dvec2(clipped.px[at.point]));
    if (clipped.orthographic) return glm::length(dvec2(b) - dvec2(a)) / pixels;
    return glm::length(dvec2(b) / b.z - dvec2(a) / a.z) / pixels * distance(clipped, at);
}

double arc_at(const ClippedPaths& clipped, const OnPiece& at) {
    return glm::mix(clipped.arc_px[at.point], clipped.arc_px[at.point + 1], at.s);
}

dvec2 direction(const ClippedPaths& clipped, Index piece, double arc) {
    return dvec2(clipped.place_px(piece, arc + direction_px)) - dvec2(clipped.place_px(piece, arc - direction_px));
}

/// The crossing of two stretches, as positions on the segment of each.
std::optional<std::pair<OnPiece, OnPiece>> crossing(const ClippedPaths& clipped, const Stretch& far,
                                                    const Stretch& near) {
    const dvec2 a(far.a), c(near.a), along = dvec2(far.b) - a, across = dvec2(near.b) - c;
    const double area = cross(along, across);
    const double t = cross(c - a, across) / area, u = cross(c - a, along) / area;
    // How far beyond the ends of the stretches their lines cross, in fractions of the stretches.
    const double beside_t = std::max({0.0, -t, t - 1.0}), beside_u = std::max({0.0, -u, u - 1.0});
    const bool meet = beside_t * beside_t * glm::dot(along, along) <= joint_px * joint_px &&
                      beside_u * beside_u * glm::dot(across, across) <= joint_px * joint_px;
    if (area == 0.0 || !meet) return {};
    const auto on_segment = [&](Index point, const dvec2& at) {
        const dvec2 start(clipped.px[point]), way = dvec2(clipped.px[point + 1]) - start;
        return OnPiece{point, std::clamp(glm::dot(at - start, way) / glm::dot(way, way), 0.0, 1.0)};
    };
    return std::pair(on_segment(far.point, a + t * along), on_segment(near.point, c + u * across));
}

/// Adds the crossings at which a run passes behind others on one of its stretches.
void find(const ClippedPaths& clipped, const Runs& runs, std::size_t run, const StretchGrid& grid, const Stretch& far,
          Array<PassBehind>& found) {
    const Index piece = runs.piece[run];
    grid.near(far.a, far.b, [&](const Stretch& near) {
        if (near.point == far.point) return;
        const auto places = crossing(clipped, far, near);
        if (!places) return;
        const auto& [behind, before] = *places;
        const double arc = arc_at(clipped, behind);
        const double beyond = std::max({0.0, runs.start_px[run] - arc, arc - runs.end_px[run]});
        const double farther = distance(clipped, behind) - distance(clipped, before);
        if (!(farther > (least_pixels + steepness * beyond) * pixel_size(clipped, behind))) return;
        const auto& offsets = clipped.pieces.offsets;
        const Index other = Index(std::upper_bound(offsets.begin(), offsets.end(), near.point) - offsets.begin()) - 1;
        const dvec2 way = direction(clipped, piece, arc), others = direction(clipped, other, arc_at(clipped, before));
        const double lengths = glm::length(way) * glm::length(others);
        found.push_back({piece, arc, lengths > 0.0 ? std::abs(cross(way, others)) / lengths : 1.0});
    });
}

}  // namespace

Array<PassBehind> passes_behind(const ClippedPaths& clipped, const Runs& runs, In<std::uint8_t> wanted) {
    const StretchGrid grid(visible_stretches(clipped, runs));
    return parallel_collect<PassBehind>(runs.size(), runs_per_block, [&](std::size_t r, std::size_t last, auto& part) {
        for (; r < last; ++r) {
            const Index piece = runs.piece[r];
            if (!wanted[clipped.path[piece]] || runs.invisibility[r] != 0 || in_image(clipped, piece)) continue;
            for_stretches(clipped, piece, runs.start_px[r] - reach_px, runs.end_px[r] + reach_px,
                          [&](const Stretch& stretch) { find(clipped, runs, r, grid, stretch, part); });
        }
        // The grid returns stretches in unspecified order.
        std::ranges::sort(part, {}, [](const PassBehind& p) { return std::tuple(p.piece, p.arc_px, p.sine); });
    });
}

}  // namespace fovea::runs
