// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/visibility/sampled.h>

#include <fovea/base/check.h>
#include <fovea/visibility/triangle_edges.h>

namespace fovea::visibility {
namespace formulas {

using namespace glm;

struct Depth : Edges {
    /// The two facets at a line's edge, and its steepness (OwnSides).
    struct Line {
        Index facet0, facet1;
        float steepness;
    };

    const DepthBuffer& buffer;
    vec2 border;
    float buffer_scale, slack_px, bias;
    int probes;

    Depth(const DepthBuffer& looked_into, const SampledOptions& options)
        : buffer(looked_into),
          border(looked_into.border_x, looked_into.border_y),
          buffer_scale(float(looked_into.scale)),
          slack_px(options.slack_px),
          bias(options.bias),
          probes(options.probes) {}

    const DepthTexel& texel_at(ivec2 place) const { return buffer.at(place.x, place.y); }
    int depth_shows(ivec2 place, const Line& line) const {
        const Index facet = texel_at(place).facet;
        return facet == none ? -1 : facet == line.facet0 || facet == line.facet1 ? 1 : 0;
    }
    vec3 depth_plane(ivec2 place) const {
        const DepthTexel& texel = texel_at(place);
        return {texel.depth, texel.ddx, texel.ddy};
    }
    vec2 depth_edges(ivec2 place) const { return texel_at(place).edges; }
    ivec2 depth_size() const { return {buffer.width, buffer.height}; }

#include <shared/depth.glsl>
};

}  // namespace formulas

namespace {

constexpr int max_probes = 16;

/// A segment as the probes read it.
struct SeenSegment {
    vec3 first, last;  ///< px, depth
    formulas::Depth::Line line;
};

SeenSegment segment_of(const ClippedPaths& clipped, const OwnSides& sides, Index i) {
    return {vec3(clipped.px[i], clipped.depth[i]),
            vec3(clipped.px[i + 1], clipped.depth[i + 1]),
            {clipped.facet0[i], clipped.facet1[i], sides.in_tables(i)}};
}

/// Computes the samples of piece q.
void fill_piece(const ClippedPaths& clipped, const OwnSides& sides, Index q, formulas::Depth& look,
                Array<float>& visibility) {
    for (Index i = clipped.pieces.begin(q); i + 1 < clipped.pieces.end(q); ++i) {
        const Index count = clipped.sample_count[i];
        const SeenSegment seen = segment_of(clipped, sides, i);
        for (Index j = 0; j < count; ++j) {
            const vec2 middle = glm::mix(vec2(seen.first), vec2(seen.last), (float(j) + 0.5f) / float(count));
            if (look.buffer.decides(middle))
                visibility[clipped.sample_start[i] + j] = look.depth_share(
                    seen.line, seen.first, seen.last, float(j) / float(count), float(j + 1) / float(count));
        }
    }
}

}  // namespace

void check_sampled(const DepthBuffer& buffer, const SampledOptions& options) {
    check(options.probes >= 1 && options.probes <= max_probes, "sampled visibility: 1 to 16 probes expected");
    check(buffer.width > 0 && buffer.height > 0, "sampled visibility: the depth buffer is empty");
}

Array<float> sampled_visibility(const ClippedPaths& clipped, const OwnSides& sides, const DepthBuffer& buffer,
                                const SampledOptions& options, const Cancel* cancel) {
    check_sampled(buffer, options);
    check_sides(clipped, sides, "sampled visibility");
    Array<float> visibility(clipped.samples, 0.0f);
    parallel_blocks(clipped.pieces.count(), 64, [&](auto, std::size_t begin, std::size_t end) {
        if (cancel) cancel->poll();
        formulas::Depth look(buffer, options);
        for (Index q = Index(begin); q < end; ++q) fill_piece(clipped, sides, q, look, visibility);
    });
    return visibility;
}

float visibility_between(const ClippedPaths& clipped, const OwnSides& sides, Index segment, float t0, float t1,
                         const DepthBuffer& buffer, const SampledOptions& options) {
    const SeenSegment seen = segment_of(clipped, sides, segment);
    return formulas::Depth(buffer, options).depth_share(seen.line, seen.first, seen.last, t0, t1);
}

}  // namespace fovea::visibility
