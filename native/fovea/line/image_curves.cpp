// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/line/image_curves.h>

#include <algorithm>
#include <bit>
#include <limits>
#include <tuple>

#include <fovea/base/disjoint_sets.h>
#include <fovea/base/hash.h>
#include <fovea/image/gaussian.h>

namespace fovea::line {
namespace {

/// Border of the lattice beyond the frame's margin, in steps: room for filters. Also the search radius below.
constexpr int reach = 8;
constexpr double least_curve_length = 5.0 * steps_per_sigma;

std::uint64_t bits_of(double value) { return std::bit_cast<std::uint64_t>(value); }

/// Of the shaded scene.
std::uint64_t key_of(const ImageValues& values) {
    const Lamp lamp = values.lamp();
    return hash_numbers(bits_of(values.sigma), bits_of(lamp.right), bits_of(lamp.up));
}

SmoothTone make_tone(const FrameView& frame, bool outline, double background,
                     std::shared_ptr<const ShadedBuffer> shaded) {
    SmoothTone tone{std::move(shaded), {}};
    const ShadedBuffer& buffer = *tone.shaded;
    const Lattice& lattice = buffer.lattice;
    Buffer lit = buffer.tone;
    const auto beyond = static_cast<float>(outline ? background : 0.0);
    parallel_for(lit.size(), [&](std::size_t i) { lit[i] += beyond * (1.0f - buffer.coverage[i]); });
    // Minus the variance of the unit square that a node is averaged over.
    const double sigma = std::sqrt(steps_per_sigma * steps_per_sigma - 1.0 / 12.0);
    tone.value = gaussian(lit, lattice.width, lattice.height, sigma);
    frame.cancel.poll();
    if (outline) return tone;
    constexpr float least_share = 0.01f;
    const Buffer share = gaussian(buffer.coverage, lattice.width, lattice.height, sigma);
    parallel_for(share.size(), [&](std::size_t i) {
        tone.value[i] = share[i] > least_share ? tone.value[i] / share[i] : std::numeric_limits<float>::quiet_NaN();
    });
    return tone;
}

/// Node with the nearest surface around lattice position `place`, searched in growing squares; `none` if nothing is
/// within `reach`.
Index nearest_surface(const ShadedBuffer& shaded, const vec2& place) {
    const Lattice& lattice = shaded.lattice;
    const int x = int(place.x), y = int(place.y);
    for (int ring = 0; ring < reach; ++ring) {
        Index nearest = none;
        float distance = std::numeric_limits<float>::infinity();
        for (int j = std::max(0, y - ring); j <= std::min(lattice.height - 1, y + 1 + ring); ++j)
            for (int i = std::max(0, x - ring); i <= std::min(lattice.width - 1, x + 1 + ring); ++i) {
                const std::size_t node = lattice.at(i, j);
                if (!(shaded.distance[node] < distance)) continue;
                distance = shaded.distance[node];
                nearest = Index(node);
            }
        if (nearest != none) return nearest;
    }
    return none;
}

DisjointSets join_at_sides(const Curves& pieces) {
    DisjointSets joined(pieces.size());
    std::vector<std::tuple<Index, Index, Index>> ends;  // side, level, piece
    for (Index i = 0; i < pieces.size(); ++i)
        for (const Index side : pieces[i].side)
            if (side != none) ends.emplace_back(side, pieces[i].level, i);
    std::sort(ends.begin(), ends.end());
    for (std::size_t i = 1; i < ends.size(); ++i) {
        const auto& [side, level, piece] = ends[i];
        const auto& [side_before, level_before, before] = ends[i - 1];
        if (side == side_before && level == level_before) joined.join(piece, before);
    }
    return joined;
}

}  // namespace

std::shared_ptr<const ShadedBuffer> shaded_scene(const FrameView& frame, const ImageValues& values) {
    return frame.shared.get<ShadedBuffer>(key_of(values), [&] {
        const Lattice lattice = lattice_over(frame.tracer.view(), values.sigma / steps_per_sigma, reach);
        return shade(frame.tracer, lattice, values.lamp(), frame.cancel);
    });
}

std::shared_ptr<const SmoothTone> smooth_tone(const FrameView& frame, const ImageValues& values, double background) {
    return frame.shared.get<SmoothTone>(hash_numbers(key_of(values), values.outline, bits_of(background)), [&] {
        return make_tone(frame, values.outline, background, shaded_scene(frame, values));
    });
}

Curves keep_strong(const Curves& pieces, double least) {
    DisjointSets joined = join_at_sides(pieces);
    Array<double> length(pieces.size(), 0.0);
    Array<std::uint8_t> strong(pieces.size(), 0);
    for (Index i = 0; i < pieces.size(); ++i) {
        const CurvePiece& piece = pieces[i];
        const Index set = joined.name(i);
        length[set] += glm::distance(dvec3(piece.point[0]), dvec3(piece.point[1]));
        strong[set] |= std::max(piece.strength[0], piece.strength[1]) >= 1.0f;
    }
    return values_where(pieces, [&](std::size_t i) {
        const Index set = joined.name(Index(i));
        return strong[set] && length[set] >= least;
    });
}

Curves lift(const FrameView& frame, const ShadedBuffer& shaded, const Curves& pieces) {
    const View& view = frame.tracer.view();
    const dmat4 clip_to_view = glm::inverse(view.view_to_clip);
    Curves lifted;
    for (CurvePiece piece : keep_strong(pieces, least_curve_length)) {
        bool drawn = true;
        for (vec3& point : piece.point) {
            const Index node = nearest_surface(shaded, point);
            drawn = drawn && node != none && shaded.drawn[node];
            if (!drawn) break;
            point = vec3(from_pixels(view, clip_to_view, shaded.lattice.px(dvec2(point)), shaded.distance[node]));
        }
        if (drawn) lifted.push_back(piece);
    }
    return lifted;
}

}  // namespace fovea::line
