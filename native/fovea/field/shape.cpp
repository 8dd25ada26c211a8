// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/field/shape.h>

#include <algorithm>
#include <cmath>
#include <format>

#include <fovea/base/elementary.h>
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
const double fitting = cosine(glm::radians(25.0));
constexpr double most_unfit = 0.13;   // of the area
constexpr double least_inside = 0.3;  // of the area
/// Of surfaces of more triangles than `all` about `some` are looked at: runs of so many, as those of a run have
/// vertices in common.
constexpr std::size_t run_of_triangles = 16;
struct Looks {
    std::size_t all, some;
};
constexpr Looks for_rounding{100'000, 25'000}, for_fits{10'000, 10'000};

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

/// What the edges and triangles at a vertex sum up to.
struct Around {
    double length = 0.0;         // of its edges
    double smooth_length = 0.0;  // of those that are shaded smooth
    double turn = 0.0;           // their turns, weighted by length
    dvec3 normal{0.0};           // of its triangles, weighted by area
    double area = 0.0;           // a third of its triangles'
    dmat3 bend{0.0};             // signed turns times length, on the directions of the edges: flat along them
    bool folded = false;

    void add_edge(const Surface& surface, Index edge, const Bend& by) {
        const Edge& ends = surface.edges[edge];
        const dvec3 along = dvec3(surface.positions[ends.y]) - dvec3(surface.positions[ends.x]);
        const bool folds = std::abs(by.turn) > fold;
        length += by.length;
        turn += std::abs(by.turn) * by.length;
        bend += folds ? dmat3(0.0) : by.turn / by.length * glm::outerProduct(along, along);
        folded = folded || folds;
        if (is_shaded_smooth(surface, edge)) smooth_length += by.length;
    }
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

/// The triangles that are looked at: every first, second, third ... run of them.
struct Looked {
    Looked(const Surface& surface, const Looks& looks) : step(1), end(surface.triangles.size()) {
        if (end > looks.all) step = end / looks.some + 1;
    }
    /// Number of the i-th of them; `end` or more: there are no more.
    std::size_t operator[](std::size_t i) const {
        return i / run_of_triangles * step * run_of_triangles + i % run_of_triangles;
    }
    /// Bound of i.
    std::size_t count() const { return (end / (step * run_of_triangles) + 1) * run_of_triangles; }

    std::size_t step, end;
};

/// Vertices of the triangles that are looked at.
struct Sample {
    Sample(const Surface& surface, const Looks& looks) : slot(surface.vertex_count(), none) {
        const Looked looked(surface, looks);
        for (std::size_t i = 0; looked[i] < looked.end; ++i)
            for (int k = 0; k < 3; ++k) slot[surface.triangles[looked[i]][k]] = 0;
        for (Index& own : slot)
            if (own != none) own = count++;
    }
    /// The vertices, in order.
    Array<Index> vertices() const {
        Array<Index> result(count);
        for (Index v = 0; v < slot.size(); ++v)
            if (slot[v] != none) result[slot[v]] = v;
        return result;
    }
    bool has(const Edge& edge) const { return slot[edge.x] != none || slot[edge.y] != none; }
    bool has(const Triangle& t) const { return slot[t.x] != none || slot[t.y] != none || slot[t.z] != none; }

    Array<Index> slot;  // per vertex; `none`: not in the sample
    Index count = 0;
};

/// Indices of those of `all` that have a vertex of the sample.
template <typename Corners>
Array<Index> at_sample(const Sample& sample, const Array<Corners>& all) {
    return parallel_where(all.size(), [&](Index i) { return sample.has(all[i]); });
}

Array<Around> sum_up(const Surface& surface, const Sample& sample) {
    const Array<Index> edges = at_sample(sample, surface.edges), triangles = at_sample(sample, surface.triangles);
    const auto bends = parallel_map<Bend>(edges.size(), [&](std::size_t i) { return bend_at(surface, edges[i]); });
    const auto normals = parallel_map<dvec3>(triangles.size(), [&](std::size_t i) {
        return area_vector(surface.positions, surface.triangles[triangles[i]]) / 6.0;
    });
    const auto at_slots = [&](std::size_t count, const auto& corners_of) {
        return lists_of_ranges<Index>(sample.count, [&](const auto& give) {
            for (Index i = 0; i < count; ++i)
                corners_of(i, [&](Index v) {
                    if (sample.slot[v] != none) give(sample.slot[v], i);
                });
        });
    };
    const auto edges_at = at_slots(edges.size(), [&](Index i, const auto& visit) {
        if (!(bends[i].length > 0.0)) return;
        visit(surface.edges[edges[i]].x);
        visit(surface.edges[edges[i]].y);
    });
    const auto triangles_at = at_slots(triangles.size(), [&](Index i, const auto& visit) {
        for (int k = 0; k < 3; ++k) visit(surface.triangles[triangles[i]][k]);
    });
    return parallel_map<Around>(sample.count, [&](std::size_t slot) {
        Around at;
        for (const Index i : edges_at[Index(slot)]) at.add_edge(surface, edges[i], bends[i]);
        for (const Index i : triangles_at[Index(slot)]) {
            at.normal += normals[i];
            at.area += glm::length(normals[i]);
        }
        return at;
    });
}

struct Rounded {
    double share = 0.0;   // of the area, that of vertices
    double inside = 0.0;  // of the area, that of triangles with three such vertices
    double turn = 0.0;    // mean at its edges, radians
};

/// values(t) of each triangle that is looked at, summed up.
template <typename Values>
dvec2 sum_of_triangles(const Surface& surface, const Looks& looks, const Values& values) {
    const Looked looked(surface, looks);
    dvec2 sum(0.0);
    for (const dvec2& part : parallel_map<dvec2>(looked.count(), [&](std::size_t i) {
             return looked[i] < looked.end ? dvec2(values(surface.triangles[looked[i]])) : dvec2(0.0);
         }))
        sum += part;
    return sum;
}

Rounded rounded_part(const Surface& surface) {
    const Sample sample(surface, for_rounding);
    const Array<Around> around = sum_up(surface, sample);
    const auto is_rounded =
        parallel_map<std::uint8_t>(around.size(), [&](std::size_t v) { return around[v].is_rounded(); });
    double area = 0.0, rounded = 0.0, turn = 0.0;
    for (Index v = 0; v < around.size(); ++v) {
        const Around& at = around[v];
        area += at.area;
        if (!is_rounded[v]) continue;
        rounded += at.area;
        turn += at.area * at.mean_turn();
    }
    // Areas of triangles, and of those with rounded corners only.
    const dvec2 areas = sum_of_triangles(surface, for_rounding, [&](const Triangle& t) {
        const double size = glm::length(area_vector(surface.positions, t));
        const auto has_rounded = [&](int k) { return is_rounded[sample.slot[t[k]]]; };
        return dvec2(size, has_rounded(0) && has_rounded(1) && has_rounded(2) ? size : 0.0);
    });
    const double inside = areas.y / areas.x;
    return rounded > 0.0 ? Rounded{rounded / area, inside, turn / rounded} : Rounded{};
}

/// Share of the area of triangles that a fitted normal at one of their corners is off by more than 25 degrees.
double unfit_share(const Surface& surface) {
    const Sample sample(surface, for_fits);
    const Array<vec3> normals = fitted_normals(surface, sample.vertices());
    // Areas of triangles, and of those that do not fit.
    const dvec2 areas = sum_of_triangles(surface, for_fits, [&](const Triangle& t) {
        const dvec3 normal = area_vector(surface.positions, t);
        const double size = glm::length(normal);
        double least = size;
        for (int k = 0; k < 3; ++k) least = std::min(least, glm::dot(normal, dvec3(normals[sample.slot[t[k]]])));
        return dvec2(size, least < fitting * size ? size : 0.0);
    });
    return areas.x > 0.0 ? areas.y / areas.x : 1.0;
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
