// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/field/jets.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <tbb/enumerable_thread_specific.h>

#include <fovea/base/parallel.h>
#include <fovea/field/exact_curvature.h>
#include <fovea/field/height_fits.h>
#include <fovea/field/normals.h>
#include <fovea/field/walk.h>

namespace fovea::field {
namespace {

constexpr int spare_points = 4;  // points wanted beyond the number of coefficients
constexpr int extra_rings = 4;   // rings added at most where there are too few points

/// Per-thread scratch space for as many neighborhoods as are fitted at once.
struct Look {
    explicit Look(Index vertices) : walk(vertices) {}
    Walk walk;
    Heights heights;
    Planes planes;  // tangents and normals

    /// Fills a lane with a neighborhood, the vertex itself first.
    void place(const Surface& surface, const Neighbors& neighbors, const std::vector<Index>& found, const dvec3& normal,
               std::size_t lane) {
        const dvec3 tangent = any_tangent(normal);
        const dmat3 axes(tangent, glm::cross(normal, tangent), normal);
        for (int k = 0; k < 3; ++k)
            for (int i = 0; i < 3; ++i) planes.axes[k][i][lane] = axes[k][i];
        planes.nearest[lane] = std::min<std::size_t>(neighbors.vertices.size(found[0]), found.size() - 1);
        heights.add(lane, found.size());
        const dvec3 origin(surface.positions[found[0]]);
        for (std::size_t i = 0; i < found.size(); ++i) {
            const dvec3 d = dvec3(surface.positions[found[i]]) - origin;
            const std::size_t at = i * Heights::lanes + lane;
            heights.x[at] = d.x;
            heights.y[at] = d.y;
            heights.z[at] = d.z;
        }
    }
};

/// Jet of F = z - f(x, y) at x = y = 0, with lengths in units of `scale`.
ImplicitJet jet_of(const std::array<double, terms(max_degree)>& a) {
    ImplicitJet jet;
    jet.gradient = {-a[1], -a[2], 1.0};
    const double xx = -2.0 * a[3], xy = -a[4], yy = -2.0 * a[5];
    jet.hessian = dmat3(xx, xy, 0, xy, yy, 0, 0, 0, 0);
    const double xxx = -6.0 * a[6], xxy = -2.0 * a[7], xyy = -2.0 * a[8], yyy = -6.0 * a[9];
    jet.third[0] = dmat3(xxx, xxy, 0, xxy, xyy, 0, 0, 0, 0);
    jet.third[1] = dmat3(xxy, xyy, 0, xyy, yyy, 0, 0, 0, 0);
    return jet;
}

/// From the frame and the unit of heights over a plane, which are of some extent.
Curvature to_object(CurvatureD c, const Planes& planes, std::size_t lane) {
    const double scale = planes.scale[lane];
    dmat3 axes;
    for (int k = 0; k < 3; ++k)
        for (int i = 0; i < 3; ++i) axes[k][i] = planes.axes[k][i][lane];
    c.normal = axes * c.normal;
    c.e1 = axes * c.e1;
    c.e2 = axes * c.e2;
    c.k1 /= scale;
    c.k2 /= scale;
    for (double& third : c.C) third /= scale * scale;
    return rounded(c);
}

/// Gathers the neighborhood of vertex v into a lane; false if v has no normal.
bool look_around(const Surface& surface, const Neighbors& neighbors, const JetOptions& options, Index v, Look& look,
                 std::size_t lane) {
    const vec3 normal = vertex_normal(surface, neighbors, v);
    if (normal == vec3(0.0f)) return false;
    const auto& found =
        look.walk.gather(neighbors, v, options.rings, terms(options.degree) + spare_points, extra_rings);
    look.place(surface, neighbors, found, glm::normalize(dvec3(normal)), lane);
    return true;
}

/// Curvature of `count` vertices, the i-th of which is vertex(i).
template <typename Vertex>
Array<Curvature> fit_vertices(const Surface& surface, const Neighbors& neighbors, const JetOptions& options,
                              std::size_t count, const Vertex& vertex) {
    Array<Curvature> result(count);
    const bool wide = has_wide_registers();
    tbb::enumerable_thread_specific<Look> looks([&] { return Look(surface.vertex_count()); });
    parallel_blocks(count, 1024, [&](std::size_t, std::size_t begin, std::size_t end) {
        Look& look = looks.local();
        for (std::size_t i = begin; i < end;) {
            std::array<std::size_t, Heights::lanes> of_lane;
            std::size_t filled = 0;
            look.heights.clear();
            for (; i < end && filled < Heights::lanes; ++i) {
                result[i] = {};
                if (look_around(surface, neighbors, options, vertex(i), look, filled)) of_lane[filled++] = i;
            }
            put_on_planes(look.heights, look.planes, options.even, wide);
            const auto fits = fit_heights(options.degree, look.heights, wide);
            for (std::size_t lane = 0; lane < filled; ++lane)
                if (look.planes.scale[lane] > 0.0)
                    result[of_lane[lane]] = to_object(curvature_of(jet_of(fits[lane].a)), look.planes, lane);
        }
    });
    return result;
}

/// RMS residual of the fit at a vertex, in edge lengths; nothing if it is not of the degree asked for with points to
/// spare.
std::optional<double> residual_at(const Surface& surface, const Neighbors& neighbors, const JetOptions& options,
                                  Index v, Look& look) {
    constexpr std::size_t lane = 0;
    const Heights& heights = look.heights;
    look.heights.clear();
    if (!look_around(surface, neighbors, options, v, look, lane)) return {};
    put_on_planes(look.heights, look.planes, options.even, has_wide_registers());
    if (heights.counts[lane] < std::size_t(terms(options.degree) + spare_points)) return {};
    const Polynomial found = fit_heights(options.degree, heights, has_wide_registers())[lane];
    if (found.degree != options.degree) return {};
    double squares = 0.0;
    for (std::size_t i = 0; i < heights.counts[lane]; ++i) {
        const std::size_t at = i * Heights::lanes + lane;
        const double off = heights.z[at] - height_of(found, heights.x[at], heights.y[at]);
        squares += off * off;
    }
    const double freedom = double(heights.counts[lane]) - terms(options.degree);
    return std::sqrt(squares / freedom) * look.planes.scale[lane] / look.planes.edge_length[lane];
}

}  // namespace

Array<Curvature> jet_curvature(const Surface& surface, const Neighbors& neighbors, const JetOptions& options) {
    return fit_vertices(surface, neighbors, options, surface.vertex_count(),
                        [](std::size_t i) { return static_cast<Index>(i); });
}

Array<Curvature> jet_curvature(const Surface& surface, const Neighbors& neighbors, const JetOptions& options,
                               In<Index> vertices) {
    return fit_vertices(surface, neighbors, options, vertices.size(), [&](std::size_t i) { return vertices[i]; });
}

double jet_noise(const Surface& surface, const Neighbors& neighbors, const JetOptions& options, Index samples) {
    const Index step = std::max<Index>(1, surface.vertex_count() / std::max<Index>(1, samples));
    tbb::enumerable_thread_specific<Look> looks([&] { return Look(surface.vertex_count()); });
    const auto fit_some = [&](std::size_t begin, std::size_t end, Array<double>& noise) {
        Look& look = looks.local();
        for (std::size_t i = begin; i < end; ++i)
            if (const auto residual = residual_at(surface, neighbors, options, Index(i) * step, look))
                noise.push_back(*residual);
    };
    Array<double> noise = parallel_collect<double>((surface.vertex_count() + step - 1) / step, 64, fit_some);
    if (noise.empty()) return 0.0;
    std::nth_element(noise.begin(), noise.begin() + noise.size() / 2, noise.end());
    return noise[noise.size() / 2];
}

}  // namespace fovea::field
