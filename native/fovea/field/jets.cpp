// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/field/jets.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <tbb/enumerable_thread_specific.h>

#include <fovea/base/parallel.h>
#include <fovea/field/exact_curvature.h>
#include <fovea/field/normals.h>
#include <fovea/field/walk.h>

namespace fovea::field {
namespace {

constexpr int terms(int degree) { return (degree + 1) * (degree + 2) / 2; }
constexpr int max_degree = 4;
constexpr int spare_points = 4;  // points wanted beyond the number of coefficients
constexpr int extra_rings = 4;   // rings added at most where there are too few points
/// Pivot, as a share of its diagonal entry, at or below which a coefficient counts as undetermined.
constexpr double least_pivot = 1e-10;

/// Two points per SIMD register: available on every 64-bit processor, so that sums are rounded alike on all.
using Lanes = double __attribute__((vector_size(16)));
constexpr std::size_t lanes = 2, unrolled = 2 * lanes;

/// Neighborhood of a vertex in its own frame, as arrays per coordinate, divided by `scale`, the mean distance; padded
/// with points of weight zero to a multiple of `unrolled`.
struct Surroundings {
    std::vector<double> x, y, z, weight;
    dvec3 t, b, n;
    double scale = 1.0, edge_length = 0.0;
    std::size_t count = 0;  // including the vertex itself, which comes first
};

/// Per-thread scratch space for one neighborhood.
struct Look {
    explicit Look(Index vertices) : walk(vertices) {}
    Walk walk;
    Surroundings around;

    /// Fills `around`. `even`: equal weights, which noisy surfaces need; else near points weigh more, which makes fits
    /// accurate on clean ones.
    void place(const Surface& surface, const Neighbors& neighbors, const std::vector<Index>& found, const dvec3& normal,
               bool even) {
        around.count = found.size();
        around.n = normal;
        around.t = any_tangent(normal);
        around.b = glm::cross(normal, around.t);
        const std::size_t padded = (found.size() + unrolled - 1) / unrolled * unrolled;
        for (auto* values : {&around.x, &around.y, &around.z, &around.weight}) values->assign(padded, 0.0);
        const dvec3 origin(surface.positions[found[0]]);
        const std::size_t first_ring = std::min<std::size_t>(neighbors.vertices.size(found[0]), found.size() - 1);
        double sum = 0.0;
        around.edge_length = 0.0;
        for (std::size_t i = 0; i < found.size(); ++i) {
            const dvec3 d = dvec3(surface.positions[found[i]]) - origin;
            around.x[i] = glm::dot(d, around.t);
            around.y[i] = glm::dot(d, around.b);
            around.z[i] = glm::dot(d, around.n);
            sum += glm::length(d);
            if (i == first_ring && i > 0) around.edge_length = sum / double(i);
        }
        around.scale = found.size() > 1 ? sum / double(found.size() - 1) : 0.0;
        if (!(around.scale > 0.0)) return;
        const double inverse = 1.0 / around.scale;
        for (std::size_t i = 0; i < found.size(); ++i) {
            const double x = around.x[i] *= inverse, y = around.y[i] *= inverse, z = around.z[i] *= inverse;
            around.weight[i] = even ? 1.0 : 1.0 / (0.1 + x * x + y * y + z * z);
        }
    }
};

/// Monomials x^i y^j up to a degree, ordered by degree, then by j, all multiplied by `first`.
template <int degree, typename Real>
void monomials(Real x, Real y, Real first, Real* m) {
    m[0] = first;
    for (int d = 1; d <= degree; ++d) {
        const Real* lower = m + terms(d - 2);
        Real* own = m + terms(d - 1);
        for (int j = 0; j < d; ++j) own[j] = x * lower[j];
        own[d] = y * lower[d - 1];
    }
}

/// Weighted sums of all monomials up to twice the degree (moments), and of z times monomials up to the degree.
template <int degree>
void add_up(const Surroundings& points, double* moments, double* heights) {
    constexpr int size = terms(degree), moment_count = terms(2 * degree);
    Lanes sums[moment_count] = {}, z_sums[size] = {}, m[moment_count], n[moment_count];
    const auto load = [](const std::vector<double>& values, std::size_t i) { return Lanes{values[i], values[i + 1]}; };
    for (std::size_t i = 0; i < points.x.size(); i += unrolled) {
        const std::size_t j = i + lanes;
        monomials<2 * degree>(load(points.x, i), load(points.y, i), load(points.weight, i), m);
        monomials<2 * degree>(load(points.x, j), load(points.y, j), load(points.weight, j), n);
        const Lanes z = load(points.z, i), w = load(points.z, j);
        for (int k = 0; k < moment_count; ++k) sums[k] += m[k] + n[k];
        for (int k = 0; k < size; ++k) z_sums[k] += z * m[k] + w * n[k];
    }
    for (int k = 0; k < moment_count; ++k) moments[k] = sums[k][0] + sums[k][1];
    for (int k = 0; k < size; ++k) heights[k] = z_sums[k][0] + z_sums[k][1];
}

/// Least-squares coefficients of z = sum of a x^i y^j; false, leaving `a` untouched, if they are not determined. The
/// entries of the normal matrix are moments, of which only terms(2 degree) are distinct.
template <int degree>
bool fit(const Surroundings& points, double* a) {
    constexpr int size = terms(degree), moment_count = terms(2 * degree);
    if (points.count < std::size_t(size)) return false;
    double moments[moment_count], heights[size];
    add_up<degree>(points, moments, heights);
    // L D L^T factorization, a column at a time; L below the diagonal. Entries beside it fill registers.
    constexpr int wide = size + size % int(lanes);
    double l[size][wide] = {}, scaled[wide] = {}, diagonal[size], inverse[size];
    int row = 0;
    for (int d = 0; d <= degree; ++d)
        for (int j = 0; j <= d; ++j, ++row) {
            int column = 0;
            for (int e = 0; e <= d && column <= row; ++e)
                for (int k = 0; k <= e && column <= row; ++k, ++column)
                    l[row][column] = moments[terms(d + e - 1) + j + k];
            diagonal[row] = l[row][row];
        }
    for (int c = 0; c < size; ++c) {
        if (!(l[c][c] > least_pivot * diagonal[c])) return false;
        inverse[c] = 1.0 / l[c][c];
        for (int r = c + 1; r < size; ++r) scaled[r] = l[r][c] * inverse[c];
        for (int r = c + 1; r < size; ++r) {
            const double unscaled = l[r][c];
            for (int k = (c + 1) / 2 * 2; k <= r; k += 2) {
                l[r][k] -= unscaled * scaled[k];
                l[r][k + 1] -= unscaled * scaled[k + 1];
            }
            l[r][c] = scaled[r];
        }
    }
    std::copy_n(heights, size, a);
    for (int c = 0; c < size; ++c)
        for (int r = c + 1; r < size; ++r) a[r] -= l[r][c] * a[c];
    for (int r = size - 1; r >= 0; --r) {
        a[r] *= inverse[r];
        for (int k = r + 1; k < size; ++k) a[r] -= l[k][r] * a[k];
    }
    return true;
}

/// Fits the highest degree, up to options.degree, that the points determine; returns it, or 0 if none.
int fit_up_to(const JetOptions& options, const Surroundings& points, double* a) {
    std::fill_n(a, terms(max_degree), 0.0);
    if (options.degree >= 4 && fit<4>(points, a)) return 4;
    if (options.degree >= 3 && fit<3>(points, a)) return 3;
    return fit<2>(points, a) ? 2 : 0;
}

/// Jet of F = z - f(x, y) at x = y = 0, with lengths in units of `scale`.
ImplicitJet jet_of(const double* a) {
    ImplicitJet jet;
    jet.gradient = {-a[1], -a[2], 1.0};
    const double xx = -2.0 * a[3], xy = -a[4], yy = -2.0 * a[5];
    jet.hessian = dmat3(xx, xy, 0, xy, yy, 0, 0, 0, 0);
    const double xxx = -6.0 * a[6], xxy = -2.0 * a[7], xyy = -2.0 * a[8], yyy = -6.0 * a[9];
    jet.third[0] = dmat3(xxx, xxy, 0, xxy, xyy, 0, 0, 0, 0);
    jet.third[1] = dmat3(xxy, xyy, 0, xyy, yyy, 0, 0, 0, 0);
    return jet;
}

Curvature to_object(CurvatureD c, const Surroundings& around) {
    const dmat3 frame(around.t, around.b, around.n);
    c.normal = frame * c.normal;
    c.e1 = frame * c.e1;
    c.e2 = frame * c.e2;
    c.k1 /= around.scale;
    c.k2 /= around.scale;
    for (double& third : c.C) third /= around.scale * around.scale;
    return rounded(c);
}

/// Gathers and fills the neighborhood of vertex v; false if v has no normal or no other point.
bool look_around(const Surface& surface, const Neighbors& neighbors, const JetOptions& options, Index v, Look& look) {
    const vec3 normal = vertex_normal(surface, neighbors, v);
    if (normal == vec3(0.0f)) return false;
    const auto& found =
        look.walk.gather(neighbors, v, options.rings, terms(options.degree) + spare_points, extra_rings);
    look.place(surface, neighbors, found, glm::normalize(dvec3(normal)), options.even);
    return look.around.scale > 0.0;
}

/// Curvature of `count` vertices, the i-th of which is vertex(i).
template <typename Vertex>
Array<Curvature> fit_vertices(const Surface& surface, const Neighbors& neighbors, const JetOptions& options,
                              std::size_t count, const Vertex& vertex) {
    Array<Curvature> result(count);
    tbb::enumerable_thread_specific<Look> looks([&] { return Look(surface.vertex_count()); });
    parallel_blocks(count, 1024, [&](std::size_t, std::size_t begin, std::size_t end) {
        Look& look = looks.local();
        double a[terms(max_degree)];
        for (std::size_t i = begin; i < end; ++i) {
            const Index v = vertex(i);
            result[i] = {};
            if (!look_around(surface, neighbors, options, v, look)) continue;
            fit_up_to(options, look.around, a);
            result[i] = to_object(curvature_of(jet_of(a)), look.around);
        }
    });
    return result;
}

/// RMS residual of the fit at a vertex, in edge lengths; nothing if it is not of the degree asked for with points to
/// spare.
std::optional<double> residual_at(const Surface& surface, const Neighbors& neighbors, const JetOptions& options,
                                  Index v, Look& look) {
    double a[terms(max_degree)], m[terms(max_degree)];
    const Surroundings& around = look.around;
    if (!look_around(surface, neighbors, options, v, look)) return {};
    if (around.count < std::size_t(terms(options.degree) + spare_points)) return {};
    if (fit_up_to(options, around, a) != options.degree) return {};
    double squares = 0.0;
    for (std::size_t i = 0; i < around.count; ++i) {
        monomials<max_degree>(around.x[i], around.y[i], 1.0, m);
        double z = around.z[i];
        for (int k = 0; k < terms(max_degree); ++k) z -= a[k] * m[k];
        squares += z * z;
    }
    const double freedom = double(around.count) - terms(options.degree);
    return std::sqrt(squares / freedom) * around.scale / around.edge_length;
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
