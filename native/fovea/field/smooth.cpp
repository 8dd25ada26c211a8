// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/field/smooth.h>

#include <cmath>
#include <tbb/enumerable_thread_specific.h>

#include <fovea/base/elementary.h>
#include <fovea/base/parallel.h>
#include <fovea/field/frames.h>
#include <fovea/field/normals.h>
#include <fovea/field/walk.h>

namespace fovea::field {
namespace {

/// Cutoff of the Gaussian, in standard deviations.
constexpr double reach = 2.5;

/// Tensors of a point in the frame (t, b): h(t, t), h(t, b), h(b, b) and C(t, t, t) .. C(b, b, b).
struct Tensors {
    dvec3 h{0.0};
    double C[4] = {};

    void add(const Curvature& c, const Turn& turn, double weight) {
        h += weight * turned_form(c, turn);
        // Contract C with one direction after another, given by its components along e1 and e2.
        const auto along = [&](double x, double y, double(&out)[3]) {
            for (int i = 0; i < 3; ++i) out[i] = c.C[i] * x + c.C[i + 1] * y;
        };
        const auto form = [](const double(&m)[3], double ax, double ay, double bx, double by) {
            return m[0] * ax * bx + m[1] * (ax * by + ay * bx) + m[2] * ay * by;
        };
        double of_t[3], of_b[3];
        along(turn.pt, turn.qt, of_t);
        along(turn.pb, turn.qb, of_b);
        C[0] += weight * form(of_t, turn.pt, turn.qt, turn.pt, turn.qt);
        C[1] += weight * form(of_t, turn.pt, turn.qt, turn.pb, turn.qb);
        C[2] += weight * form(of_t, turn.pb, turn.qb, turn.pb, turn.qb);
        C[3] += weight * form(of_b, turn.pb, turn.qb, turn.pb, turn.qb);
    }
};

double mean_edge(const Surface& surface, const Neighbors& neighbors, Index v) {
    double sum = 0.0;
    for (const Index w : neighbors.vertices[v])
        sum += glm::distance(dvec3(surface.positions[v]), dvec3(surface.positions[w]));
    const Index count = neighbors.vertices.size(v);
    return count > 0 ? sum / count : 0.0;
}

/// Principal directions and curvatures of the mean tensors (sums over `total`), and C in that frame.
Curvature principal(const Tensors& sum, double total, const dvec3& n, const dvec3& t, const dvec3& b) {
    CurvatureD c{};
    c.normal = n;
    set_principal(c, t, b, sum.h[0] / total, sum.h[1] / total, sum.h[2] / total);
    Curvature unturned{};
    for (int i = 0; i < 4; ++i) unturned.C[i] = static_cast<float>(sum.C[i] / total);
    Tensors turned;
    turned.add(unturned, Turn(t, b, n, c.e1, c.e2), 1.0);
    for (int i = 0; i < 4; ++i) c.C[i] = turned.C[i];
    return rounded(c);
}

}  // namespace

Array<Curvature> smooth(const Surface& surface, const Neighbors& neighbors, const Array<Curvature>& curvature,
                        double deviation) {
    const Array<float> areas = vertex_areas(surface, neighbors);
    const int rings = static_cast<int>(std::ceil(reach * deviation));
    Array<Curvature> result(curvature.size());
    tbb::enumerable_thread_specific<Walk> walks([&] { return Walk(surface.vertex_count()); });
    parallel_blocks(result.size(), 1024, [&](std::size_t, std::size_t begin, std::size_t end) {
        Walk& walk = walks.local();
        for (Index v = static_cast<Index>(begin); v < end; ++v) {
            const Curvature& here = result[v] = curvature[v];
            const double scale = deviation * mean_edge(surface, neighbors, v);
            if (here.normal == vec3(0.0f) || !(scale > 0.0 && scale < HUGE_VAL)) continue;
            const dvec3 n(here.normal), t(here.e1), b = glm::cross(n, t);
            Tensors sum;
            double total = 0.0;
            for (const Index w : walk.gather(neighbors, v, rings)) {
                if (w != v && neighbors.hard[w]) continue;
                const Curvature& c = curvature[w];
                const dvec3 d = (dvec3(surface.positions[w]) - dvec3(surface.positions[v])) / scale;
                const double distance2 = glm::dot(d, d), agreement = glm::dot(n, dvec3(c.normal));
                if (!(distance2 <= reach * reach) || !(agreement > 0.0)) continue;
                const double weight = exponential(-0.5 * distance2) * areas[w] * agreement;
                sum.add(c, Turn(dvec3(c.e1), dvec3(c.e2), dvec3(c.normal), t, b), weight);
                total += weight;
            }
            // Sums that overflow, on an enormous mesh: the vertex keeps its value.
            const bool known = total > 0.0 && std::isfinite(sum.h[0] + sum.h[1] + sum.h[2]) &&
                               std::isfinite(sum.C[0] + sum.C[1] + sum.C[2] + sum.C[3]);
            if (known) result[v] = principal(sum, total, n, t, b);
        }
    });
    return result;
}

}  // namespace fovea::field
