#include "elision/elide.h"

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
    Window(const PriorityBuffer& buffer, const vec4& place, const vec4& band, const vec4& ends)
        : buffer_(buffer),
          px_(place),
          along_(place.z, place.w),
          left_(-place.w, place.z),
          band_(band),
          ends_(ends),
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
            taken = lost(first, own, away);
            if (first.crossed && buffer_.second[here].rank > rank_)
                taken = std::max(taken, lost(buffer_.second[here], own, away));
        }
        return inside * vec2(taken, own);
    }

    /// The part of a pixel that another line takes away. `own`: share of it that the line's band covers; `away`: across
    /// the line, towards the pixel.
    float lost(const PriorityTexel& other, float own, vec2 away) {
        const float cosine = (away.x * float(other.away_x) + away.y * float(other.away_y)) / 32767.0f;
        const float weight = glm::mix(along(cosine * cosine), along_at_end(cosine * cosine), meets(other.rank));
        const float shortness = 1.0f - smoothstep(band_.x, 3.0f * band_.x, band_.z + band_.w);
        const float covered = float(other.coverage) / 255.0f;
        // Between the two lines both cover it from opposite sides, else from the same.
        const float both = cosine < 0.0f ? std::max(0.0f, own + covered - 1.0f) : std::min(own, covered);
        return std::max(weight, shortness) * both;
    }

    /// How much one of the run's ends, not far from here, lies in this line's band. Asked only where something is lost.
    float meets(std::uint32_t rank) {
        if (!knows_ends_) find_ends();
        float most = 0.0f;
        for (const End& end : at_ends_) most = std::max(most, end.share * float(end.rank == rank));
        return most;
    }

    void find_ends() {
        knows_ends_ = true;
        for (int end = 0; end < 2; ++end) {
            const float near = 1.0f - smoothstep(0.5f * end_reach * band_.x, end_reach * band_.x, band_[2 + end]);
            const std::size_t there = find({ends_[2 * end], ends_[2 * end + 1]});
            if (there == nowhere) continue;
            const auto meet = [&](const PriorityTexel& band) {
                return End{band.rank, near * float(band.coverage) / 255.0f};
            };
            at_ends_[2 * end] = meet(buffer_.first[there]);
            if (buffer_.first[there].crossed) at_ends_[2 * end + 1] = meet(buffer_.second[there]);
        }
    }

    struct End {
        std::uint32_t rank = 0;
        float share = 0.0f;
    };

    const PriorityBuffer& buffer_;
    vec2 px_, along_, left_;
    vec4 band_, ends_;
    std::uint32_t rank_;
    bool knows_ends_ = false;
    End at_ends_[4];
};

}  // namespace

Array<vec2> crowding(const OwnBands& own, const PriorityBuffer& buffer, const Cancel* cancel) {
    Array<vec2> result(own.band.size());
    parallel_blocks(own.band.size(), 4096, [&](auto, std::size_t begin, std::size_t end) {
        if (cancel) cancel->poll();
        for (std::size_t s = begin; s < end; ++s)
            result[s] = Window(buffer, own.place[s], own.band[s], own.ends[s]).sum();
    });
    return result;
}

}  // namespace fovea
