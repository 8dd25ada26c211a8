// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/visibility/beside.h>

#include <fovea/visibility/segment.h>

namespace fovea {
namespace {

constexpr std::size_t pieces_per_block = 256;

class Beside {
   public:
    Beside(const ClippedPaths& clipped, const Paths& paths, const Tracer& tracer, double offset_px)
        : clipped_(clipped),
          paths_(paths),
          tracer_(tracer),
          offset_px_(offset_px),
          clip_to_view_(glm::inverse(tracer.view().view_to_clip)) {}

    void look(Index piece, Array<std::uint8_t>& seen) const {
        const bool in_image = paths_.placement[clipped_.path[piece]] == none;
        for (Index i = clipped_.pieces.begin(piece); i + 1 < clipped_.pieces.end(piece); ++i) {
            const Index count = clipped_.sample_count[i], start = clipped_.sample_start[i];
            const bool asks = !in_image && count > 0;
            const Ignore ignore = asks ? segment_at(clipped_, paths_, tracer_, piece, i).ignore : Ignore();
            for (Index j = 0; j < count; ++j)
                seen[start + j] = in_image || !tracer_.occluder(point(i, (j + 0.5) / count) + ignore.above, ignore);
        }
    }

   private:
    /// View-space point beside screen fraction s of segment i.
    vec3 point(Index i, double s) const {
        const dvec2 p(clipped_.px[i]), way = dvec2(clipped_.px[i + 1]) - p;
        const double length = glm::length(way);
        const dvec2 left = length > 0.0 ? dvec2(-way.y, way.x) / length : dvec2(0.0, 1.0);
        const double a = -clipped_.position_view[i].z, b = -clipped_.position_view[i + 1].z;
        const double distance = tracer_.view().orthographic ? glm::mix(a, b, s) : a * b / glm::mix(b, a, s);
        return vec3(from_pixels(tracer_.view(), clip_to_view_, p + s * way + offset_px_ * left, distance));
    }

    const ClippedPaths& clipped_;
    const Paths& paths_;
    const Tracer& tracer_;
    double offset_px_;
    dmat4 clip_to_view_;
};

}  // namespace

Array<std::uint8_t> seen_beside(const ClippedPaths& clipped, const Paths& paths, const Tracer& tracer, double offset_px,
                                const Cancel& cancel) {
    const std::size_t pieces = clipped.path.size();
    check_same_paths(clipped, paths, "seen_beside");
    tracer.check_current();
    Array<std::uint8_t> seen(clipped.samples);
    std::fill(seen.begin(), seen.end(), 0);
    const Beside beside(clipped, paths, tracer, offset_px);
    parallel_blocks(pieces, pieces_per_block, [&](auto, std::size_t begin, std::size_t end) {
        cancel.poll();
        for (std::size_t q = begin; q < end; ++q) beside.look(static_cast<Index>(q), seen);
    });
    return seen;
}

}  // namespace fovea
