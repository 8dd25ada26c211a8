// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/color/layer.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <optional>

#include <fovea/color/shader.h>
#include <fovea/color/shadows.h>
#include <fovea/color/spots.h>
#include <fovea/image/lattice.h>
#include <fovea/scene/light_view.h>
#include <fovea/visibility/depth.h>

namespace fovea::color {
namespace {

constexpr int sample_bits = 4, fine_samples = 1 << sample_bits;
/// Difference of display colors above which a pixel gets the fine samples.
constexpr float fine_color = 1.0f / 96.0f;
/// The same of pixels of one triangle, but for bands: in wide penumbras one sample is enough.
constexpr float fine_shadow = 1.0f / 12.0f;
/// Of spots of black, in reference pixels, squared: smaller ones are not left, nor are smaller holes.
constexpr double least_spot = 60.0;
/// Rays to each light from a fine sample where it differs nearby.
constexpr int fine_parts = 16;

/// Item buffer of occluding triangles: which one is visible at each pixel's center.
class Items {
   public:
    Items(const Scene& scene, const View& view, const Cancel& cancel) : width_(view.width) {
        const std::vector<RasterMesh> meshes = depth_meshes(scene, view, 0.0);
        Index total = 0;
        for (const RasterMesh& mesh : meshes) {
            first_.push_back(total);
            total += static_cast<Index>(mesh.triangles.size());
        }
        for (const Occluder& occluder : occluders(scene, view, 0.0)) placement_.push_back(occluder.placement);
        items_.assign(std::size_t(view.width) * view.height, none);
        Array<float> depths(items_.size());
        const auto draw = [&](const RasterTriangle& triangle, int y0, int y1) {
            const Index item = first_[triangle.mesh] + triangle.triangle;
            const TriangleRows rows(triangle);
            for (int y = y0; y < y1; ++y) {
                Index* items = &items_[std::size_t(y) * width_];
                float* nearest = &depths[std::size_t(y) * width_];
                const auto in_front = [&](int x, double exact) {
                    const float depth = static_cast<float>(exact);
                    return items[x] == none || depth > nearest[x] || (depth == nearest[x] && item < items[x]);
                };
                each_texel(rows, y, in_front, [&](int x, double depth) {
                    items[x] = item;
                    nearest[x] = static_cast<float>(depth);
                });
            }
        };
        draw_triangles(raster_target(view, depth_layout(view, {.scale = 1, .margin = 0.0})), meshes, &cancel, draw);
    }

    std::size_t size() const { return items_.size(); }
    Index at(int x, int y) const { return items_[std::size_t(y) * width_ + x]; }
    SeenTriangle triangle(Index item, const ColorShader& shader) const {
        const auto mesh = std::upper_bound(first_.begin(), first_.end(), item) - first_.begin() - 1;
        return shader.triangle(placement_[mesh], item - first_[mesh]);
    }

   private:
    int width_;
    Array<Index> items_, first_, placement_;
};

class Layer {
   public:
    /// `shadows`: null: the style wants neither shadows nor blacks.
    Layer(const Tracer& tracer, const ColorShader& shader, const Shadows* shadows, const style::Color& style,
          const Cancel& cancel)
        : tracer_(tracer),
          view_(tracer.view()),
          clip_to_view_(glm::inverse(view_.view_to_clip)),
          shader_(shader),
          shadows_(shadows),
          blacks_(float(style.blacks)),
          black_(vec3(style.black_color), 1.0f),
          cancel_(cancel),
          items_(tracer.scene(), view_, cancel) {}

    Array<vec4> draw() {
        Array<vec4> coarse(std::size_t(view_.width) * view_.height, vec4(0.0f)), fine(coarse.size());
        const auto rows = [&](const auto& pixel) {
            parallel_blocks(view_.height, 4, [&](std::size_t, std::size_t begin, std::size_t end) {
                cancel_.poll();
                for (std::size_t y = begin; y < end; ++y) pixel(int(y));
            });
        };
        if (shadows_) look_around(rows);
        rows([&](int y) { centers(y, coarse); });
        if (blacks_ > 0.0f) {
            const double px = view_.reference_scale;
            spots_ = small_spots(black_at_, view_.width, least_spot * px * px);
            rows([&](int y) { centers(y, coarse); });
        }
        rows([&](int y) {
            for (int x = 0; x < view_.width; ++x) {
                const std::size_t i = std::size_t(y) * view_.width + x;
                fine[i] = at_edge(coarse, x, y) ? finely(x, y) : coarse[i];
            }
        });
        return fine;
    }

   private:
    /// Which lights reach what is seen at the pixels' centers, and around them.
    template <typename Rows>
    void look_around(const Rows& rows) {
        Array<KnownLights> known(items_.size());
        rows([&](int y) {
            each_item(y, [&](int x, const SeenTriangle& triangle) {
                const auto place = place_at(triangle, center(x, y), triangle.screen.at(center(x, y)));
                known[std::size_t(y) * view_.width + x] = shadows_->sampled(place, x, y);
            });
        });
        known_ = known_around(known, view_.width);
        black_at_.assign(known.size(), 0);
    }

    /// Colors at the centers of a row's pixels; once small spots are known, of those that they change.
    void centers(int y, Array<vec4>& colors) {
        each_item(y, [&](int x, const SeenTriangle& triangle) {
            const std::size_t i = std::size_t(y) * view_.width + x;
            if (!spots_.empty() && (spots_[i] == Spot::as_is || (spots_[i] == Spot::filled) == (black_at_[i] != 0)))
                return;
            colors[i] = sample(triangle, center(x, y), triangle.screen.at(center(x, y)), i, all_parts);
            if (shadows_) black_at_[i] = colors[i] == black_;
        });
    }

    static dvec2 center(int x, int y) { return {x + 0.5, y + 0.5}; }

    /// Calls visit(x, triangle) for each pixel of a row at whose center there is one.
    template <typename Visit>
    void each_item(int y, const Visit& visit) const {
        SeenTriangle triangle;
        Index known = none;
        for (int x = 0; x < view_.width; ++x) {
            const Index item = items_.at(x, y);
            if (item == none) continue;
            if (item != known) triangle = items_.triangle(known = item, shader_);
            visit(x, triangle);
        }
    }

    ShadedPlace place_at(const SeenTriangle& triangle, const dvec2& px, const dvec3& share) const {
        return shadows_->place(triangle.placement, triangle.triangle, shader_.point(triangle, px, share));
    }

    /// `pixel`: in which the sample is. `parts`: of each light, where it differs around the pixel.
    vec4 sample(const SeenTriangle& triangle, const dvec2& px, const dvec3& share, std::size_t pixel, int parts) const {
        if (shader_.holdout(triangle.placement)) return vec4(0.0f);
        Reach reach;
        if (shadows_) reach = shadows_->reach(place_at(triangle, px, share), known_[pixel], parts);
        if (blacks_ > 0.0f && is_black(triangle, px, share, reach, pixel)) return black_;
        const vec3 color = shader_.color(triangle, px, share, shadows_ ? &reach : nullptr);
        return std::isfinite(color.x + color.y + color.z) ? vec4(color, 1.0f) : vec4(0, 0, 0, 1);
    }

    bool is_black(const SeenTriangle& triangle, const dvec2& px, const dvec3& share, const Reach& reach,
                  std::size_t pixel) const {
        if (spots_.empty() || spots_[pixel] == Spot::as_is) return shader_.tone(triangle, px, share, reach) < blacks_;
        return spots_[pixel] == Spot::filled;
    }

    bool differ(const vec4& a, const vec4& b, float by) const {
        if (a.a != b.a) return true;
        for (int c = 0; c < 3; ++c)
            if (std::abs(a[c] - b[c]) > by * (0.1f + a[c] + b[c])) return true;
        return false;
    }

    /// By how much pixels of one triangle may differ without an edge between them.
    float same_color(std::size_t a, std::size_t b) const {
        if (!shadows_) return HUGE_VALF;
        if (black_at_[a] != black_at_[b]) return 0.0f;
        if (!known_[a].differ()) return HUGE_VALF;
        return shader_.shading() == Shading::toon ? fine_color : fine_shadow;
    }

    bool at_edge(const Array<vec4>& coarse, int x, int y) const {
        const Index own = items_.at(x, y);
        const std::size_t here = std::size_t(y) * view_.width + x;
        for (int v = std::max(y - 1, 0); v <= std::min(y + 1, view_.height - 1); ++v)
            for (int u = std::max(x - 1, 0); u <= std::min(x + 1, view_.width - 1); ++u) {
                const std::size_t there = std::size_t(v) * view_.width + u;
                const float by = items_.at(u, v) != own ? fine_color : same_color(here, there);
                if (differ(coarse[here], coarse[there], by)) return true;
            }
        return false;
    }

    vec4 finely(int x, int y) const {
        std::array<Index, 9> items;
        std::array<SeenTriangle, 9> triangles;
        int count = 0;
        for (int v = std::max(y - 1, 0); v <= std::min(y + 1, view_.height - 1); ++v)
            for (int u = std::max(x - 1, 0); u <= std::min(x + 1, view_.width - 1); ++u) {
                const Index item = items_.at(u, v);
                if (item == none || std::find(items.begin(), items.begin() + count, item) != items.begin() + count)
                    continue;
                triangles[count] = items_.triangle(item, shader_);
                items[count++] = item;
            }
        vec4 sum(0.0f);
        const std::size_t pixel = std::size_t(y) * view_.width + x;
        for (int i = 0; i < fine_samples; ++i)
            sum += fine_sample(center(x, y) + place_in_square(i, sample_bits), pixel, triangles.data(), count);
        return sum / float(fine_samples);
    }

    vec4 fine_sample(const dvec2& px, std::size_t pixel, const SeenTriangle* triangles, int count) const {
        const SeenTriangle* nearest = nullptr;
        double distance = HUGE_VAL;
        dvec3 share;
        for (int i = 0; i < count; ++i) {
            const dvec3 here = triangles[i].screen.at(px);
            if (!ScreenTriangle::covers(here)) continue;
            const double found = triangles[i].screen.distance(here);
            if (found < view_.near_clip || found >= distance) continue;
            if (tracer_.cuts_away(from_pixels(view_, clip_to_view_, px, found))) continue;
            nearest = &triangles[i];
            distance = found;
            share = here;
        }
        if (nearest) return sample(*nearest, px, share, pixel, fine_parts);
        const auto hit = tracer_.seen(px);
        if (!hit) return vec4(0.0f);
        const SeenTriangle met = shader_.triangle(hit->placement, hit->triangle);
        return sample(met, px, met.screen.at(px), pixel, fine_parts);
    }

    const Tracer& tracer_;
    const View& view_;
    dmat4 clip_to_view_;
    const ColorShader& shader_;
    const Shadows* shadows_;
    const float blacks_;
    const vec4 black_;
    const Cancel& cancel_;
    Items items_;
    Array<KnownLights> known_;      // around each pixel; empty without shadows
    Array<std::uint8_t> black_at_;  // per pixel; empty without shadows
    Array<Spot> spots_;             // per pixel; empty before they are known
};

}  // namespace

Array<vec4> color_layer(const Tracer& tracer, const SceneColor& colors, In<Light> lights, const vec3& world,
                        const style::Color& style, const Cancel& cancel) {
    tracer.check_current();
    const bool with_shadows = style.shadow > 0.0 || style.blacks > 0.0;
    // With shadows, lights that cast them come first.
    std::vector<Light> ordered;
    if (with_shadows) ordered = scene::casting_lights(lights, tracer.scene(), lights.size());
    const std::size_t casting = std::min(ordered.size(), most_casters);
    std::ranges::copy_if(lights, std::back_inserter(ordered),
                         [&](const Light& light) { return !with_shadows || !scene::can_cast(light); });
    const Lighting lighting(ordered, world, tracer.scene(), tracer.view(), style);
    const ColorShader shader(tracer.scene(), tracer.view(), colors, lighting, with_shadows);
    std::optional<Shadows> shadows;
    if (with_shadows)
        shadows.emplace(tracer, std::vector<Light>(ordered.begin(), ordered.begin() + std::ptrdiff_t(casting)), style);
    return Layer(tracer, shader, shadows ? &*shadows : nullptr, style, cancel).draw();
}

}  // namespace fovea::color
