#include "field/clusters.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <cmath>

#include "base/parallel.h"

namespace fovea {
namespace {

/// More than float arithmetic loses over one cluster.
constexpr float rounding = 1e-5f;

/// Orders triangles so that every run of triangles_of_cluster of them lies together: halves at the median along the
/// longest side of the box around their middles, again and again.
class Order {
   public:
    explicit Order(const Surface& surface) : middles_(surface.triangles.size()), triangles_(middles_.size()) {
        parallel_for(middles_.size(), [&](std::size_t t) {
            const Triangle& c = surface.triangles[t];
            middles_[t] = (surface.positions[c.x] + surface.positions[c.y] + surface.positions[c.z]) / 3.0f;
            triangles_[t] = static_cast<Index>(t);
        });
        split(0, triangles_.size());
    }
    Array<Index> take() { return std::move(triangles_); }

   private:
    void split(std::size_t begin, std::size_t end) {
        const std::size_t clusters = (end - begin + triangles_of_cluster - 1) / triangles_of_cluster;
        if (clusters < 2) return;
        vec3 low = middles_[triangles_[begin]], high = low;
        for (std::size_t i = begin; i < end; ++i) {
            low = glm::min(low, middles_[triangles_[i]]);
            high = glm::max(high, middles_[triangles_[i]]);
        }
        const vec3 size = high - low;
        const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
        const std::size_t middle = begin + (clusters + 1) / 2 * triangles_of_cluster;
        // By numbers where they are equal, so that the order is one.
        std::nth_element(triangles_.begin() + begin, triangles_.begin() + middle, triangles_.begin() + end,
                         [&](Index a, Index b) {
                             const float x = middles_[a][axis], y = middles_[b][axis];
                             return x != y ? x < y : a < b;
                         });
        if (clusters > 16)
            tbb::parallel_invoke([&] { split(begin, middle); }, [&] { split(middle, end); });
        else
            split(begin, middle), split(middle, end);
    }

    Array<vec3> middles_;
    Array<Index> triangles_;
};

/// Numbers the vertices of one cluster in the order in which its triangles name them.
struct Numbering {
    explicit Numbering(Index vertices) : stamp(vertices, none), number(vertices) {}
    Array<Index> stamp;
    Array<std::uint16_t> number;
};

Clusters make_clusters(const Surface& surface) {
    const Index count = static_cast<Index>(surface.triangles.size());
    Clusters clusters;
    clusters.triangles = Order(surface).take();
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
    clusters.vertex_rows.offsets.resize(all);
    for (Index c = 0; c < all; ++c) clusters.vertex_rows.offsets[c] = static_cast<Index>(vertices[c].size());
    counts_to_offsets(clusters.vertex_rows.offsets);
    clusters.vertices.resize(clusters.vertex_rows.offsets.back());
    parallel_for(all, [&](std::size_t c) {
        std::copy(vertices[c].begin(), vertices[c].end(), clusters.vertices.begin() + clusters.vertex_rows.begin(Index(c)));
    }, 64);
    return clusters;
}

/// h on object space: xx, yy, zz, xy, xz, yz.
struct Form {
    vec3 straight{0.0f}, mixed{0.0f};
    explicit Form(const Curvature& c)
        : straight(c.k1 * c.e1 * c.e1 + c.k2 * c.e2 * c.e2),
          mixed(c.k1 * c.e1.x * c.e1.y + c.k2 * c.e2.x * c.e2.y, c.k1 * c.e1.x * c.e1.z + c.k2 * c.e2.x * c.e2.z,
                c.k1 * c.e1.y * c.e1.z + c.k2 * c.e2.y * c.e2.z) {}
};

vec3 laplacian_of_normal(const Curvature& c) {
    return (c.C[0] + c.C[2]) * c.e1 + (c.C[1] + c.C[3]) * c.e2 - (c.k1 * c.k1 + c.k2 * c.k2) * c.normal;
}

/// No less than C(x, x, x) of any unit tangent: its norm as a tensor.
float norm_of_third(const Curvature& c) {
    return std::sqrt(c.C[0] * c.C[0] + 3.0f * (c.C[1] * c.C[1] + c.C[2] * c.C[2]) + c.C[3] * c.C[3]);
}

ClusterBounds rounded_up(ClusterBounds b) {
    const auto up = [](float& length, float scale) { length += rounding * (length + scale); };
    up(b.radius, 0.1f * glm::length(b.center));
    up(b.normal_spread, 1.0f);
    up(b.form_spread, b.curvature);
    up(b.laplacian_spread, 2.0f * b.third + 2.0f * b.curvature * b.curvature);
    up(b.curvature, 0.0f);
    up(b.third, 0.0f);
    const vec3 all = b.center + b.normal + b.form[0] + b.form[1] + b.laplacian;
    if (!std::isfinite(all.x + all.y + all.z + b.radius + b.form_spread + b.laplacian_spread))
        b.radius = b.normal_spread = b.form_spread = b.laplacian_spread = b.curvature = b.third = HUGE_VALF;
    return b;  // without bounds on an enormous mesh
}

ClusterBounds bounds_of(const Surface& surface, const Array<Curvature>& curvature, In<Index> vertices) {
    ClusterBounds b{};
    vec3 low(surface.positions[vertices[0]]), high = low;
    for (Index v : vertices) {
        const Curvature& c = curvature[v];
        const Form form(c);
        low = glm::min(low, surface.positions[v]);
        high = glm::max(high, surface.positions[v]);
        b.normal += c.normal;
        b.form[0] += form.straight;
        b.form[1] += form.mixed;
        b.laplacian += laplacian_of_normal(c);
        b.curvature = std::max(b.curvature, std::abs(c.k1));
        b.third = std::max(b.third, norm_of_third(c));
    }
    const float share = 1.0f / static_cast<float>(vertices.size());
    b.center = 0.5f * (low + high);
    b.normal *= share;
    b.form[0] *= share;
    b.form[1] *= share;
    b.laplacian *= share;
    const auto longest = [](float& most, const vec3& d) { most = std::max(most, glm::dot(d, d)); };
    for (Index v : vertices) {
        const Curvature& c = curvature[v];
        const Form form(c);
        longest(b.radius, surface.positions[v] - b.center);
        longest(b.normal_spread, c.normal - b.normal);
        longest(b.laplacian_spread, laplacian_of_normal(c) - b.laplacian);
        const vec3 straight = form.straight - b.form[0], mixed = form.mixed - b.form[1];
        b.form_spread = std::max(b.form_spread, glm::dot(straight, straight) + 2.0f * glm::dot(mixed, mixed));
    }
    b.radius = std::sqrt(b.radius);
    b.normal_spread = std::sqrt(b.normal_spread);
    b.form_spread = std::sqrt(b.form_spread);
    b.laplacian_spread = std::sqrt(b.laplacian_spread);
    return rounded_up(b);
}

/// Of several clusters together.
ClusterBounds bounds_of(In<ClusterBounds> parts) {
    ClusterBounds b{};
    const float share = 1.0f / static_cast<float>(parts.size());
    for (const ClusterBounds& part : parts) {
        b.center += share * part.center;
        b.normal += share * part.normal;
        b.form[0] += share * part.form[0];
        b.form[1] += share * part.form[1];
        b.laplacian += share * part.laplacian;
        b.curvature = std::max(b.curvature, part.curvature);
        b.third = std::max(b.third, part.third);
    }
    for (const ClusterBounds& part : parts) {
        const auto reach = [](float& most, float spread, float squared) { most = std::max(most, spread + std::sqrt(squared)); };
        const auto squared = [](const vec3& d) { return glm::dot(d, d); };
        reach(b.radius, part.radius, squared(part.center - b.center));
        reach(b.normal_spread, part.normal_spread, squared(part.normal - b.normal));
        reach(b.form_spread, part.form_spread, squared(part.form[0] - b.form[0]) + 2.0f * squared(part.form[1] - b.form[1]));
        reach(b.laplacian_spread, part.laplacian_spread, squared(part.laplacian - b.laplacian));
    }
    return rounded_up(b);
}

}  // namespace

std::shared_ptr<const Clusters> clusters_of(const Surface& surface) {
    return surface.cache().get<Clusters>(0, [&] { return make_clusters(surface); });
}

std::shared_ptr<const Hierarchy> hierarchy_of(const Surface& surface, const FieldOptions& options) {
    return surface.cache().get<Hierarchy>(key_of(options), [&] {
        const auto clusters = clusters_of(surface);
        const auto fields = fields_of(surface, options);
        Hierarchy hierarchy;
        hierarchy.clusters.resize(clusters->count());
        hierarchy.groups.resize((clusters->count() + Hierarchy::group - 1) / Hierarchy::group);
        parallel_blocks(clusters->count(), Hierarchy::group, [&](std::size_t g, std::size_t begin, std::size_t end) {
            for (std::size_t c = begin; c < end; ++c)
                hierarchy.clusters[c] = bounds_of(surface, fields->curvature, clusters->vertices_of(Index(c)));
            hierarchy.groups[g] = bounds_of(In<ClusterBounds>(hierarchy.clusters).subspan(begin, end - begin));
        });
        return hierarchy;
    });
}

}  // namespace fovea
