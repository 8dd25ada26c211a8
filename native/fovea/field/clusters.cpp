// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/field/clusters.h>

#include <algorithm>
#include <cmath>
#include <tbb/enumerable_thread_specific.h>

#include <fovea/base/parallel.h>

namespace fovea::field {
namespace {

/// Exceeds the relative rounding error of float arithmetic over one cluster.
constexpr double rounding = 1e-5;

/// Orders triangles so that each run of triangles_of_cluster of them is compact: recursive median splits along the
/// longest side of the bounding box of their centroids.
class Order {
   public:
    explicit Order(const Surface& surface)
        : placed_(parallel_map<Placed>(surface.triangles.size(), [&](std::size_t t) -> Placed {
              const Triangle& c = surface.triangles[t];
              // Dividing first avoids overflow.
              const auto third = [&](Index v) { return surface.positions[v] / 3.0f; };
              return {third(c.x) + third(c.y) + third(c.z), static_cast<Index>(t)};
          })) {
        split(0, placed_.size());
    }
    Array<Index> triangles() const {
        return parallel_map<Index>(placed_.size(), [&](std::size_t i) { return placed_[i].triangle; });
    }

   private:
    struct Placed {
        vec3 middle;
        Index triangle;
    };

    void split(std::size_t begin, std::size_t end) {
        const std::size_t clusters = (end - begin + triangles_of_cluster - 1) / triangles_of_cluster;
        if (clusters < 2) return;
        vec3 low = placed_[begin].middle, high = low;
        for (std::size_t i = begin; i < end; ++i) {
            low = glm::min(low, placed_[i].middle);
            high = glm::max(high, placed_[i].middle);
        }
        const vec3 size = high - low;
        const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
        const std::size_t middle = begin + (clusters + 1) / 2 * triangles_of_cluster;
        // Ties are broken by index, so that the order is unique.
        std::nth_element(placed_.begin() + begin, placed_.begin() + middle, placed_.begin() + end,
                         [axis](const Placed& a, const Placed& b) {
                             const float x = a.middle[axis], y = b.middle[axis];
                             return x != y ? x < y : a.triangle < b.triangle;
                         });
        if (clusters > 16)
            parallel_invoke([&] { split(begin, middle); }, [&] { split(middle, end); });
        else
            split(begin, middle), split(middle, end);
    }

    Array<Placed> placed_;
};

/// Numbers the vertices of one cluster in order of first appearance.
struct Numbering {
    explicit Numbering(Index vertices) : stamp(vertices, none), number(vertices) {}
    Array<Index> stamp;
    Array<std::uint16_t> number;
};

Clusters make_clusters(const Surface& surface) {
    const Index count = static_cast<Index>(surface.triangles.size());
    Clusters clusters;
    clusters.triangles = Order(surface).triangles();
    clusters.corners.resize(count);
    const Index all = (count + triangles_of_cluster - 1) / triangles_of_cluster;
    std::vector<std::vector<Index>> vertices(all);
    tbb::enumerable_thread_specific<Numbering> numberings([&] { return Numbering(surface.vertex_count()); });
    parallel_blocks(count, triangles_of_cluster, [&](std::size_t c, std::size_t begin, std::size_t end) {
        Numbering& known = numberings.local();
        std::sort(clusters.triangles.begin() + begin, clusters.triangles.begin() + end);
        for (std::size_t i = begin; i < end; ++i)
            for (int k = 0; k < 3; ++k) {
                const Index v = surface.triangles[clusters.triangles[i]][k];
                if (known.stamp[v] != c) {
                    known.stamp[v] = static_cast<Index>(c);
                    known.number[v] = static_cast<std::uint16_t>(vertices[c].size());
                    vertices[c].push_back(v);
                }
                clusters.corners[i][k] = known.number[v];
            }
    });
    Array<Index> counts(all);
    for (Index c = 0; c < all; ++c) counts[c] = static_cast<Index>(vertices[c].size());
    clusters.vertices = lists_from(std::move(counts), [&](Index c) { return vertices[c].begin(); });
    return clusters;
}

/// The bounded quantities, at a vertex or as the mean of many; in double precision, so that squares do not underflow.
/// `straight` and `mixed`: diagonal and off-diagonal entries of the form h.
struct Sample {
    dvec3 place{0.0}, normal{0.0}, straight{0.0}, mixed{0.0}, laplacian{0.0};

    Sample() = default;
    Sample(const vec3& p, const Curvature& c) : place(p), normal(c.normal) {
        const dvec3 e1(c.e1), e2(c.e2);
        const double k1 = c.k1, k2 = c.k2;
        straight = k1 * e1 * e1 + k2 * e2 * e2;
        mixed = k1 * dvec3(e1.x * e1.y, e1.x * e1.z, e1.y * e1.z) + k2 * dvec3(e2.x * e2.y, e2.x * e2.z, e2.y * e2.z);
        laplacian = double(c.C[0] + c.C[2]) * e1 + double(c.C[1] + c.C[3]) * e2 - (k1 * k1 + k2 * k2) * normal;
    }
    explicit Sample(const ClusterBounds& b)
        : place(b.center), normal(b.normal), straight(b.form[0]), mixed(b.form[1]), laplacian(b.laplacian) {}
};

/// Accumulates bounds in two passes over the same samples: add() for the mean, then add_spread() for the spread.
class Bounding {
   public:
    void add(const Sample& f, double curvature, double third) {
        low_ = count_ ? glm::min(low_, f.place) : f.place;
        high_ = count_ ? glm::max(high_, f.place) : f.place;
        middle_.normal += f.normal;
        middle_.straight += f.straight;
        middle_.mixed += f.mixed;
        middle_.laplacian += f.laplacian;
        curvature_ = std::max(curvature_, curvature);
        third_ = std::max(third_, third);
        ++count_;
    }

    /// The mean, rounded to the single precision in which it is stored, so that spreads are measured from that.
    void end_of_first_round() {
        const double share = 1.0 / count_;
        bounds_.center = vec3(0.5 * (low_ + high_));
        bounds_.normal = vec3(share * middle_.normal);
        bounds_.form[0] = vec3(share * middle_.straight);
        bounds_.form[1] = vec3(share * middle_.mixed);
        bounds_.laplacian = vec3(share * middle_.laplacian);
        middle_ = Sample(bounds_);
    }

    /// `own`: bounds of the samples around f that f is the mean of.
    void add_spread(const Sample& f, const ClusterBounds& own = {}) {
        const auto reach = [](double& most, double spread, double squared) {
            most = std::max(most, spread + std::sqrt(squared));
        };
        const auto squared = [](const dvec3& d) { return glm::dot(d, d); };
        reach(radius_, own.radius, squared(f.place - middle_.place));
        reach(normal_, own.normal_spread, squared(f.normal - middle_.normal));
        reach(form_, own.form_spread, squared(f.straight - middle_.straight) + 2.0 * squared(f.mixed - middle_.mixed));
        reach(laplacian_, own.laplacian_spread, squared(f.laplacian - middle_.laplacian));
    }

    ClusterBounds take() const {
        ClusterBounds b = bounds_;
        const auto up = [](double length, double scale) {
            return static_cast<float>(length + rounding * (length + scale));
        };
        b.radius = up(radius_, 0.1 * glm::length(middle_.place));
        b.normal_spread = up(normal_, 1.0);
        b.form_spread = up(form_, curvature_);
        b.laplacian_spread = up(laplacian_, 2.0 * third_ + 2.0 * curvature_ * curvature_);
        b.curvature = up(curvature_, 0.0);
        b.third = up(third_, 0.0);
        const vec3 all = b.center + b.normal + b.form[0] + b.form[1] + b.laplacian;
        if (!std::isfinite(all.x + all.y + all.z + b.radius + b.form_spread + b.laplacian_spread))
            b.radius = b.normal_spread = b.form_spread = b.laplacian_spread = b.curvature = b.third = HUGE_VALF;
        return b;  // not finite: unbounded
    }

   private:
    int count_ = 0;
    dvec3 low_{0.0}, high_{0.0};
    Sample middle_;
    double curvature_ = 0.0, third_ = 0.0, radius_ = 0.0, normal_ = 0.0, form_ = 0.0, laplacian_ = 0.0;
    ClusterBounds bounds_{};
};

/// Upper bound of C(x, x, x) over unit tangents x: the Frobenius norm of the tensor.
double norm_of_third(const Curvature& c) {
    const double c0 = c.C[0], c1 = c.C[1], c2 = c.C[2], c3 = c.C[3];
    return std::sqrt(c0 * c0 + 3.0 * (c1 * c1 + c2 * c2) + c3 * c3);
}

ClusterBounds bounds_of(const Surface& surface, const Array<Curvature>& curvature, In<Index> vertices) {
    Sample fields[3 * triangles_of_cluster];
    Bounding bounding;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        const Curvature& c = curvature[vertices[i]];
        fields[i] = Sample(surface.positions[vertices[i]], c);
        bounding.add(fields[i], std::abs(c.k1), norm_of_third(c));
    }
    bounding.end_of_first_round();
    for (std::size_t i = 0; i < vertices.size(); ++i) bounding.add_spread(fields[i]);
    return bounding.take();
}

ClusterBounds bounds_of(In<ClusterBounds> parts) {
    Bounding bounding;
    for (const ClusterBounds& part : parts) bounding.add(Sample(part), part.curvature, part.third);
    bounding.end_of_first_round();
    for (const ClusterBounds& part : parts) bounding.add_spread(Sample(part), part);
    return bounding.take();
}

}  // namespace

std::shared_ptr<const Clusters> clusters_of(const Surface& surface) {
    return surface.cache().get<Clusters>(0, [&] { return make_clusters(surface); });
}

std::shared_ptr<const Hierarchy> hierarchy_of(const Surface& surface) {
    const FieldOptions& options = surface.field_options();
    return surface.cache().get<Hierarchy>(hash_of(options), [&] {
        const auto clusters = clusters_of(surface);
        const auto fields = fields_of(surface, options);
        Hierarchy hierarchy;
        hierarchy.clusters.resize(clusters->count());
        hierarchy.groups.resize((clusters->count() + Hierarchy::group - 1) / Hierarchy::group);
        parallel_blocks(clusters->count(), Hierarchy::group, [&](std::size_t g, std::size_t begin, std::size_t end) {
            for (std::size_t c = begin; c < end; ++c)
                hierarchy.clusters[c] = bounds_of(surface, fields->curvature, clusters->vertices[Index(c)]);
            hierarchy.groups[g] = bounds_of(In<ClusterBounds>(hierarchy.clusters).subspan(begin, end - begin));
        });
        return hierarchy;
    });
}

}  // namespace fovea::field
