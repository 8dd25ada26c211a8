// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/color/sheets.h>

#include <algorithm>
#include <numeric>
#include <optional>
#include <tuple>
#include <vector>

#include <fovea/color/pixel_samples.h>
#include <fovea/scene/section.h>

namespace fovea::color {
namespace {

/// Triangles of see-through surfaces, by the pixels whose centers they cover.
class Sheets {
   public:
    /// Borrows its arguments.
    Sheets(const Scene& scene, const View& view, const SceneColor& colors, const Cancel& cancel);

    bool empty() const { return sheets_.empty(); }

    struct Fragment {
        int x;
        Index sheet, triangle;
        float depth;  ///< as the depth buffer has it (base/view.h): the nearest is the greatest
        bool operator==(const Fragment& other) const { return sheet == other.sheet && triangle == other.triangle; }
    };
    /// Those of a pixel, the nearest first.
    In<Fragment> at(int x, int y) const;
    bool has_row(int y) const { return !rows_[y].first.empty(); }
    SeenTriangle triangle(const Fragment& fragment, const ColorShader& shader) const;

   private:
    struct Sheet {
        Index placement;
        Array<Triangle> triangles;  // two-sided ones first
        Array<Index> number;        // of the surface's triangle
        Index two_sided;
    };
    struct Row {
        std::vector<Fragment> fragments;  // by x, then from the viewer on
        std::vector<Index> first;         // of each x, and their number; empty without any
    };
    void draw(const Scene& scene, const View& view, const Cancel& cancel);

    std::vector<Sheet> sheets_;
    std::vector<Row> rows_;
};

Sheets::Sheets(const Scene& scene, const View& view, const SceneColor& colors, const Cancel& cancel) {
    for (Index p = 0; p < scene.placements.size(); ++p) {
        const Placement& placement = scene.placements[p];
        const Surface& surface = *placement.surface;
        if (!(placement.usage & usage_occlude) || surface.occluding_triangles == surface.triangles.size() ||
            !colors[p] || !in_frame(placement, view, 0.0) || cut_of(scene, placement).kept == Cut::nothing)
            continue;
        const std::vector<ColorSlot>& slots = colors[p]->slots;
        const auto polygon = [&](Index t) { return surface.facet_polygon[surface.triangle_facet[t]]; };
        Sheet sheet{p, {}, {}, 0};
        for (Index t = surface.occluding_triangles; t < surface.triangles.size(); ++t) {
            const auto slot = static_cast<std::size_t>(surface.polygon_material[polygon(t)]);
            if (slot < slots.size() && slots[slot].opacity > 0.0f) sheet.number.push_back(t);
        }
        if (sheet.number.empty()) continue;
        const auto one_sided = std::stable_partition(sheet.number.begin(), sheet.number.end(), [&](Index t) {
            return surface.polygon_one_sided.empty() || !surface.polygon_one_sided[polygon(t)];
        });
        sheet.two_sided = static_cast<Index>(one_sided - sheet.number.begin());
        for (const Index t : sheet.number) sheet.triangles.push_back(surface.triangles[t]);
        sheets_.push_back(std::move(sheet));
    }
    if (!empty()) draw(scene, view, cancel);
}

void Sheets::draw(const Scene& scene, const View& view, const Cancel& cancel) {
    std::vector<RasterMesh> meshes;
    for (const Sheet& sheet : sheets_) {
        const Placement& placement = scene.placements[sheet.placement];
        const Cut cut = cut_of(scene, placement);
        meshes.push_back({placement.surface->positions, sheet.triangles, sheet.number,
                          view.world_to_view * placement.object_to_world, 0, sheet.two_sided});
        if (cut.kept == Cut::part) meshes.back().cut = cut.plane;
    }
    rows_.resize(view.height);
    const auto target = raster_target(view, depth_layout(view, {.scale = 1, .margin = 0.0}));
    draw_triangles(target, meshes, &cancel, [&](const RasterTriangle& triangle, int y0, int y1) {
        const TriangleRows rows(triangle);
        for (int y = y0; y < y1; ++y)
            each_texel(
                rows, y, [](int, double) { return true; },
                [&](int x, double depth) {
                    rows_[y].fragments.push_back({x, triangle.mesh, triangle.triangle, static_cast<float>(depth)});
                });
    });
    parallel_for(rows_.size(), 1, [&](std::size_t y) {
        Row& row = rows_[y];
        if (row.fragments.empty()) return;
        std::ranges::sort(row.fragments, {},
                          [](const Fragment& f) { return std::tuple(f.x, -f.depth, f.sheet, f.triangle); });
        row.first.assign(std::size_t(view.width) + 1, 0);
        for (const Fragment& fragment : row.fragments) ++row.first[fragment.x + 1];
        std::partial_sum(row.first.begin(), row.first.end(), row.first.begin());
    });
}

In<Sheets::Fragment> Sheets::at(int x, int y) const {
    if (!has_row(y)) return {};
    const Index first = rows_[y].first[x];
    return In<Fragment>(rows_[y].fragments).subspan(first, rows_[y].first[x + 1] - first);
}

SeenTriangle Sheets::triangle(const Fragment& fragment, const ColorShader& shader) const {
    const Sheet& sheet = sheets_[fragment.sheet];
    return shader.triangle(sheet.placement, sheet.number[fragment.triangle]);
}

/// A sheet's triangle at a place of the image.
struct Layered {
    const SeenTriangle* triangle;
    dvec3 share;
    double distance;

    /// Whether both are met on a side, as triangles of one surface are on the side that they share.
    bool doubles(const Layered& other) const {
        return triangle->placement == other.triangle->placement && on_side() && other.on_side() &&
               std::abs(distance - other.distance) <= 1e-6 * distance;
    }
    static constexpr double slack = 1e-9;  // of the shares, of their sum

   private:
    bool on_side() const { return std::min({share.x, share.y, share.z}) <= slack * (share.x + share.y + share.z); }
};

/// Colors of the sheets alone, premultiplied; their alpha is how much they cover.
class SheetLayer {
   public:
    SheetLayer(const Tracer& tracer, const ColorShader& shader, const Items& items, const Sheets& sheets)
        : tracer_(tracer), view_(tracer.view()), meeting_(tracer), shader_(shader), items_(items), sheets_(sheets) {}

    /// At the centers of a row's pixels.
    void centers(int y, vec4* row) const {
        std::vector<Sheets::Fragment> known;
        std::vector<SeenTriangle> triangles;
        std::vector<Layered> found;
        for (int x = 0; x < view_.width; ++x) {
            const dvec2 px = middle_of(x, y);
            const In<Sheets::Fragment> before = seen(x, y);
            if (triangles.size() < before.size()) {
                triangles.resize(before.size());
                known.resize(before.size(), {-1, none, none, 0.0f});
            }
            found.clear();
            for (std::size_t i = 0; i < before.size(); ++i) {
                if (!(known[i] == before[i])) {
                    known[i] = before[i];
                    triangles[i] = sheets_.triangle(before[i], shader_);
                }
                const dvec3 share = triangles[i].screen.at(px);
                found.push_back({&triangles[i], share, triangles[i].screen.distance(share)});
            }
            row[x] = composite(found, px);
        }
    }

    /// Whether the colors at the centers around a pixel, of triangles others than its own, differ.
    bool at_edge(const Array<vec4>& centers, int x, int y) const {
        const vec4& own = centers[std::size_t(y) * view_.width + x];
        return any_around(view_, x, y, [&](int u, int v) {
            const vec4 by = glm::abs(centers[std::size_t(v) * view_.width + u] - own);
            return std::max({by.r, by.g, by.b, by.a}) > fine_color &&
                   (items_.at(u, v) != items_.at(x, y) || !std::ranges::equal(sheets_.at(u, v), sheets_.at(x, y)));
        });
    }

    /// The mean of the samples of a pixel.
    vec4 finely(int x, int y) const {
        std::vector<Index> items;
        std::vector<Sheets::Fragment> known;
        std::vector<SeenTriangle> before, triangles;
        any_around(view_, x, y, [&](int u, int v) {
            if (const Index item = items_.at(u, v); item != none && std::ranges::find(items, item) == items.end()) {
                items.push_back(item);
                before.push_back(items_.triangle(item, shader_));
            }
            for (const Sheets::Fragment& fragment : sheets_.at(u, v)) {
                if (std::ranges::find(known, fragment) != known.end()) continue;
                known.push_back(fragment);
                triangles.push_back(sheets_.triangle(fragment, shader_));
            }
            return false;
        });
        vec4 sum(0.0f);
        std::vector<Layered> found;
        for (int i = 0; i < fine_samples; ++i) {
            const dvec2 px = fine_sample(x, y, i);
            found.clear();
            for (const SeenTriangle& triangle : triangles)
                if (const auto here = meeting_.at(triangle, px, Layered::slack))
                    found.push_back({&triangle, here->share, here->distance});
            if (found.empty()) continue;
            const double reach = nearest(before, px);
            std::erase_if(found, [reach](const Layered& sheet) { return sheet.distance >= reach; });
            std::ranges::sort(found, {}, [](const Layered& m) {
                return std::tuple(m.distance, m.triangle->placement, m.triangle->triangle);
            });
            sum += composite(found, px);
        }
        return sum / float(fine_samples);
    }

   private:
    /// The sheets before the nearest occluding triangle at a pixel's center, the nearest first.
    In<Sheets::Fragment> seen(int x, int y) const {
        const In<Sheets::Fragment> all = sheets_.at(x, y);
        if (items_.at(x, y) == none) return all;
        const float depth = items_.depth(x, y);
        const auto behind =
            std::ranges::find_if(all, [depth](const Sheets::Fragment& f) { return !(f.depth > depth); });
        return all.first(behind - all.begin());
    }

    /// Distance of what occludes at a place, by the triangles around it or by a ray; infinite without any.
    double nearest(In<SeenTriangle> triangles, const dvec2& px) const {
        double distance = HUGE_VAL;
        for (const SeenTriangle& triangle : triangles)
            if (const auto here = meeting_.at(triangle, px)) distance = std::min(distance, here->distance);
        if (distance < HUGE_VAL) return distance;
        const auto hit = tracer_.seen(px);
        return hit ? hit->t : HUGE_VAL;
    }

    /// Of what is met there, the nearest first.
    vec4 composite(In<Layered> found, const dvec2& px) const {
        vec4 sum(0.0f);
        for (std::size_t i = 0; i < found.size(); ++i) {
            if (i > 0 && found[i].doubles(found[i - 1])) continue;
            const SeenTriangle& triangle = *found[i].triangle;
            const vec3 color = shader_.color(triangle, px, found[i].share);
            const vec4 whole = std::isfinite(color.x + color.y + color.z) ? vec4(color, 1.0f) : vec4(0, 0, 0, 1);
            sum += (1.0f - sum.a) * triangle.slot->opacity * whole;
        }
        return sum;
    }

    const Tracer& tracer_;
    const View& view_;
    Meeting meeting_;
    const ColorShader& shader_;
    const Items& items_;
    const Sheets& sheets_;
};

}  // namespace

void put_sheets(const Tracer& tracer, const SceneColor& colors, const ColorShader& shader, const Items& items,
                const Cancel& cancel, Array<vec4>& layer) {
    const View& view = tracer.view();
    const Sheets sheets(tracer.scene(), view, colors, cancel);
    if (sheets.empty()) return;
    const SheetLayer of_sheets(tracer, shader, items, sheets);
    Array<vec4> centers(layer.size(), vec4(0.0f));
    const auto rows = [&](const auto& row) {
        parallel_blocks(view.height, 4, [&](std::size_t, std::size_t begin, std::size_t end) {
            cancel.poll();
            for (std::size_t y = begin; y < end; ++y) row(int(y));
        });
    };
    rows([&](int y) {
        if (sheets.has_row(y)) of_sheets.centers(y, &centers[std::size_t(y) * view.width]);
    });
    rows([&](int y) {
        for (int x = 0; x < view.width; ++x) {
            const std::size_t i = std::size_t(y) * view.width + x;
            const vec4 sheet = of_sheets.at_edge(centers, x, y) ? of_sheets.finely(x, y) : centers[i];
            layer[i] = sheet + (1.0f - sheet.a) * layer[i];
        }
    });
}

}  // namespace fovea::color
