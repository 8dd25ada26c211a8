// SPDX-License-Identifier: GPL-3.0-or-later
// Geometry of a surface: triangles, facets and their planes, sides of edges.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>

#include <fovea/base/parallel.h>
#include <fovea/mesh/slivers.h>

namespace fovea::mesh {
namespace {

/// Deviation from its plane, as a share of its size, up to which a polygon counts as planar: 0.1 degrees.
constexpr double flat_tolerance = 0.0017;
/// Area, as a share of the squared perimeter, below which a polygon has no usable normal.
constexpr double least_area = 1e-11;

bool finite(const vec3& p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

vec4 plane_through(const dvec3& area, const dvec3& point) {
    const dvec3 n = area / glm::length(area);
    return vec4(vec3(n), static_cast<float>(glm::dot(n, point)));
}

/// std::stable_sort, without the memory that it asks for each time, where there is little to sort.
template <typename T, typename Less>
void sort_few(std::vector<T>& values, const Less& less) {
    constexpr std::size_t few = 32;
    if (values.size() > few) return std::stable_sort(values.begin(), values.end(), less);
    for (std::size_t i = 1; i < values.size(); ++i)
        for (std::size_t j = i; j > 0 && less(values[j], values[j - 1]); --j) std::swap(values[j], values[j - 1]);
}

}  // namespace

void Surface::build_geometry() {
    Array<std::uint8_t> skip(polygon_count(), 0);
    const Array<Outline> outlines = find_degenerate(skip);
    find_duplicates(skip);
    triangulate(skip);
    build_facets(skip, outlines);
    build_edge_sides(skip);
    sort_occluding();
    bound();
}

Surface::Surface(const Surface& source, const dmat3& stretch)
    : SurfaceArrays(source),
      name_(source.name_),
      polygons_(source.polygons_),
      report_(source.report_),
      source_(&source),
      stretch_(stretch),
      version_(source.version_) {
    parallel_for(positions.size(), [&](std::size_t v) { positions[v] = vec3(stretch * dvec3(positions[v])); });
    const dmat3 of_planes = glm::transpose(glm::inverse(stretch));
    parallel_for(facet_plane.size(), [&](std::size_t f) {
        const dvec3 n = of_planes * dvec3(facet_plane[f]);
        facet_plane[f] = vec4(dvec4(n, facet_plane[f].w) / glm::length(n));
    });
    bound();
}

Surface::Outline Surface::outline_of(In<Index> corners) const {
    Outline outline{};
    const dvec3 origin(positions[corners[0]]);
    dvec3 a = dvec3(positions[corners.back()]) - origin;
    for (const Index corner : corners) {
        const dvec3 b = dvec3(positions[corner]) - origin;
        outline.area += glm::cross(a, b);
        outline.perimeter += glm::length(b - a);
        a = b;
    }
    return outline;
}

bool Surface::is_flat(In<Index> corners, const Outline& outline) const {
    const dvec3 n = outline.area / glm::length(outline.area);
    const dvec3 first_corner(positions[corners[0]]);
    double deviation = 0.0;
    for (const Index v : corners)
        deviation = std::max(deviation, std::abs(glm::dot(n, dvec3(positions[v]) - first_corner)));
    // Side of a square of the same area or the same perimeter, whichever is less: twisted strips and jagged polygons
    // have long perimeters.
    const double size = std::min(0.25 * outline.perimeter, std::sqrt(0.5 * glm::length(outline.area)));
    return deviation <= flat_tolerance * size;
}

Array<Surface::Outline> Surface::find_degenerate(Array<std::uint8_t>& skip) {
    Array<Outline> outlines(polygon_count());
    parallel_for(polygon_count(), [&](std::size_t f) {
        const In<Index> corners = polygon_vertices(Index(f));
        skip[f] = corners.size() < 3;
        Index before = corners.empty() ? none : corners.back();
        for (const Index corner : corners) {
            skip[f] |= !finite(positions[corner]) || corner == before;
            before = corner;
        }
        if (skip[f]) return;
        outlines[f] = outline_of(corners);
        const double size = outlines[f].perimeter * outlines[f].perimeter;
        skip[f] = !(glm::length(outlines[f].area) > least_area * size);
    });
    report_.degenerate_polygons = static_cast<Index>(std::count(skip.begin(), skip.end(), 1));
    report_.non_finite_vertices =
        static_cast<Index>(parallel_count(positions.size(), [&](std::size_t v) { return !finite(positions[v]); }));
    return outlines;
}

void Surface::find_duplicates(Array<std::uint8_t>& skip) {
    // Candidates for the duplicate of a polygon are the polygons at its first edge.
    Array<Index> corner_polygon(corner_verts_.size());
    parallel_for(polygon_count(), [&](std::size_t f) {
        std::fill(corner_polygon.begin() + polygons_.begin(f), corner_polygon.begin() + polygons_.end(f), Index(f));
    });
    const auto sum = [&](Index f) {
        const In<Index> verts = polygon_vertices(f);
        return std::accumulate(verts.begin(), verts.end(), std::uint64_t(0));
    };
    const auto same_vertices = [&](Index a, Index b) {
        const In<Index> of_a = polygon_vertices(a), of_b = polygon_vertices(b);
        return of_a.size() == of_b.size() && sum(a) == sum(b) &&
               std::ranges::all_of(of_a, [&](Index v) { return std::ranges::find(of_b, v) != of_b.end(); });
    };
    const auto duplicate = parallel_map<std::uint8_t>(polygon_count(), [&](std::size_t f) {
        const auto is_earlier = [&](Index corner) {
            const Index other = corner_polygon[corner];
            return other < f && !skip[other] && same_vertices(other, Index(f));
        };
        if (skip[f] || corner_edges_[polygons_.begin(f)] == none) return false;
        return std::ranges::any_of(edge_corners_[corner_edges_[polygons_.begin(f)]], is_earlier);
    });
    report_.duplicate_polygons = static_cast<Index>(std::count(duplicate.begin(), duplicate.end(), 1));
    for (Index f = 0; f < polygon_count(); ++f) skip[f] |= duplicate[f];
}

void Surface::triangulate(const Array<std::uint8_t>& skip) {
    polygon_triangles_.offsets = parallel_map<Index>(polygon_count(), [&](std::size_t f) {
        const auto given = Index(ngon_triangles_.of(f).size());
        return skip[f] ? 0 : given ? given : polygons_.size(f) - 2;
    });
    counts_to_offsets(polygon_triangles_.offsets);
    triangles.resize(polygon_triangles_.offsets.back());
    parallel_for(polygon_count(), [&](std::size_t f) {
        if (skip[f]) return;
        const In<Index> v = polygon_vertices(Index(f));
        Triangle* out = triangles.data() + polygon_triangles_.begin(f);
        if (const In<Triangle> given = ngon_triangles_.of(f); !given.empty()) {
            std::ranges::copy(given, out);
        } else if (v.size() == 4) {
            // Split along diagonal 0-2, unless it lies outside (a concave quad): then the two halves would face
            // opposite ways.
            const dvec3 origin(positions[v[0]]), diagonal = dvec3(positions[v[2]]) - origin;
            const dvec3 left = glm::cross(dvec3(positions[v[1]]) - origin, diagonal);
            const dvec3 right = glm::cross(diagonal, dvec3(positions[v[3]]) - origin);
            const bool flip = glm::dot(left, right) < 0.0;
            out[0] = flip ? Triangle(v[1], v[2], v[3]) : Triangle(v[0], v[1], v[2]);
            out[1] = flip ? Triangle(v[1], v[3], v[0]) : Triangle(v[0], v[2], v[3]);
        } else {
            for (Index i = 0; i + 2 < v.size(); ++i) out[i] = Triangle(v[0], v[i + 1], v[i + 2]);
        }
    });
}

void Surface::build_facets(const Array<std::uint8_t>& skip, const Array<Outline>& outlines) {
    // Facets per polygon: one if it is planar, else one per triangle that leads itself and others.
    Array<Index> leader(triangles.size());
    Array<std::uint8_t> bent(polygon_count());
    Array<Index> first = parallel_map<Index>(polygon_count(), [&](std::size_t f) {
        const In<Index> corners = polygon_vertices(Index(f));
        bent[f] = !skip[f] && corners.size() > 3 && !is_flat(corners, outlines[f]);
        return bent[f]
                   ? find_leaders(positions, triangles, polygon_triangles_.begin(f), polygon_triangles_.end(f), leader)
                   : Index(!skip[f]);
    });
    counts_to_offsets(first);

    facet_plane.resize(first.back());
    facet_polygon.resize(first.back());
    triangle_facet.resize(triangles.size());
    parallel_for(polygon_count(), [&](std::size_t f) {
        if (skip[f]) return;
        const Index begin = polygon_triangles_.begin(f), end = polygon_triangles_.end(f);
        Index facet = first[f];
        const auto add_facet = [&](const dvec3& area, Index t) {
            facet_plane[facet] = plane_through(area, dvec3(positions[triangles[t].x]));
            facet_polygon[facet] = static_cast<Index>(f);
            triangle_facet[t] = facet++;
        };
        if (!bent[f]) {
            add_facet(outlines[f].area, begin);
            std::fill(triangle_facet.begin() + begin, triangle_facet.begin() + end, first[f]);
            return;
        }
        for (Index t = begin; t < end; ++t) {
            if (leader[t] != t) continue;
            const TriangleSize own = size_of(positions, triangles[t]);
            // The perimeter of a triangle of hardly any area is twice its longest side.
            const bool usable = glm::length(own.area) > 4.0 * least_area * own.longest_squared;
            add_facet(usable ? own.area : outlines[f].area, t);
        }
        for (Index t = begin; t < end; ++t) triangle_facet[t] = triangle_facet[leader[t]];
    });
}

void Surface::split_bent_quad(Index f, Array<Index>& corner_facet, Array<Diagonal>& diagonals) const {
    const Index begin = polygon_triangles_.begin(f), first = triangle_facet[begin], second = triangle_facet[begin + 1];
    const Index from = triangles[begin].x, to = triangles[begin].z;  // the second triangle goes from `to` back
    const Index c0 = polygons_.begin(f), shift = from == corner_verts_[c0] ? 0 : 1;
    for (Index i = 0; i < 4; ++i) corner_facet[c0 + (i + shift) % 4] = i < 2 ? first : second;
    diagonals.push_back(
        {Edge(std::min(from, to), std::max(from, to)), EdgeSide(first, to < from), EdgeSide(second, from < to)});
}

void Surface::split_bent_polygon(Index f, std::vector<TriangleSide>& sides, Array<Index>& corner_facet,
                                 Array<Diagonal>& diagonals) const {
    // Sort the sides of the triangles and of the polygon by their vertices, so that equal ones are adjacent: a triangle
    // side that equals a polygon side lies on the outline; one that equals another triangle's is a diagonal.
    sides.clear();
    const Index c0 = polygons_.begin(f), corners = polygons_.size(f);
    const auto add = [&](Index from, Index to, Index facet, Index corner) {
        sides.push_back({std::min(from, to), std::max(from, to), from < to, facet, corner});
    };
    for (Index i = 0; i < corners; ++i) add(corner_verts_[c0 + i], corner_verts_[c0 + (i + 1) % corners], none, c0 + i);
    for (Index t = polygon_triangles_.begin(f); t < polygon_triangles_.end(f); ++t)
        for (int i = 0; i < 3; ++i) add(triangles[t][i], triangles[t][(i + 1) % 3], triangle_facet[t], none);
    sort_few(sides, [](const TriangleSide& a, const TriangleSide& b) {
        return std::tie(a.low, a.high) < std::tie(b.low, b.high);
    });
    for (std::size_t i = 0; i + 1 < sides.size(); ++i) {
        const TriangleSide &a = sides[i], &b = sides[i + 1];
        if (a.low != b.low || a.high != b.high) continue;
        if (a.corner != none && b.facet != none) corner_facet[a.corner] = b.facet;
        if (a.facet != none && b.facet != none && a.facet != b.facet)
            diagonals.push_back({Edge(a.low, a.high), EdgeSide(a.facet, a.ascending), EdgeSide(b.facet, b.ascending)});
        ++i;
    }
}

void Surface::build_edge_sides(const Array<std::uint8_t>& skip) {
    // The facet at each corner's side: the polygon if it is planar, else the triangle with that side.
    Array<Index> corner_facet(corner_verts_.size());
    const auto diagonals = parallel_collect<Diagonal>(polygon_count(), 4096, [&](auto begin, auto end, auto& found) {
        std::vector<TriangleSide> scratch;
        for (std::size_t f = begin; f < end; ++f) {
            const In<Index> own =
                In<Index>(triangle_facet).subspan(polygon_triangles_.begin(f), polygon_triangles_.size(f));
            const bool one = std::ranges::all_of(own, [&](Index of) { return of == own[0]; });
            if (!one && polygons_.size(f) == 4) {
                split_bent_quad(static_cast<Index>(f), corner_facet, found);
                continue;
            }
            const Index facet = one && !skip[f] ? own[0] : none;
            std::fill(corner_facet.begin() + polygons_.begin(f), corner_facet.begin() + polygons_.end(f), facet);
            if (!one) split_bent_polygon(static_cast<Index>(f), scratch, corner_facet, found);
        }
    });

    edges.reserve(mesh_edges + diagonals.size());  // resize alone would double it
    edges.resize(mesh_edges + diagonals.size());
    auto& offsets = edge_rows.offsets;
    offsets = parallel_map<Index>(mesh_edges + diagonals.size(), [&](std::size_t e) {
        if (e >= mesh_edges) return Index(2);
        const In<Index> corners = edge_corners_[Index(e)];
        return Index(std::ranges::count_if(corners, [&](Index corner) { return corner_facet[corner] != none; }));
    });
    counts_to_offsets(offsets);
    edge_sides.resize(offsets.back());
    parallel_for(mesh_edges, [&](std::size_t e) {
        EdgeSide* out = edge_sides.data() + offsets[e];
        for (const Index corner : edge_corners_[Index(e)]) {
            if (corner_facet[corner] == none) continue;
            *out++ = EdgeSide(corner_facet[corner], corner_verts_[corner] == edges[e].x);
        }
    });
    parallel_for(diagonals.size(), [&](std::size_t i) {
        const Diagonal& d = diagonals[i];
        const std::size_t e = mesh_edges + i;
        edges[e] = d.edge;
        edge_sides[offsets[e]] = d.first;
        edge_sides[offsets[e] + 1] = d.second;
    });
    report_.non_manifold_edges =
        static_cast<Index>(parallel_count(mesh_edges, [&](std::size_t e) { return edge_rows.size(Index(e)) > 2; }));
    report_.inconsistent_edges = static_cast<Index>(parallel_count(mesh_edges, [&](std::size_t e) {
        const In<EdgeSide> of = sides(Index(e));
        return of.size() == 2 && of[0].forward() == of[1].forward();
    }));
}

void Surface::sort_occluding() {
    // Occluding triangles go first, so that the BVH uses a prefix of the array, and one-sided ones last of them.
    two_sided_triangles = occluding_triangles = static_cast<Index>(triangles.size());
    if (polygon_occludes_.empty() && polygon_one_sided.empty()) return;
    Array<Index> order(triangles.size());
    std::iota(order.begin(), order.end(), 0);
    const auto polygon = [&](Index t) { return facet_polygon[triangle_facet[t]]; };
    const auto occludes = [&](Index t) { return polygon_occludes_.empty() || polygon_occludes_[polygon(t)]; };
    const auto two_sided = [&](Index t) { return polygon_one_sided.empty() || !polygon_one_sided[polygon(t)]; };
    const auto occluding = std::stable_partition(order.begin(), order.end(), occludes);
    const auto first_one_sided = std::stable_partition(order.begin(), occluding, two_sided);
    occluding_triangles = static_cast<Index>(occluding - order.begin());
    two_sided_triangles = static_cast<Index>(first_one_sided - order.begin());
    triangles = parallel_map<Triangle>(order.size(), [&](std::size_t t) { return triangles[order[t]]; });
    triangle_facet = parallel_map<Index>(order.size(), [&](std::size_t t) { return triangle_facet[order[t]]; });
}

void Surface::bound() {
    struct Bounds {
        vec3 low{std::numeric_limits<float>::max()}, high{std::numeric_limits<float>::lowest()};
    };
    const auto parts =
        parallel_parts<Bounds>(vertex_count(), 1 << 14, [&](Bounds& part, std::size_t begin, std::size_t end) {
            for (std::size_t v = begin; v < end; ++v) {
                if (!finite(positions[v])) continue;
                part.low = glm::min(part.low, positions[v]);
                part.high = glm::max(part.high, positions[v]);
            }
        });
    auto [low, high] = Bounds();
    for (const Bounds& part : parts) {
        low = glm::min(low, part.low);
        high = glm::max(high, part.high);
    }
    const bool any = low.x <= high.x;
    center = any ? 0.5f * (low + high) : vec3(0.0f);
    half = any ? 0.5f * (high - low) : vec3(0.0f);
    radius = any ? 0.5f * glm::length(high - low) : 0.0f;
}

}  // namespace fovea::mesh
