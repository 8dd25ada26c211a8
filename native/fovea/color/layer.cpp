// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/color/layer.h>

#include <algorithm>
#include <array>

#include <fovea/color/shader.h>
#include <fovea/image/lattice.h>
#include <fovea/visibility/depth.h>

namespace fovea::color {
namespace {

constexpr int sample_bits = 4, fine_samples = 1 << sample_bits;
/// Difference of display colors above which a pixel gets the fine samples.
constexpr float fine_color = 1.0f / 96.0f;

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
    Layer(const Tracer& tracer, const ColorShader& shader, const Cancel& cancel)
        : tracer_(tracer),
          view_(tracer.view()),
          clip_to_view_(glm::inverse(view_.view_to_clip)),
          shader_(shader),
          cancel_(cancel),
          items_(tracer.scene(), view_, cancel) {}

    Array<vec4> draw() const {
        Array<vec4> coarse(std::size_t(view_.width) * view_.height), fine(coarse.size());
        const auto rows = [&](const auto& pixel) {
            parallel_blocks(view_.height, 4, [&](std::size_t, std::size_t begin, std::size_t end) {
                cancel_.poll();
                for (std::size_t y = begin; y < end; ++y) pixel(int(y));
            });
        };
        rows([&](int y) { centers(y, &coarse[std::size_t(y) * view_.width]); });
        rows([&](int y) {
            for (int x = 0; x < view_.width; ++x) {
                const std::size_t i = std::size_t(y) * view_.width + x;
                fine[i] = at_edge(coarse, x, y) ? finely(x, y) : coarse[i];
            }
        });
        return fine;
    }

   private:
    void centers(int y, vec4* row) const {
        SeenTriangle triangle;
        Index known = none;
        for (int x = 0; x < view_.width; ++x) {
            const Index item = items_.at(x, y);
            row[x] = vec4(0.0f);
            if (item == none) continue;
            if (item != known) triangle = items_.triangle(known = item, shader_);
            const dvec2 px(x + 0.5, y + 0.5);
            row[x] = sample(triangle, px, triangle.screen.at(px));
        }
    }

    vec4 sample(const SeenTriangle& triangle, const dvec2& px, const dvec3& share) const {
        if (shader_.holdout(triangle.placement)) return vec4(0.0f);
        const vec3 color = shader_.color(triangle, px, share);
        return std::isfinite(color.x + color.y + color.z) ? vec4(color, 1.0f) : vec4(0, 0, 0, 1);
    }

    bool differ(const vec4& a, const vec4& b) const {
        if (a.a != b.a) return true;
        for (int c = 0; c < 3; ++c)
            if (std::abs(a[c] - b[c]) > fine_color * (0.1f + a[c] + b[c])) return true;
        return false;
    }

    bool at_edge(const Array<vec4>& coarse, int x, int y) const {
        const Index own = items_.at(x, y);
        for (int v = std::max(y - 1, 0); v <= std::min(y + 1, view_.height - 1); ++v)
            for (int u = std::max(x - 1, 0); u <= std::min(x + 1, view_.width - 1); ++u)
                if (items_.at(u, v) != own &&
                    differ(coarse[std::size_t(y) * view_.width + x], coarse[std::size_t(v) * view_.width + u]))
                    return true;
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
        for (int i = 0; i < fine_samples; ++i)
            sum += fine_sample(dvec2(x + 0.5, y + 0.5) + place_in_square(i, sample_bits), triangles.data(), count);
        return sum / float(fine_samples);
    }

    vec4 fine_sample(const dvec2& px, const SeenTriangle* triangles, int count) const {
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
        if (nearest) return sample(*nearest, px, share);
        const auto hit = tracer_.seen(px);
        if (!hit) return vec4(0.0f);
        const SeenTriangle met = shader_.triangle(hit->placement, hit->triangle);
        return sample(met, px, met.screen.at(px));
    }

    const Tracer& tracer_;
    const View& view_;
    dmat4 clip_to_view_;
    const ColorShader& shader_;
    const Cancel& cancel_;
    Items items_;
};

}  // namespace

Array<vec4> color_layer(const Tracer& tracer, const SceneColor& colors, In<Light> lights, const vec3& world,
                        const style::Color& style, const Cancel& cancel) {
    tracer.check_current();
    const Lighting lighting(lights, world, tracer.scene(), tracer.view(), style);
    const ColorShader shader(tracer.scene(), tracer.view(), colors, lighting);
    return Layer(tracer, shader, cancel).draw();
}

}  // namespace fovea::color
