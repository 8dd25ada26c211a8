#include "elision/elide.h"

#include <algorithm>
#include <cmath>

namespace fovea {
namespace {

float smoothstep(float low, float high, float x) {
    const float t = std::clamp((x - low) / (high - low), 0.0f, 1.0f);
    return t * t * (3.0f - 2.0f * t);
}

/// How much a run is a mere tick, shorter than its band is wide.
float shortness(const vec4& band) { return 1.0f - smoothstep(band.x, 3.0f * band.x, band.z + band.w); }

/// The part of a pixel that another line takes away. `own`: share of it that the line's band covers; `away`: across the
/// line, towards the pixel; `least`: how much of it at any angle.
float lost(const PriorityTexel& other, float rank, float own, vec2 away, float least) {
    if (float(other.rank) <= rank) return 0.0f;
    const float cosine = (away.x * float(other.away_x) + away.y * float(other.away_y)) / 32767.0f;
    const float along = std::max(least, smoothstep(0.25f, 0.75f, cosine * cosine));  // 60 and 30 degrees
    const float covered = float(other.coverage) / 255.0f;
    // Between the two lines both cover it from opposite sides, else from the same.
    return along * (cosine < 0.0f ? std::max(0.0f, own + covered - 1.0f) : std::min(own, covered));
}

/// The window of one sample.
class Window {
   public:
    Window(const PriorityBuffer& buffer, const vec4& place, const vec4& band)
        : buffer_(buffer), px_(place), along_(place.z, place.w), left_(-place.w, place.z), band_(band),
          shortness_(shortness(band)) {}

    vec2 sum() const {
        const float width = 2.0f * band_.x + 1.0f;
        const int rows = std::min(most_window_rows, int(std::ceil(2.0f * width)));
        vec2 sum(0.0f);
        for (int j = 0; j < window_columns; ++j) {
            const vec2 column = px_ + along_ * float(j - window_columns / 2);
            const float shift = (float(j) + 0.5f) / float(window_columns);  // other places in every column
            for (int k = 0; k < rows; ++k) {
                const vec2 at = column + left_ * (((float(k) + shift) / float(rows) - 0.5f) * width);
                sum += pixel(int(std::floor(at.x)), int(std::floor(at.y)));
            }
        }
        return sum;
    }

   private:
    vec2 pixel(int x, int y) const {
        if (x < 0 || y < 0 || x >= buffer_.width || y >= buffer_.height) return vec2(0.0f);
        const vec2 from = vec2(float(x) + 0.5f, float(y) + 0.5f) - px_;
        const float u = glm::dot(from, along_), v = glm::dot(from, left_);
        const float inside = std::clamp(u + band_.z + 0.5f, 0.0f, 1.0f) * std::clamp(band_.w - u + 0.5f, 0.0f, 1.0f);
        const float own = std::clamp(band_.x + 0.5f - std::abs(v), 0.0f, 1.0f);
        if (own * inside <= 0.0f) return vec2(0.0f);
        const vec2 away = v < 0.0f ? -left_ : left_;
        const PriorityBuffer::Pixel& here = buffer_.pixels[std::size_t(y) * buffer_.width + x];
        const float taken = std::max(lost(here.layers[0], band_.y, own, away, shortness_),
                                     lost(here.layers[1], band_.y, own, away, shortness_));
        return inside * vec2(taken, own);
    }

    const PriorityBuffer& buffer_;
    vec2 px_, along_, left_;
    vec4 band_;
    float shortness_;
};

}  // namespace

Array<vec2> crowding(const OwnBands& own, const PriorityBuffer& buffer, const Cancel* cancel) {
    Array<vec2> result(own.band.size());
    parallel_blocks(own.band.size(), 4096, [&](auto, std::size_t begin, std::size_t end) {
        if (cancel) cancel->poll();
        for (std::size_t s = begin; s < end; ++s)
            result[s] = own.band[s].y > 0.0f ? Window(buffer, own.place[s], own.band[s]).sum() : vec2(0.0f);
    });
    return result;
}

}  // namespace fovea
