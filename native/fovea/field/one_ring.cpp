// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/field/one_ring.h>

#include <algorithm>
#include <cmath>

#include <fovea/base/parallel.h>
#include <fovea/field/frames.h>
#include <fovea/field/normals.h>

namespace fovea::field {
namespace {

/// A triangle's tangent frame, its second fundamental form (L, M, N) in it, and the areas of its corners.
struct Face {
    vec3 t{0.0f}, b{0.0f};
    vec3 form{0.0f};
    vec3 corner{0.0f};  ///< all zero: the triangle is ignored
};
using Third = vec4;  ///< C(t,t,t), C(t,t,b), C(t,b,b), C(b,b,b)

class OneRing {
   public:
    OneRing(const Surface& surface, const Neighbors& neighbors)
        : surface_(surface), neighbors_(neighbors), normals_(vertex_normals(surface, neighbors)) {}

    Array<Curvature> run() {
        faces_ = parallel_map<Face>(surface_.triangles.size(), [&](std::size_t t) { return face_of(Index(t)); });
        result_ =
            parallel_map<Curvature>(surface_.vertex_count(), [&](std::size_t v) { return second_order(Index(v)); });
        thirds_.resize(faces_.size());
        usable_.resize(faces_.size());
        parallel_for(faces_.size(), [&](std::size_t t) { find_third(Index(t)); });
        parallel_for(result_.size(), [&](std::size_t v) { gather_third(Index(v)); });
        return std::move(result_);
    }

   private:
    /// Whether triangle t is in the smooth sector of its vertex v.
    bool belongs(Index v, Index t) const {
        if (!neighbors_.hard[v]) return true;
        return std::ranges::binary_search(neighbors_.triangles[v], t);
    }

    Face face_of(Index number) const {
        const Triangle& tri = surface_.triangles[number];
        const dvec3 p[3] = {dvec3(surface_.positions[tri.x]), dvec3(surface_.positions[tri.y]),
                            dvec3(surface_.positions[tri.z])};
        Face face;
        const dvec3 e[3] = {p[2] - p[1], p[0] - p[2], p[1] - p[0]};
        const dvec3 across = glm::cross(e[0], e[1]);
        const double size = glm::length(across);
        // Slivers: the directions of their sides are unreliable.
        if (!(size > 1e-9 * (glm::dot(e[0], e[0]) + glm::dot(e[1], e[1]))) || size == HUGE_VAL) return face;
        const dvec3 normal = across / size, t = glm::normalize(e[0]), b = glm::cross(normal, t);
        dvec3 n[3];
        for (int i = 0; i < 3; ++i) {
            n[i] = belongs(tri[i], number) ? dvec3(normals_[tri[i]]) : normal;
            if (n[i] == dvec3(0.0)) n[i] = normal;
        }
        double xx = 0, xy = 0, yy = 0, r0 = 0, r1 = 0, r2 = 0;
        for (int j = 0; j < 3; ++j) {
            const double x = glm::dot(e[j], t), y = glm::dot(e[j], b);
            const dvec3 dn = n[(j + 2) % 3] - n[(j + 1) % 3];
            const double dx = glm::dot(dn, t), dy = glm::dot(dn, b);
            xx += x * x, xy += x * y, yy += y * y;
            r0 += dx * x, r1 += dx * y + dy * x, r2 += dy * y;
        }
        // Normal equations [xx xy 0; xy xx+yy xy; 0 xy yy] by Cramer's rule; determinant (xx + yy)(xx yy - xy^2).
        const double sum = xx + yy, area = xx * yy - xy * xy, determinant = sum * area;
        if (!(determinant > 0.0)) return face;
        const double m = (xx * yy * r1 - xy * yy * r0 - xy * xx * r2) / determinant;
        face.form = vec3(dvec3((r0 - xy * m) / xx, m, (r2 - xy * m) / yy));
        face.t = vec3(t);
        face.b = vec3(b);
        face.corner = vec3(corner_areas(p[0], p[1], p[2]));
        return face;
    }

    /// Calls visit(face, weight, triangle) for the triangles around v with positive weight (corner area).
    template <typename Visit>
    void around(Index v, const Visit& visit) const {
        for (const Index t : neighbors_.triangles[v]) {
            const double weight = faces_[t].corner[corner_of(surface_.triangles[t], v)];
            if (weight > 0.0) visit(faces_[t], weight, t);
        }
    }

    Curvature second_order(Index v) const {
        CurvatureD c{};
        c.normal = dvec3(normals_[v]);
        if (c.normal == dvec3(0.0)) return {};
        const dvec3 p = any_tangent(c.normal), q = glm::cross(c.normal, p);
        double total = 0, pp = 0, pq = 0, qq = 0;
        around(v, [&](const Face& face, double weight, Index) {
            const Turn turn(p, q, c.normal, dvec3(face.t), dvec3(face.b));
            const double l = face.form.x, m = face.form.y, n = face.form.z;
            pp += weight * (turn.pt * turn.pt * l + 2 * turn.pt * turn.pb * m + turn.pb * turn.pb * n);
            pq +=
                weight * (turn.pt * turn.qt * l + (turn.pt * turn.qb + turn.pb * turn.qt) * m + turn.pb * turn.qb * n);
            qq += weight * (turn.qt * turn.qt * l + 2 * turn.qt * turn.qb * m + turn.qb * turn.qb * n);
            total += weight;
        });
        if (total > 0.0) pp /= total, pq /= total, qq /= total;
        set_principal(c, p, q, pp, pq, qq);
        return rounded(c);
    }

    void find_third(Index number) {
        usable_[number] = 0;
        thirds_[number] = Third(0.0f);
        const Face& face = faces_[number];
        if (face.t == vec3(0.0f)) return;
        const Triangle& tri = surface_.triangles[number];
        const dvec3 t(face.t), b(face.b);
        dvec3 form[3];
        for (int i = 0; i < 3; ++i) {
            if (!belongs(tri[i], number)) return;
            const Curvature& c = result_[tri[i]];
            const Turn turn(dvec3(c.e1), dvec3(c.e2), dvec3(c.normal), t, b);
            form[i] = turned_form(c, turn);
        }
        double xx = 0, xy = 0, yy = 0, r[4] = {};
        for (int j = 0; j < 3; ++j) {
            const Index from = (j + 1) % 3, to = (j + 2) % 3;
            const dvec3 e = dvec3(surface_.positions[tri[to]]) - dvec3(surface_.positions[tri[from]]),
                        d = form[to] - form[from];
            const double x = glm::dot(e, t), y = glm::dot(e, b);
            xx += x * x, xy += x * y, yy += y * y;
            r[0] += x * d.x, r[1] += y * d.x + 2 * x * d.y, r[2] += 2 * y * d.y + x * d.z, r[3] += y * d.z;
        }
        // Normal equations [X Z 0 0; Z 2X+Y 2Z 0; 0 2Z X+2Y Z; 0 0 Z Y]: tridiagonal and positive definite.
        const double diagonal[4] = {xx, 2 * xx + yy, xx + 2 * yy, yy}, beside[3] = {xy, 2 * xy, xy};
        double pivot[4] = {diagonal[0]};
        for (int i = 1; i < 4; ++i) {
            if (!(pivot[i - 1] > 0.0)) return;
            const double factor = beside[i - 1] / pivot[i - 1];
            pivot[i] = diagonal[i] - factor * beside[i - 1];
            r[i] -= factor * r[i - 1];
        }
        if (!(pivot[3] > 0.0)) return;
        r[3] /= pivot[3];
        for (int i = 2; i >= 0; --i) r[i] = (r[i] - beside[i] * r[i + 1]) / pivot[i];
        thirds_[number] = Third(glm::dvec4(r[0], r[1], r[2], r[3]));
        usable_[number] = 1;
    }

    void gather_third(Index v) {
        Curvature& c = result_[v];
        double sum[4] = {}, total = 0.0;
        around(v, [&](const Face& face, double weight, Index t) {
            if (!usable_[t]) return;
            const Turn turn(dvec3(c.e1), dvec3(c.e2), dvec3(c.normal), dvec3(face.t), dvec3(face.b));
            const Third& of = thirds_[t];
            // Contract two vectors at a time: C(x, y, .) as a covector, then with z.
            const auto third = [&](double xt, double xb, double yt, double yb, double zt, double zb) {
                const double tt = xt * yt, tb = xt * yb + xb * yt, bb = xb * yb;
                return (of.x * tt + of.y * tb + of.z * bb) * zt + (of.y * tt + of.z * tb + of.w * bb) * zb;
            };
            sum[0] += weight * third(turn.pt, turn.pb, turn.pt, turn.pb, turn.pt, turn.pb);
            sum[1] += weight * third(turn.pt, turn.pb, turn.pt, turn.pb, turn.qt, turn.qb);
            sum[2] += weight * third(turn.pt, turn.pb, turn.qt, turn.qb, turn.qt, turn.qb);
            sum[3] += weight * third(turn.qt, turn.qb, turn.qt, turn.qb, turn.qt, turn.qb);
            total += weight;
        });
        for (int i = 0; i < 4; ++i) c.C[i] = total > 0.0 ? static_cast<float>(sum[i] / total) : 0.0f;
    }

    const Surface& surface_;
    const Neighbors& neighbors_;
    Array<vec3> normals_;
    Array<Face> faces_;
    Array<Curvature> result_;
    Array<Third> thirds_;
    Array<std::uint8_t> usable_;
};

}  // namespace

Array<Curvature> one_ring_curvature(const Surface& surface, const Neighbors& neighbors) {
    return OneRing(surface, neighbors).run();
}

}  // namespace fovea::field
