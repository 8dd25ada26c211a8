#include "atlas/sampled.h"

#include <array>
#include <cmath>

#include "atlas/layout.h"
#include "base/check.h"

namespace fovea {
namespace {

constexpr int max_probes = 16;

/// Where the probes of a sample lie: (along the line, across it), pixels; the sample itself first, then evenly spread
/// (the R2 sequence) over a square of one pixel.
vec2 probe_offset(int probe) {
    const vec2 p = float(probe) * vec2(0.7548777f, 0.5698403f) + 0.5f;
    return p - glm::floor(p) - 0.5f;
}

/// A segment as its samples see it.
struct Line {
    vec2 px0, step;           // first point, way to the second
    float depth0, depth_step;
    Index facet0, facet1;
};

struct Looker {
    const DepthBuffer& buffer;
    const SampledOptions& options;

    /// True where the texel's surface, extended to `px`, lies in front of `depth`.
    bool hides(int x, int y, const Line& line, vec2 px, float depth) const {
        const DepthTexel& texel =
            buffer.at(std::clamp(x, 0, buffer.width - 1), std::clamp(y, 0, buffer.height - 1));
        if (texel.facet == none || texel.facet == line.facet0 || texel.facet == line.facet1) return false;
        const vec2 away = (buffer.to_texels(px) - (vec2(x, y) + 0.5f)) / float(buffer.scale);
        const float surface = texel.depth + texel.ddx * away.x + texel.ddy * away.y;
        const float slack = options.slack_px * (std::abs(texel.ddx) + std::abs(texel.ddy));
        return depth < surface - slack - options.bias * texel.depth;
    }

    bool sees(const Line& line, vec2 px, float depth) const {
        const vec2 corner = glm::floor(buffer.to_texels(px) - 0.5f);
        const int x = int(corner.x), y = int(corner.y);
        return !(hides(x, y, line, px, depth) && hides(x + 1, y, line, px, depth) &&
                 hides(x, y + 1, line, px, depth) && hides(x + 1, y + 1, line, px, depth));
    }

    /// Share of the probes around fraction `t` of the line that see it.
    float visibility(const Line& line, float t) const {
        const float length = glm::length(line.step);
        const vec2 along = length > 0.0f ? line.step / length : vec2(1.0f, 0.0f);
        const float depth_per_px = length > 0.0f ? line.depth_step / length : 0.0f;
        const vec2 px = line.px0 + t * line.step;
        const float depth = line.depth0 + t * line.depth_step;
        int seen = 0;
        for (int k = 0; k < options.probes; ++k) {
            const vec2 offset = probe_offset(k);
            seen += sees(line, px + offset.x * along + offset.y * vec2(-along.y, along.x),
                         depth + offset.x * depth_per_px);
        }
        return float(seen) / float(options.probes);
    }
};

/// Samples of piece q: those of its segments, then the padding at both ends.
void fill_piece(const ClippedPaths& clipped, Index q, const Looker& looker, Index begin, Index end,
                Array<float>& visibility) {
    Index first = end, last = begin;  // samples of segments
    for (Index i = clipped.pieces.begin(q); i + 1 < clipped.pieces.end(q); ++i) {
        const Index count = clipped.sample_count[i];
        if (count == 0) continue;
        const Line line{clipped.px[i], clipped.px[i + 1] - clipped.px[i], clipped.depth[i],
                        clipped.depth[i + 1] - clipped.depth[i], clipped.facet0[i], clipped.facet1[i]};
        for (Index j = 0; j < count; ++j)
            visibility[clipped.sample_start[i] + j] = looker.visibility(line, (float(j) + 0.5f) / float(count));
        first = std::min(first, clipped.sample_start[i]);
        last = clipped.sample_start[i] + count;
    }
    const bool any = first < last;
    std::fill(visibility.begin() + begin, visibility.begin() + first, any ? visibility[first] : 0.0f);
    if (any) std::fill(visibility.begin() + last, visibility.begin() + end, visibility[last - 1]);
}

}  // namespace

Array<float> sampled_visibility(const ClippedPaths& clipped, const DepthBuffer& buffer, const SampledOptions& options,
                                const Cancel* cancel) {
    check(options.probes >= 1 && options.probes <= max_probes, "sampled visibility: 1 to 16 probes expected");
    check(buffer.width > 0 && buffer.height > 0, "sampled visibility: the depth buffer is empty");
    Array<float> visibility(clipped.samples);
    const Rows samples = piece_samples(clipped);
    const Looker looker{buffer, options};
    parallel_blocks(clipped.pieces.count(), 64, [&](auto, std::size_t begin, std::size_t end) {
        if (cancel) cancel->poll();
        for (Index q = Index(begin); q < end; ++q)
            fill_piece(clipped, q, looker, samples.begin(q), samples.end(q), visibility);
    });
    return visibility;
}

}  // namespace fovea
