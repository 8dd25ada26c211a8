// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/elision/elide.h>

#include <algorithm>

namespace fovea::elision {
namespace formulas {

using namespace glm;

struct Elision {
#include <shared/elision.glsl>
};

}  // namespace formulas

namespace {

/// The window of one sample.
class Window {
   public:
    Window(const PriorityBuffer& buffer, const OwnBands& own, std::size_t s)
        : buffer_(buffer),
          own_(own),
          place_(own.place[s]),
          band_(own.band[s]),
          ends_(own.ends[s]),
          figure_(own.figure[s]),
          shortness_(f_.elision_shortness(band_, figure_)),
          rank_(std::uint32_t(band_.y)) {}

    vec2 sum() {
        const int rows = f_.elision_rows(band_, most_window_rows);
        vec2 sum(0.0f);
        for (int j = 0; j < window_columns; ++j) {
            const Column column = column_of(j, rows);
            for (int k = 0; k < rows; ++k)
                if (column.own[k] != 0.0f) sum += pixel(column, k);
        }
        return sum;
    }

   private:
    static constexpr std::size_t nowhere = ~std::size_t(0);

    /// The pixels at the positions of a column of the window.
    struct Column {
        int x[most_window_rows], y[most_window_rows];
        float u[most_window_rows], v[most_window_rows];  ///< along and across the line [px]
        float own[most_window_rows];     ///< coverage by the line's own band; 0 outside of the picture, beyond its ends
        float inside[most_window_rows];  ///< coverage by the interval between the run's ends
    };

    /// Computes all rows, also those that are not asked for, without branches: compilers make lanes of them.
    Column column_of(int j, int rows) {
        const vec2 size(buffer_.width, buffer_.height);
        Column column;
        for (int k = 0; k < most_window_rows; ++k) {
            const vec2 at = f_.elision_place(place_, band_, j, window_columns, k, rows, window_length_px);
            const int x = int(glm::clamp(at.x, 0.0f, size.x)), y = int(glm::clamp(at.y, 0.0f, size.y));
            const vec2 from = vec2(float(x) + 0.5f, float(y) + 0.5f) - vec2(place_);
            const float u = glm::dot(from, vec2(place_.z, place_.w)), v = glm::dot(from, vec2(-place_.w, place_.z));
            const float own = f_.elision_own(band_, v), inside = f_.elision_inside(band_, u);
            const bool counts = (at.x >= 0.0f) & (at.y >= 0.0f) & (at.x < size.x) & (at.y < size.y) & (inside != 0.0f);
            column.x[k] = x;
            column.y[k] = y;
            column.u[k] = u;
            column.v[k] = v;
            column.own[k] = counts ? own : 0.0f;
            column.inside[k] = inside;
        }
        return column;
    }

    /// Index of the pixel at a position; `nowhere` outside of the picture.
    std::size_t find(vec2 at) const {
        if (!(at.x >= 0.0f && at.y >= 0.0f && at.x < float(buffer_.width) && at.y < float(buffer_.height)))
            return nowhere;
        return std::size_t(int(at.y)) * buffer_.width + std::size_t(int(at.x));
    }

    /// (lost, own) share of a pixel of the line's own band.
    vec2 pixel(const Column& column, int k) {
        const std::size_t here = std::size_t(column.y[k]) * buffer_.width + std::size_t(column.x[k]);
        const float own = column.own[k];
        float taken = 0.0f;
        const PriorityTexel& first = buffer_.first[here];
        if (first.rank > rank_) {
            const vec2 left(-place_.w, place_.z), away = column.v[k] < 0.0f ? -left : left;
            taken = lost(first, own, column.u[k], away);
            if (first.crossed && buffer_.second[here].rank > rank_)
                taken = std::max(taken, lost(buffer_.second[here], own, column.u[k], away));
        }
        return column.inside[k] * vec2(taken, own);
    }

    /// The part of a pixel that is lost to another line.
    float lost(const PriorityTexel& other, float own, float u, vec2 away) {
        const vec2 across = vec2(other.away_x, other.away_y) / PriorityTexel::away_unit;
        const float others = other.rank < own_.figure_of_rank.size() ? own_.figure_of_rank[other.rank] : -1.0f;
        const float foreign = f_.elision_foreign(figure_, others);
        if (foreign == 0.0f) return 0.0f;
        return foreign * f_.elision_lost(place_, band_, own, u, away, across, other.right != 0,
                                         float(other.coverage) / 255.0f, meets(other.rank), shortness_, own_.reach_px);
    }

    /// How far one of the run's ends, if near, lies in the band of the line of this rank, in [0, 1]. Evaluated lazily,
    /// only where something is lost.
    float meets(std::uint32_t rank) {
        if (!knows_ends_) find_ends();
        float most = 0.0f;
        for (const auto& end : at_ends_) {
            float share = 0.0f;
            for (const End& there : end) share += there.rank == rank ? there.share : 0.0f;
            most = std::max(most, share);
        }
        return most;
    }

    /// Bilinear weights of the four pixels around each end, so that the result is continuous when the end moves.
    void find_ends() {
        knows_ends_ = true;
        for (int end = 0; end < 2; ++end) {
            const float near = f_.elision_near_end(band_, band_[2 + end], end_reach);
            if (near == 0.0f) continue;
            const vec2 corner = vec2(ends_[2 * end], ends_[2 * end + 1]) - 0.5f;
            const vec2 t = corner - glm::floor(corner);
            for (int k = 0; k < 4; ++k) {
                const vec2 step(float(k % 2), float(k / 2));
                const std::size_t there = find(glm::floor(corner) + step + 0.5f);
                if (there == nowhere) continue;
                const float share = f_.elision_corner(near, t, k) / 255.0f;
                const PriorityTexel& first = buffer_.first[there];
                at_ends_[end][2 * k] = {first.rank, share * float(first.coverage)};
                if (!first.crossed) continue;
                const PriorityTexel& second = buffer_.second[there];
                at_ends_[end][2 * k + 1] = {second.rank, share * float(second.coverage)};
            }
        }
    }

    struct End {
        std::uint32_t rank = 0;
        float share = 0.0f;
    };

    const PriorityBuffer& buffer_;
    const OwnBands& own_;
    formulas::Elision f_;
    vec4 place_, band_, ends_;
    vec3 figure_;
    float shortness_;
    std::uint32_t rank_;
    bool knows_ends_ = false;
    End at_ends_[2][8];
};

}  // namespace

Array<vec2> crowding(const OwnBands& own, const PriorityBuffer& buffer, const Cancel* cancel) {
    Array<vec2> result(own.band.size());
    parallel_blocks(own.band.size(), 4096, [&](auto, std::size_t begin, std::size_t end) {
        if (cancel) cancel->poll();
        for (std::size_t s = begin; s < end; ++s) result[s] = Window(buffer, own, s).sum();
    });
    return result;
}

}  // namespace fovea::elision
