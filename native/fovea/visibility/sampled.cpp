// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/visibility/sampled.h>

#include <cmath>

#include <fovea/base/check.h>
#include <fovea/visibility/layout.h>
#include <fovea/visibility/triangle_edges.h>

namespace fovea {
namespace {

constexpr int max_probes = 16;

/// A segment as its samples see it.
struct Line {
    vec2 px0, px1;
    float depth0, depth1;
    Index facet0, facet1;
    float steepness;
    bool inner;
};

/// What a texel says about a line at a probe.
struct Look {
    float gap;    ///< how far its surface lies in front of the line
    float bulge;  ///< a gap up to this may come from the line's own surface
    bool own;     ///< shows a facet of the line
    bool holds;   ///< its surface lies in front, and its triangle reaches as far as the probe
};

struct Looker {
    const DepthBuffer& buffer;
    const SampledOptions& options;

    /// `at`: the probe in texels; `depth`: of the line there.
    Look look(vec2 texel, const Line& line, vec2 at, float depth) const {
        const int x = std::clamp(int(texel.x), 0, buffer.width - 1), y = std::clamp(int(texel.y), 0, buffer.height - 1);
        const DepthTexel& here = buffer.at(x, y);
        const bool own = here.facet == line.facet0 || here.facet == line.facet1;
        if (here.facet == none || own) return {0.0f, 0.0f, own && here.facet != none, false};
        const vec2 off = at - (vec2(x, y) + 0.5f), away = off / float(buffer.scale);
        const vec2 slope(here.ddx, here.ddy);
        const float surface = here.depth + glm::dot(slope, away);
        const float slack = options.slack_px * (std::abs(slope.x) + std::abs(slope.y)) + options.bias * here.depth;
        const float gap = surface - slack - depth;
        return {gap, std::max(glm::length(slope), line.steepness) * glm::length(away), false,
                gap > 0.0f && edges_hold(here.edges, off)};
    }

    bool sees(const Line& line, vec2 px, float depth) const {
        const vec2 at = buffer.to_texels(px), nearest = glm::floor(at);
        const vec2 opposite = 2.0f * glm::floor(at - 0.5f) + 1.0f - nearest;  // of the four around
        bool open = false;
        for (int k = 0; k < 4; ++k) {
            const vec2 texel(k % 2 == 0 ? nearest.x : opposite.x, k < 2 ? nearest.y : opposite.y);
            const Look there = look(texel, line, at, depth);
            const bool clearly = k == 0 && there.gap > (line.inner ? 0.0f : there.bulge);
            if (there.holds || clearly) return false;
            open = open || (line.inner ? there.own : there.gap <= 0.0f);
        }
        return open;
    }

    /// Share of the probes, evenly spread over the part of the line from screen fraction t0 to t1, that see it.
    float visibility(const Line& line, float t0, float t1) const {
        const int probes = options.probes;
        const bool start = probe(line, t0, t1, 0);
        if (probes == 1 || start == probe(line, t0, t1, probes - 1)) return start ? 1.0f : 0.0f;
        int seen = 0;
        for (int k = 0; k < probes; ++k) seen += probe(line, t0, t1, k);
        return float(seen) / float(probes);
    }

    bool probe(const Line& line, float t0, float t1, int k) const {
        const float t = glm::mix(t0, t1, (float(k) + 0.5f) / float(options.probes));
        return sees(line, glm::mix(line.px0, line.px1, t), glm::mix(line.depth0, line.depth1, t));
    }
};

Line line_of(const ClippedPaths& clipped, const OwnSides& sides, Index i) {
    return {clipped.px[i],     clipped.px[i + 1], clipped.depth[i],   clipped.depth[i + 1],
            clipped.facet0[i], clipped.facet1[i], sides.steepness[i], sides.inner[i] != 0};
}

/// Samples of piece q.
void fill_piece(const ClippedPaths& clipped, const OwnSides& sides, Index q, const Looker& looker,
                Array<float>& visibility) {
    for (Index i = clipped.pieces.begin(q); i + 1 < clipped.pieces.end(q); ++i) {
        const Index count = clipped.sample_count[i];
        const Line line = line_of(clipped, sides, i);
        for (Index j = 0; j < count; ++j) {
            const vec2 middle = glm::mix(line.px0, line.px1, (float(j) + 0.5f) / float(count));
            if (looker.buffer.decides(middle))
                visibility[clipped.sample_start[i] + j] =
                    looker.visibility(line, float(j) / float(count), float(j + 1) / float(count));
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
    check(sides.steepness.size() == clipped.px.size() && sides.inner.size() == clipped.px.size(),
          "sampled visibility: own sides of other paths");
    Array<float> visibility(clipped.samples, 0.0f);
    const Looker looker{buffer, options};
    parallel_blocks(clipped.pieces.count(), 64, [&](auto, std::size_t begin, std::size_t end) {
        if (cancel) cancel->poll();
        for (Index q = Index(begin); q < end; ++q) fill_piece(clipped, sides, q, looker, visibility);
    });
    return visibility;
}

float visibility_between(const ClippedPaths& clipped, const OwnSides& sides, Index segment, float t0, float t1,
                         const DepthBuffer& buffer, const SampledOptions& options) {
    return Looker{buffer, options}.visibility(line_of(clipped, sides, segment), t0, t1);
}

}  // namespace fovea
