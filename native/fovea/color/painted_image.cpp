// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/color/painted_image.h>

#include <algorithm>
#include <map>

#include <fovea/color/layer.h>

namespace fovea::color {
namespace {

/// Unlit gray with the painted values, of which a surface without polygons shows none.
std::shared_ptr<const SurfaceColor> gray(const Surface& surface, In<float> values) {
    if (surface.corner_count() == 0) values = {};
    auto color = std::make_shared<SurfaceColor>();
    ColorSlot slot;
    slot.color = vec3(values.empty() ? unpainted : 1.0f);
    slot.unlit = true;
    if (!values.empty()) {
        slot.attribute = 0;
        color->attributes.emplace_back(values.size());
        std::ranges::transform(values, color->attributes[0].begin(), [](float v) { return vec3(painted_value(v)); });
    }
    const auto last = std::ranges::max_element(surface.polygon_material);
    const int slots = last == surface.polygon_material.end() ? 1 : std::max(*last, 0) + 1;
    color->slots.assign(static_cast<std::size_t>(slots), slot);
    return color;
}

}  // namespace

Array<float> painted_image(const Tracer& tracer, const Painted& painted, const Cancel& cancel) {
    const Scene& scene = tracer.scene();
    check_painted(painted, scene);
    std::map<std::pair<const Surface*, const float*>, std::shared_ptr<const SurfaceColor>> known;
    SceneColor colors;
    for (std::size_t i = 0; i < painted.size(); ++i) {
        const Surface& surface = *scene.placements[i].surface;
        auto& color = known[{&surface, painted[i].data()}];
        if (!color) color = gray(surface, painted[i]);
        colors.push_back(color);
    }
    style::Color flat;
    flat.shading = Shading::flat;
    const Array<vec4> layer = color_layer(tracer, colors, {}, vec3(0.0f), flat, cancel);
    Array<float> values(layer.size());
    parallel_for(layer.size(), [&](std::size_t i) { values[i] = layer[i].r; });
    return values;
}

}  // namespace fovea::color
