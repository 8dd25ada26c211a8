// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/elision/elide.h>

#include <algorithm>
#include <cmath>

namespace fovea {
namespace {

float smoothstep(float low, float high, float x) {
    const float t = std::clamp((x - low) / (high - low), 0.0f, 1.0f);
    return t * t * (3.0f - 2.0f * t);
}

/// How much of a pixel that a line goes along a line takes away, by the cosine squared of the angle between the two.
float along(float cosine_squared) { return smoothstep(0.25f, 0.75f, cosine_squared); }             // 60 to 30 degrees
float along_at_end(float cosine_squared) { return smoothstep(0.8214f, 0.9698f, cosine_squared); }  // 25 to 10 degrees

/// The window of one sample.
class Window {
   public:
    Window(const PriorityBuffer& buffer, const vec4& place, const vec4& band, const vec4& ends, float reach_px)
        : buffer_(buffer),
          px_(place),
          along_(place.z, place.w),
          left_(-place.w, place.z),
          band_(band),
          ends_(ends),
          reach_(reach_px),
          rank_(std::uint32_t(band.y)) {}

    vec2 sum() {
        const float width = 2.0f * band_.x + 1.0f;
        const int rows = std::min(most_window_rows, int(std::ceil(2.0f * width)));
        vec2 sum(0.0f);
        for (int j = 0; j < window_columns; ++j) {
            const float shift = (float(j) + 0.5f) / float(window_columns);  // other places in every column
            const vec2 column = px_ + along_ * ((shift - 0.5f) * window_length_px);
            for (int k = 0; k < rows; ++k) {
                const vec2 at = column + left_ * (((float(k) + shift) / float(rows) - 0.5f) * width);
                sum += pixel(at);
            }
        }
        return sum;
    }

   private:
    static constexpr std::size_t nowhere = ~std::size_t(0);

    /// Number of the pixel at a place; `nowhere` outside of the picture.
    std::size_t find(vec2 at) const {
        if (!(at.x >= 0.0f && at.y >= 0.0f && at.x < float(buffer_.width) && at.y < float(buffer_.height)))
            return nowhere;
        return std::size_t(int(at.y)) * buffer_.width + std::size_t(int(at.x));
    }

    /// (lost, own) share of the pixel at a place.
    vec2 pixel(vec2 at) {
        const std::size_t here = find(at);
        if (here == nowhere) return vec2(0.0f);
        const vec2 from = vec2(float(int(at.x)) + 0.5f, float(int(at.y)) + 0.5f) - px_;
        const float u = glm::dot(from, along_), v = glm::dot(from, left_);
        const float inside = std::clamp(u + band_.z + 0.5f, 0.0f, 1.0f) * std::clamp(band_.w - u + 0.5f, 0.0f, 1.0f);
        const float own = std::clamp(band_.x + 0.5f - std::abs(v), 0.0f, 1.0f);
        float taken = 0.0f;
        const PriorityTexel& first = buffer_.first[here];
        if (first.rank > rank_) {
            const vec2 away = v < 0.0f ? -left_ : left_;
            taken = lost(first, own, u, away);
            if (first.crossed && buffer_.second[here].rank > rank_)
                taken = std::max(taken, lost(buffer_.second[here], own, u, away));
        }
        return inside * vec2(taken, own);
    }

    /// The part of a pixel that another line takes away. `own`: share of it that the line's band covers; `u`: pixels
    /// along the line; `away`: across it, towards the pixel.
    float lost(const PriorityTexel& other, float own, float u, vec2 away) {
        const vec2 across = vec2(other.away_x, other.away_y) / PriorityTexel::away_unit;
        const float length = glm::length(across), cosine = glm::dot(away, across) / length;
        const float weight = glm::mix(along(cosine * cosine), along_at_end(cosine * cosine), meets(other.rank)) *
                             (1.0f - takes_over(across / length, length, other.right != 0, u));
        const float shortness = 1.0f - smoothstep(band_.x, 3.0f * band_.x, band_.z + band_.w);
        const float covered = float(other.coverage) / 255.0f;
        // Between the two lines both cover it from opposite sides, else from the same.
        const float both = cosine < 0.0f ? std::max(0.0f, own + covered - 1.0f) : std::min(own, covered);
        return std::max(weight, shortness) * both;
    }

    /// How much this line takes over from another, which ends: wholly over the last two thirds of reach_, if it goes on
    /// beyond that end as far. `across`: unit vector, `length`, `right`: PriorityTexel's.
    float takes_over(vec2 across, float length, bool right, float u) const {
        const float near_end = 2.0f * (1.0f - length);
        if (near_end <= 0.0f) return 0.0f;
        const float ahead = (along_.x * across.y - along_.y * across.x) * (right ? 1.0f : -1.0f);
        const float beyond = (ahead > 0.0f ? band_.w - u : band_.z + u) - (1.0f - near_end) * reach_;
        return std::min(1.0f, 3.0f * near_end) * smoothstep(0.0f, reach_, beyond);
    }

    /// How much one of the run's ends, not far from here, lies in this line's band. Asked only where something is lost.
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

    /// Between the four pixels around an end, so that it may move.
    void find_ends() {
        knows_ends_ = true;
        for (int end = 0; end < 2; ++end) {
            const float near = 1.0f - smoothstep(0.5f * end_reach * band_.x, end_reach * band_.x, band_[2 + end]);
            if (near == 0.0f) continue;
            const vec2 corner = vec2(ends_[2 * end], ends_[2 * end + 1]) - 0.5f;
            const vec2 t = corner - glm::floor(corner);
            for (int k = 0; k < 4; ++k) {
                const vec2 step(float(k % 2), float(k / 2));
                const std::size_t there = find(glm::floor(corner) + step + 0.5f);
                if (there == nowhere) continue;
                const vec2 weight = glm::mix(1.0f - t, t, step);
                const float share = near * weight.x * weight.y / 255.0f;
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
    vec2 px_, along_, left_;
    vec4 band_, ends_;
    float reach_;
    std::uint32_t rank_;
    bool knows_ends_ = false;
    End at_ends_[2][8];
};

}  // namespace

Array<vec2> crowding(const OwnBands& own, const PriorityBuffer& buffer, const Cancel* cancel) {
    Array<vec2> result(own.band.size());
    parallel_blocks(own.band.size(), 4096, [&](auto, std::size_t begin, std::size_t end) {
        if (cancel) cancel->poll();
        for (std::size_t s = begin; s < end; ++s)
            result[s] = Window(buffer, own.place[s], own.band[s], own.ends[s], own.reach_px).sum();
    });
    return result;
}

}  // namespace fovea
