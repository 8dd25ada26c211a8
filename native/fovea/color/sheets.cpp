// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/color/sheets.h>

#include <algorithm>
#include <numeric>
#include <tuple>

#include <fovea/scene/section.h>
#include <fovea/visibility/depth.h>

namespace fovea::color {

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
    if (empty() || rows_[y].first.empty()) return {};
    const Index first = rows_[y].first[x];
    return In<Fragment>(rows_[y].fragments).subspan(first, rows_[y].first[x + 1] - first);
}

SeenTriangle Sheets::triangle(const Fragment& fragment, const ColorShader& shader) const {
    const Sheet& sheet = sheets_[fragment.sheet];
    return shader.triangle(sheet.placement, sheet.number[fragment.triangle]);
}

}  // namespace fovea::color
