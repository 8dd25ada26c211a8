// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/path/chain.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <fovea/base/elementary.h>
#include <fovea/base/parallel.h>
#include <fovea/path/ends.h>

namespace fovea::path {
namespace {

constexpr Index most_lines_at_a_vertex = 32;

/// Edge end: end `side` of the k-th edge is 2k + side; flipping the last bit gives the edge's other end.
using End = Index;

/// Per edge end: the end of another edge that it is linked to, or `none`.
class Links {
   public:
    Links(const SurfaceView& seen, bool in_image, In<Index> edges, In<std::uint8_t> labels, In<double> corner_angle_rad)
        : seen_(seen), in_image_(in_image), edges_(edges), labels_(labels), link_(edges.size() * 2, none) {
        // -2 for angles of pi or more: rounding may give cosines slightly below -1.
        for (double angle : corner_angle_rad)
            least_cosine_.push_back(angle < std::numbers::pi ? static_cast<float>(cosine(angle)) : -2.0f);
        at_vertex_ = lists_of<End>(seen_.surface.vertex_count(), [&](const auto& give) {
            for (End end = 0; end < link_.size(); ++end) give(vertex(end), end);
        });
        parallel_for(seen_.surface.vertex_count(), [&](std::size_t v) { link_vertex(static_cast<Index>(v)); });
    }

    const Array<End>& next() const { return link_; }
    Index vertex(End end) const { return seen_.surface.edges[edges_[end / 2]][end % 2]; }

   private:
    /// Unit vector along the edge, away from this end; zero for an edge of zero length.
    vec3 direction(End end) const {
        const dvec3 here(seen_.surface.positions[vertex(end)]), there(seen_.surface.positions[vertex(end ^ 1)]);
        const dvec3 d = in_image_ ? image_direction(here, there) : there - here;
        const double length = glm::length(d);
        return length > 0.0 ? vec3(d / length) : vec3(0.0f);
    }

    /// Direction in the image from one point to another (not normalized); in view space if one is behind the eye.
    dvec3 image_direction(const dvec3& here, const dvec3& there) const {
        const dvec3 a(seen_.object_to_view * dvec4(here, 1.0)), b(seen_.object_to_view * dvec4(there, 1.0));
        if (seen_.orthographic) return {b.x - a.x, b.y - a.y, 0.0};
        if (a.z >= 0.0 || b.z >= 0.0) return b - a;
        return {b.x * a.z - a.x * b.z, b.y * a.z - a.y * b.z, 0.0};
    }

    void link_vertex(Index v) {
        const In<End> ends = at_vertex_[v];
        const Index count = at_vertex_.size(v);
        if (count < 2 || count > most_lines_at_a_vertex) return;
        struct Pair {
            float cosine;  // of the turn: 1 is straight on
            End a, b;
        };
        Pair pairs[most_lines_at_a_vertex * (most_lines_at_a_vertex - 1) / 2];
        vec3 directions[most_lines_at_a_vertex];
        for (Index i = 0; i < count; ++i) directions[i] = direction(ends[i]);
        Index found = 0;
        for (Index i = 0; i < count; ++i) {
            for (Index j = i + 1; j < count; ++j) {
                const End a = ends[i], b = ends[j];
                const auto label = labels_[a / 2];
                if (label != labels_[b / 2] || a / 2 == b / 2) continue;
                const float cosine = -glm::dot(directions[i], directions[j]);
                if (cosine >= least_cosine_[label]) pairs[found++] = {cosine, a, b};
            }
        }
        std::stable_sort(pairs, pairs + found, [](const Pair& x, const Pair& y) { return x.cosine > y.cosine; });
        for (const Pair* pair = pairs; pair != pairs + found; ++pair) {
            if (link_[pair->a] != none || link_[pair->b] != none) continue;
            link_[pair->a] = pair->b;
            link_[pair->b] = pair->a;
        }
    }

    const SurfaceView& seen_;
    const bool in_image_;
    In<Index> edges_;
    In<std::uint8_t> labels_;
    Array<End> link_;
    std::vector<float> least_cosine_;
    Lists<End> at_vertex_;
};

}  // namespace

Chains chain(const SurfaceView& seen, bool in_image, In<Index> edges, In<std::uint8_t> labels,
             In<double> corner_angle_rad) {
    const Links links(seen, in_image, edges, labels, corner_angle_rad);
    Chains chains;
    chains.vertex.reserve(edges.size() * 2);
    chains.edge.reserve(edges.size() * 2);
    chains.number.reserve(edges.size() * 2);
    Index anchor = none;
    std::uint8_t label = 0;
    const auto add = [&](End end) {
        anchor = std::min(anchor, edges[end / 2]);
        label = labels[end / 2];
        chains.vertex.push_back(links.vertex(end));
        chains.edge.push_back(edges[end / 2]);
        chains.number.push_back(end / 2);
    };
    const auto finish = [&](bool closed) {
        chains.rows.offsets.push_back(static_cast<Index>(chains.vertex.size()));
        chains.closed.push_back(closed);
        chains.label.push_back(label);
        chains.anchor.push_back(std::exchange(anchor, none));
    };
    walk_ends(links.next(), add, finish);
    return chains;
}

}  // namespace fovea::path
