// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/field/shape.h>

#include <algorithm>
#include <cmath>
#include <format>

#include <fovea/base/parallel.h>
#include <fovea/field/fields.h>
#include <fovea/field/turn.h>

namespace fovea::field {
namespace {

constexpr double least_turn = glm::radians(0.25), most_turn = glm::radians(15.0),
                 most_turn_if_smooth = glm::radians(45.0), fold = glm::radians(75.0);
constexpr double most_fine_turn = glm::radians(8.5);  // contours of coarser meshes leave their smooth shape's
constexpr double least_ratio = 0.1;                   // of the lesser to the greater principal curvature
constexpr double least_share = 0.42;                  // of the area
const double fitting = std::cos(glm::radians(25.0));
constexpr double most_unfit = 0.13;   // of the area
constexpr double least_inside = 0.3;  // of the area

/// What the edges and triangles at a vertex sum up to.
struct Around {
    double length = 0.0;         // of its edges
    double smooth_length = 0.0;  // of those that are shaded smooth
    double turn = 0.0;           // their turns, weighted by length
    dvec3 normal{0.0};           // of its triangles, weighted by area
    double area = 0.0;           // a third of its triangles'
    dmat3 bend{0.0};             // signed turns times length, on the directions of the edges: flat along them
    bool folded = false;

    double mean_turn() const { return length > 0.0 ? turn / length : 0.0; }
    double greatest_turn() const {
        return length > 0.0 ? glm::mix(most_turn, most_turn_if_smooth, smooth_length / length) : 0.0;
    }
    /// Whether both eigenvalues of `bend` in the tangent plane are of about the same size.
    bool bends_both_ways() const {
        const double size = glm::length(normal);
        if (!(size > 0.0)) return false;
        const dvec3 n = normal / size;
        const dvec3 e1 = glm::normalize(glm::cross(n, std::abs(n.x) < 0.6 ? dvec3(1, 0, 0) : dvec3(0, 1, 0)));
        const dvec3 e2 = glm::cross(n, e1), b1 = bend * e1, b2 = bend * e2;
        const double a = glm::dot(e1, b1), b = glm::dot(e1, b2), c = glm::dot(e2, b2), det = a * c - b * b;
        return std::abs(det) > least_ratio / (1.0 + least_ratio * least_ratio) * (a * a + c * c + 2.0 * b * b);
    }
    bool is_rounded() const {
        return !folded && mean_turn() > least_turn && mean_turn() < greatest_turn() && bends_both_ways();
    }
};

/// An edge between two facets; length 0: another edge.
struct Bend {
    double length = 0.0, turn = 0.0;
};

Bend bend_at(const Surface& surface, Index edge) {
    if (surface.edge_rows.size(edge) != 2) return {};
    const Edge& ends = surface.edges[edge];
    const double length = glm::distance(dvec3(surface.positions[ends.x]), dvec3(surface.positions[ends.y]));
    return length > 0.0 ? Bend{length, signed_turn(surface, edge)} : Bend{};
}

Array<Around> sum_up(const Surface& surface) {
    const auto bends =
        parallel_map<Bend>(surface.edges.size(), [&](std::size_t e) { return bend_at(surface, Index(e)); });
    const auto normals = parallel_map<dvec3>(surface.triangles.size(), [&](std::size_t t) {
        return area_vector(surface.positions, surface.triangles[t]) / 6.0;
    });
    Array<Around> around(surface.vertex_count());
    // Blocks of vertices, each of which meets all edges: so every sum has one order.
    const std::size_t block = std::max<std::size_t>(4096, around.size() / 16 + 1);
    parallel_blocks(around.size(), block, [&](std::size_t, std::size_t begin, std::size_t end) {
        const auto is_own = [&](Index v) { return v - begin < end - begin; };
        for (Index e = 0; e < bends.size(); ++e) {
            const Edge& ends = surface.edges[e];
            if (!(is_own(ends.x) || is_own(ends.y)) || !(bends[e].length > 0.0)) continue;
            const auto [length, turn] = bends[e];
            const dvec3 along = dvec3(surface.positions[ends.y]) - dvec3(surface.positions[ends.x]);
            const bool folds = std::abs(turn) > fold;
            const dmat3 bend = folds ? dmat3(0.0) : turn / length * glm::outerProduct(along, along);
            for (const Index v : {ends.x, ends.y}) {
                if (!is_own(v)) continue;
                Around& at = around[v];
                at.length += length;
                at.turn += std::abs(turn) * length;
                at.bend += bend;
                at.folded = at.folded || folds;
                if (is_shaded_smooth(surface, e)) at.smooth_length += length;
            }
        }
        for (std::size_t t = 0; t < normals.size(); ++t)
            for (int k = 0; k < 3; ++k) {
                if (!is_own(surface.triangles[t][k])) continue;
                Around& at = around[surface.triangles[t][k]];
                at.normal += normals[t];
                at.area += glm::length(normals[t]);
            }
    });
    return around;
}

struct Rounded {
    double share = 0.0;   // of the area, that of vertices
    double inside = 0.0;  // of the area, that of triangles with three such vertices
    double turn = 0.0;    // mean at its edges, radians
};

Rounded rounded_part(const Surface& surface) {
    const Array<Around> around = sum_up(surface);
    const auto is_rounded =
        parallel_map<std::uint8_t>(around.size(), [&](std::size_t v) { return around[v].is_rounded(); });
    double area = 0.0, rounded = 0.0, inside = 0.0, turn = 0.0;
    for (Index v = 0; v < around.size(); ++v) {
        const Around& at = around[v];
        area += at.area;
        if (!is_rounded[v]) continue;
        rounded += at.area;
        turn += at.area * at.mean_turn();
    }
    const auto areas = parallel_map<double>(surface.triangles.size(), [&](std::size_t t) {
        const Triangle& c = surface.triangles[t];
        const bool counts = is_rounded[c.x] && is_rounded[c.y] && is_rounded[c.z];
        return counts ? 0.5 * glm::length(area_vector(surface.positions, c)) : 0.0;
    });
    for (const double part : areas) inside += part;
    return rounded > 0.0 ? Rounded{rounded / area, inside / area, turn / rounded} : Rounded{};
}

/// Share of the area of triangles that a fitted normal at one of their corners is off by more than 25 degrees.
double unfit_share(const Surface& surface) {
    const auto fields = fields_of(surface);
    // Areas, times 2, of triangles that fit (x) and of others (y).
    const auto areas = parallel_map<dvec2>(surface.triangles.size(), [&](std::size_t t) {
        const Triangle& c = surface.triangles[t];
        const dvec3 normal = area_vector(surface.positions, c);
        const double size = glm::length(normal);
        double least = size;
        for (int k = 0; k < 3; ++k) least = std::min(least, glm::dot(normal, dvec3(fields->curvature[c[k]].normal)));
        return least < fitting * size ? dvec2(0.0, size) : dvec2(size, 0.0);
    });
    dvec2 sum(0.0);
    for (const dvec2& part : areas) sum += part;
    const double area = sum.x + sum.y, unfit = sum.y;
    return area > 0.0 ? unfit / area : 1.0;
}

DecidedShape decide(const Surface& surface) {
    if (!surface.jets.empty()) return {Shape::smooth, "it is the limit surface of a subdivision"};
    const Rounded rounded = rounded_part(surface);
    auto told = std::format("{:.0f} % of its area is rounded", 100.0 * rounded.share);
    if (!(rounded.share >= least_share)) return {Shape::hard, told};
    told += std::format(", turning by {:.1f} degrees at an edge", glm::degrees(rounded.turn));
    if (rounded.turn > most_fine_turn) return {Shape::rounded, told};
    if (!(rounded.inside >= least_inside))
        return {Shape::rounded,
                std::format("{}, {:.0f} % is in triangles with rounded corners only", told, 100.0 * rounded.inside)};
    const double unfit = unfit_share(surface);
    return {unfit <= most_unfit ? Shape::smooth : Shape::rounded,
            std::format("{}, {:.0f} % is coarser than a smooth shape", told, 100.0 * unfit)};
}

}  // namespace

std::shared_ptr<const DecidedShape> decided_shape(const Surface& surface) {
    if (surface.source()) return decided_shape(*surface.source());
    if (surface.shape() != Shape::automatic)
        return std::make_shared<const DecidedShape>(DecidedShape{surface.shape(), "as asked for"});
    return surface.cache().get<DecidedShape>(hash_of(surface.field_options()), [&] { return decide(surface); });
}

std::shared_ptr<const DecidedShape> known_shape(const Surface& surface) {
    if (surface.shape() != Shape::automatic) return decided_shape(surface);
    const Surface& of = surface.source() ? *surface.source() : surface;
    return of.cache().find<DecidedShape>(hash_of(of.field_options()));
}

}  // namespace fovea::field
