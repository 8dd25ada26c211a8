// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/color/layer.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <optional>

#include <fovea/color/items.h>
#include <fovea/color/pixel_samples.h>
#include <fovea/color/shader.h>
#include <fovea/color/shadows.h>
#include <fovea/color/sheets.h>
#include <fovea/color/spots.h>
#include <fovea/scene/light_view.h>

namespace fovea::color {
namespace {

/// Difference above which a pixel gets the fine samples, of pixels of one triangle, but for bands: in wide penumbras
/// one sample is enough.
constexpr float fine_shadow = 1.0f / 12.0f;
/// Of spots of black, in reference pixels, squared: smaller ones are not left, nor are smaller holes.
constexpr double least_spot = 60.0;
/// What parts the colors of a pixel and those around it.
enum class Edge : std::uint8_t { none, of_triangles, of_shadows };

class Layer {
   public:
    /// `shadows`: null: the style wants neither shadows nor blacks.
    Layer(const Tracer& tracer, const ColorShader& shader, const Shadows* shadows, const style::Color& style,
          const Cancel& cancel)
        : tracer_(tracer),
          view_(tracer.view()),
          meeting_(tracer),
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
                const Edge edge = edge_at(coarse, x, y);
                fine[i] = edge == Edge::none ? coarse[i] : finely(x, y, edge);
            }
        });
        return fine;
    }

    const Items& items() const { return items_; }

   private:
    /// Which lights reach what is seen at the pixels' centers, and around them.
    template <typename Rows>
    void look_around(const Rows& rows) {
        Array<KnownLights> known(items_.size()), first(items_.size());
        const auto look = [&](bool again) {
            rows([&](int y) {
                if (!again && y % first_px != 0) return;
                each_item(y, [&](int x, const SeenTriangle& triangle) {
                    const bool is_first = x % first_px == 0 && y % first_px == 0;
                    const std::size_t i = std::size_t(y) * view_.width + x;
                    if (is_first == again) return;
                    if (!shadows_->is_open(first[i])) {
                        known[i] = first[i];
                        return;
                    }
                    const auto place = place_at(triangle, middle_of(x, y), triangle.screen.at(middle_of(x, y)));
                    known[i] = shadows_->sampled(place, x, y, first[i]);
                });
            });
        };
        look(false);
        first = known_around(known, view_.width, around_px);
        look(true);
        known_ = known_around(known, view_.width, around_px / 2);
        black_at_.assign(known.size(), 0);
    }

    /// Colors at the centers of a row's pixels; once small spots are known, of those that they change.
    void centers(int y, Array<vec4>& colors) {
        each_item(y, [&](int x, const SeenTriangle& triangle) {
            const std::size_t i = std::size_t(y) * view_.width + x;
            if (!spots_.empty() && (spots_[i] == Spot::as_is || (spots_[i] == Spot::filled) == (black_at_[i] != 0)))
                return;
            const dvec3 share = triangle.screen.at(middle_of(x, y));
            colors[i] =
                sample(triangle, middle_of(x, y), share, i, reach_at(triangle, middle_of(x, y), share, i, all_parts));
            if (shadows_) black_at_[i] = colors[i] == black_;
        });
    }

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

    /// What reaches a sample in a pixel. `parts`: of each light, where it differs around the pixel.
    Reach reach_at(const SeenTriangle& triangle, const dvec2& px, const dvec3& share, std::size_t pixel,
                   const PartsOfLights& parts) const {
        Reach reach;
        if (!shadows_) return reach;
        const ShadedPlace place = place_at(triangle, px, share);
        reach.smooth = shadows_->smooth_normal(place);
        shadows_->leave(place, known_[pixel], parts, reach);
        if (asks_for_tone(pixel)) shadows_->see_middles(place, known_[pixel], reach);
        return reach;
    }

    bool asks_for_tone(std::size_t pixel) const {
        return blacks_ > 0.0f && (spots_.empty() || spots_[pixel] == Spot::as_is);
    }

    /// `pixel`: in which the sample is.
    vec4 sample(const SeenTriangle& triangle, const dvec2& px, const dvec3& share, std::size_t pixel,
                const Reach& reach) const {
        if (shader_.holdout(triangle.placement)) return vec4(0.0f);
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

    Edge edge_at(const Array<vec4>& coarse, int x, int y) const {
        const Index own = items_.at(x, y);
        const std::size_t here = std::size_t(y) * view_.width + x;
        Edge edge = Edge::none;
        any_around(view_, x, y, [&](int u, int v) {
            const std::size_t there = std::size_t(v) * view_.width + u;
            const bool is_other = items_.at(u, v) != own;
            if (!differ(coarse[here], coarse[there], is_other ? fine_color : same_color(here, there))) return false;
            edge = is_other ? Edge::of_triangles : Edge::of_shadows;
            return !is_other;
        });
        return edge;
    }

    vec4 finely(int x, int y, Edge edge) const {
        std::array<Index, 9> items;
        std::array<SeenTriangle, 9> triangles;
        std::array<std::optional<Reach>, 9> known;  // of triangles on which shadows have no edge here
        int count = 0;
        any_around(view_, x, y, [&](int u, int v) {
            const Index item = items_.at(u, v);
            if (item == none || std::find(items.begin(), items.begin() + count, item) != items.begin() + count)
                return false;
            triangles[count] = items_.triangle(item, shader_);
            items[count++] = item;
            return false;
        });
        vec4 sum(0.0f);
        const std::size_t pixel = std::size_t(y) * view_.width + x;
        for (int i = 0; i < fine_samples; ++i) {
            const dvec2 px = fine_sample(x, y, i);
            const auto [nearest, share] = nearest_of(px, triangles.data(), count);
            if (nearest == count) {
                sum += beyond(px, pixel);
                continue;
            }
            const SeenTriangle& triangle = triangles[nearest];
            std::optional<Reach>& reach = known[nearest];
            if (!reach || edge == Edge::of_shadows) {
                reach = reach_at(triangle, px, share, pixel, edge == Edge::of_shadows ? parts_of_sample(i) : few_parts);
            } else if (shadows_ && asks_for_tone(pixel)) {
                const ShadedPlace place = place_at(triangle, px, share);
                reach->smooth = shadows_->smooth_normal(place);
                shadows_->see_middles(place, known_[pixel], *reach);
            }
            sum += sample(triangle, px, share, pixel, *reach);
        }
        return sum / float(fine_samples);
    }

    /// Which of some triangles is seen at a position, `count`: none, and its barycentrics there.
    std::pair<int, dvec3> nearest_of(const dvec2& px, const SeenTriangle* triangles, int count) const {
        int nearest = count;
        Met first{dvec3(0.0), HUGE_VAL};
        for (int i = 0; i < count; ++i) {
            const std::optional<Met> here = meeting_.at(triangles[i], px);
            if (!here || !(here->distance < first.distance)) continue;
            nearest = i;
            first = *here;
        }
        return {nearest, first.share};
    }

    /// The color where none of the triangles around the pixel covers the position.
    vec4 beyond(const dvec2& px, std::size_t pixel) const {
        const auto hit = tracer_.seen(px);
        if (!hit) return vec4(0.0f);
        const SeenTriangle met = shader_.triangle(hit->placement, hit->triangle);
        const dvec3 share = met.screen.at(px);
        return sample(met, px, share, pixel, reach_at(met, px, share, pixel, few_parts));
    }

    const Tracer& tracer_;
    const View& view_;
    Meeting meeting_;
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
    Layer layer(tracer, shader, shadows ? &*shadows : nullptr, style, cancel);
    Array<vec4> found = layer.draw();
    put_sheets(tracer, colors, shader, layer.items(), cancel, found);
    return found;
}

}  // namespace fovea::color
