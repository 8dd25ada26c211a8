// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/color/layer.h>

#include <algorithm>
#include <array>
#include <optional>
#include <tuple>
#include <vector>

#include <fovea/color/shader.h>
#include <fovea/color/sheets.h>
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
        depths_.resize(items_.size());
        const auto draw = [&](const RasterTriangle& triangle, int y0, int y1) {
            const Index item = first_[triangle.mesh] + triangle.triangle;
            const TriangleRows rows(triangle);
            for (int y = y0; y < y1; ++y) {
                Index* items = &items_[std::size_t(y) * width_];
                float* nearest = &depths_[std::size_t(y) * width_];
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
    /// Of its triangle, as the depth buffer has it.
    float depth(int x, int y) const { return depths_[std::size_t(y) * width_ + x]; }
    SeenTriangle triangle(Index item, const ColorShader& shader) const {
        const auto mesh = std::upper_bound(first_.begin(), first_.end(), item) - first_.begin() - 1;
        return shader.triangle(placement_[mesh], item - first_[mesh]);
    }

   private:
    int width_;
    Array<Index> items_, first_, placement_;
    Array<float> depths_;
};

class Layer {
   public:
    Layer(const Tracer& tracer, const ColorShader& shader, const Sheets& sheets, const Cancel& cancel)
        : tracer_(tracer),
          view_(tracer.view()),
          clip_to_view_(glm::inverse(view_.view_to_clip)),
          shader_(shader),
          sheets_(sheets),
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
    /// A triangle at a place of the image.
    struct Met {
        const SeenTriangle* triangle;
        dvec3 share;
        double distance;

        /// Whether both are met on a side, as triangles of one surface are on the side that they share.
        bool doubles(const Met& other) const {
            return triangle->placement == other.triangle->placement && on_side() && other.on_side() &&
                   std::abs(distance - other.distance) <= 1e-6 * distance;
        }
        static constexpr double slack = 1e-9;  // of the shares, of their sum

       private:
        bool on_side() const { return std::min({share.x, share.y, share.z}) <= slack * (share.x + share.y + share.z); }
    };

    /// The color of what is met there, the nearest first; with alpha, premultiplied.
    vec4 composite(In<Met> found, const dvec2& px) const {
        vec4 sum(0.0f);
        for (std::size_t i = 0; i < found.size(); ++i)
            if (i == 0 || !is_sheet(*found[i].triangle) || !found[i].doubles(found[i - 1]))
                sum += (1.0f - sum.a) * sample(*found[i].triangle, px, found[i].share);
        return sum;
    }

    void centers(int y, vec4* row) const {
        SeenTriangle triangle;
        Index known = none;
        std::vector<Sheets::Fragment> known_sheets;
        std::vector<SeenTriangle> sheets;
        std::vector<Met> found;
        for (int x = 0; x < view_.width; ++x) {
            const Index item = items_.at(x, y);
            const dvec2 px(x + 0.5, y + 0.5);
            if (item != none && item != known) triangle = items_.triangle(known = item, shader_);
            const auto at = [&](const SeenTriangle& seen) {
                const dvec3 share = seen.screen.at(px);
                return Met{&seen, share, seen.screen.distance(share)};
            };
            const In<Sheets::Fragment> before = seen_sheets(x, y);
            if (sheets.size() < before.size()) {
                sheets.resize(before.size());
                known_sheets.resize(before.size(), {-1, none, none, 0.0f});
            }
            found.clear();
            for (std::size_t i = 0; i < before.size(); ++i) {
                if (!(known_sheets[i] == before[i])) {
                    known_sheets[i] = before[i];
                    sheets[i] = sheets_.triangle(before[i], shader_);
                }
                found.push_back(at(sheets[i]));
            }
            if (item != none) found.push_back(at(triangle));
            row[x] = composite(found, px);
        }
    }

    /// The sheets before the nearest occluding triangle at a pixel's center, the nearest first.
    In<Sheets::Fragment> seen_sheets(int x, int y) const {
        const In<Sheets::Fragment> all = sheets_.at(x, y);
        if (items_.at(x, y) == none) return all;
        const float depth = items_.depth(x, y);
        const auto behind =
            std::ranges::find_if(all, [depth](const Sheets::Fragment& f) { return !(f.depth > depth); });
        return all.first(behind - all.begin());
    }

    vec4 sample(const SeenTriangle& triangle, const dvec2& px, const dvec3& share) const {
        if (shader_.holdout(triangle.placement)) return vec4(0.0f);
        const vec3 color = shader_.color(triangle, px, share);
        const vec4 found = std::isfinite(color.x + color.y + color.z) ? vec4(color, 1.0f) : vec4(0, 0, 0, 1);
        return is_sheet(triangle) ? triangle.slot->opacity * found : found;
    }

    bool is_sheet(const SeenTriangle& triangle) const {
        return triangle.triangle >= tracer_.scene().placements[triangle.placement].surface->occluding_triangles;
    }

    bool differ(const vec4& a, const vec4& b) const {
        if (a.a != b.a) return true;
        for (int c = 0; c < 3; ++c)
            if (std::abs(a[c] - b[c]) > fine_color * (0.1f + a[c] + b[c])) return true;
        return false;
    }

    bool at_edge(const Array<vec4>& coarse, int x, int y) const {
        const Index own = items_.at(x, y);
        const In<Sheets::Fragment> before = seen_sheets(x, y);
        for (int v = std::max(y - 1, 0); v <= std::min(y + 1, view_.height - 1); ++v)
            for (int u = std::max(x - 1, 0); u <= std::min(x + 1, view_.width - 1); ++u)
                if ((items_.at(u, v) != own || (!sheets_.empty() && !std::ranges::equal(before, seen_sheets(u, v)))) &&
                    differ(coarse[std::size_t(y) * view_.width + x], coarse[std::size_t(v) * view_.width + u]))
                    return true;
        return false;
    }

    vec4 finely(int x, int y) const {
        std::array<Index, 9> items;
        std::array<SeenTriangle, 9> triangles;
        int count = 0;
        std::vector<Sheets::Fragment> known;
        std::vector<SeenTriangle> sheets;
        std::vector<Met> found;
        for (int v = std::max(y - 1, 0); v <= std::min(y + 1, view_.height - 1); ++v)
            for (int u = std::max(x - 1, 0); u <= std::min(x + 1, view_.width - 1); ++u) {
                for (const Sheets::Fragment& fragment : sheets_.at(u, v)) {
                    if (std::ranges::find(known, fragment) != known.end()) continue;
                    known.push_back(fragment);
                    sheets.push_back(sheets_.triangle(fragment, shader_));
                }
                const Index item = items_.at(u, v);
                if (item == none || std::find(items.begin(), items.begin() + count, item) != items.begin() + count)
                    continue;
                triangles[count] = items_.triangle(item, shader_);
                items[count++] = item;
            }
        vec4 sum(0.0f);
        for (int i = 0; i < fine_samples; ++i)
            sum += fine_sample(dvec2(x + 0.5, y + 0.5) + place_in_square(i, sample_bits),
                               In<SeenTriangle>(triangles.data(), count), sheets, found);
        return sum / float(fine_samples);
    }

    /// `slack`: of shares outside the triangle, so that nothing is missed between two.
    std::optional<Met> met(const SeenTriangle& triangle, const dvec2& px, double slack) const {
        const dvec3 share = triangle.screen.at(px);
        if (!ScreenTriangle::covers(share + slack * (share.x + share.y + share.z))) return {};
        const double distance = triangle.screen.distance(share);
        if (!(distance >= view_.near_clip) || tracer_.cuts_away(from_pixels(view_, clip_to_view_, px, distance)))
            return {};
        return Met{&triangle, share, distance};
    }

    vec4 fine_sample(const dvec2& px, In<SeenTriangle> triangles, In<SeenTriangle> sheets,
                     std::vector<Met>& found) const {
        std::optional<Met> nearest;
        for (const SeenTriangle& triangle : triangles)
            if (const auto here = met(triangle, px, 0.0); here && (!nearest || here->distance < nearest->distance))
                nearest = here;
        SeenTriangle by_ray;
        if (!nearest) {
            if (const auto hit = tracer_.seen(px)) {
                by_ray = shader_.triangle(hit->placement, hit->triangle);
                const dvec3 share = by_ray.screen.at(px);
                nearest = Met{&by_ray, share, by_ray.screen.distance(share)};
            }
        }
        found.clear();
        for (const SeenTriangle& sheet : sheets)
            if (const auto here = met(sheet, px, Met::slack); here && !(nearest && nearest->distance <= here->distance))
                found.push_back(*here);
        std::ranges::sort(found, {}, [](const Met& m) {
            return std::tuple(m.distance, m.triangle->placement, m.triangle->triangle);
        });
        if (nearest) found.push_back(*nearest);
        return composite(found, px);
    }

    const Tracer& tracer_;
    const View& view_;
    dmat4 clip_to_view_;
    const ColorShader& shader_;
    const Sheets& sheets_;
    const Cancel& cancel_;
    Items items_;
};

}  // namespace

Array<vec4> color_layer(const Tracer& tracer, const SceneColor& colors, In<Light> lights, const vec3& world,
                        const style::Color& style, const Cancel& cancel) {
    tracer.check_current();
    const Lighting lighting(lights, world, tracer.scene(), tracer.view(), style);
    const ColorShader shader(tracer.scene(), tracer.view(), colors, lighting);
    const Sheets sheets(tracer.scene(), tracer.view(), colors, cancel);
    return Layer(tracer, shader, sheets, cancel).draw();
}

}  // namespace fovea::color
