// SPDX-License-Identifier: GPL-3.0-or-later
// Section cut: where the section plane cuts surfaces.
// In   triangles of all placements that are drawn, and the section plane (scene/section.h); independent of the view
// Out  curves on the plane, closed where surfaces are, in the object space of each placement
#include <fovea/line/definition.h>
#include <fovea/line/zero_set.h>
#include <fovea/scene/section.h>

namespace fovea::line {
namespace {

std::vector<SceneCurves> find_section_cut(const Scene& scene, In<Index> drawn, const Values&, const Cancel& cancel) {
    std::vector<SceneCurves> found;
    const auto always = [](auto) { return 1.0f; };
    for (const Index i : drawn) {
        const Cut cut = cut_of(scene, scene.placements[i]);
        if (cut.kept != Cut::part) continue;
        cancel.poll();
        const Surface& surface = *scene.placements[i].surface;
        const auto behind = [&](Index v) { return static_cast<float>(-cut.before(surface.positions[v])); };
        auto curves = std::make_shared<KeptCurves>();
        curves->pieces = trace_zero_set(surface, behind, always, always);
        for (CurvePiece& piece : curves->pieces) piece.other = piece.triangle;
        if (!curves->pieces.empty()) found.push_back({i, i, std::move(curves)});
    }
    return found;
}

}  // namespace

extern const LineDefinition section_cut = {
    .name = "section_cut",
    .label = "Section Cut",
    .source = "Common knowledge",
    .description = "Where the section plane of the scene cuts surfaces",
    .scope = Scope::placements,
    .importance = 1.0,
    .rule = SceneRule{find_section_cut,
                      [](const Surface& surface, const Values&, const Cancel&) { triangle_sides(surface); }},
    .in_section = true,
    .usual = true,
};

}  // namespace fovea::line
