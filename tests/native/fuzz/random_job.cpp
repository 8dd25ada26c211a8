// SPDX-License-Identifier: GPL-3.0-or-later
#include "random_job.h"

#include <fovea/style/json.h>

#include "drawing.h"
#include "random_style.h"
#include "random_surface.h"

namespace fovea::fuzz {
namespace {

dvec3 direction(Choices& choices) {
    const dvec3 to{choices.between(-1.0, 1.0), choices.between(-1.0, 1.0), choices.between(-1.0, 1.0)};
    return glm::length(to) > 0.0 ? glm::normalize(to) : dvec3(0, 0, 1);
}

/// Mostly a motion; sometimes with scales of its own, mirrored, flat, endless, or of no meaning.
dmat4 placing(Choices& choices) {
    const dvec3 axis = direction(choices);
    dmat4 matrix = glm::rotate(dmat4(1.0), choices.between(0.0, 6.3), axis);
    switch (choices.below(14)) {
        case 0:
            matrix[choices.below(3)] *= -1.0;
            break;
        case 1:
            matrix[choices.below(3)] *= choices.one_of({0.0, 1e-12, 0.1, 20.0});
            break;
        case 2:
            matrix[choices.below(4)][choices.below(4)] = choices.broken();
            break;
        case 3:
            for (int i = 0; i < 3; ++i) matrix[i] *= choices.size(-6.0, 6.0);
            break;
        case 4:
            matrix *= choices.size(-100.0, 100.0);
            break;
        case 5:
            matrix[choices.below(4)][choices.below(4)] += choices.about_one();  // sheared, or no affine map
            break;
        default:
            break;
    }
    matrix[3] += dvec4(choices.about_one(), choices.about_one(), choices.about_one(), 0.0);
    return matrix;
}

int side(Choices& choices) {
    return choices.chance(0.02)  ? choices.one_of({0, -1})
           : choices.chance(0.1) ? choices.one_of({1, 2, 3, 150})
                                 : choices.between(8, 48);
}

View random_view(Choices& choices) {
    const dvec3 to = direction(choices);
    const double away = choices.chance(0.8) ? choices.between(0.5, 8.0) : choices.size(-4.0, 9.0);
    const int width = side(choices), height = side(choices);
    const double near = choices.chance(0.6) ? 0.1 : choices.chance(0.9) ? choices.size(-9.0, 2.0) : choices.broken();
    const double far = choices.chance(0.8)   ? near + 1000.0
                       : choices.chance(0.8) ? choices.size(-9.0, 12.0)
                                             : choices.broken();
    const double lens = choices.chance(0.7) ? choices.between(15.0, 100.0) : choices.size(-3.0, 6.0);
    View view;
    view.world_to_view = drawing::look_at(to * away, {choices.about_one(), 0.0, 0.0});
    view.width = width;
    view.height = height;
    view.near_clip = near;
    view.far_clip = far;
    view.orthographic = choices.chance(0.25);
    const double right = view.orthographic ? 50.0 / lens * away : near * 18.0 / lens;
    const double top = right * std::max(height, 1) / std::max(width, 1), shift = choices.chance(0.1) ? right : 0.0;
    view.view_to_clip = view.orthographic ? glm::ortho(shift - right, shift + right, -top, top, near, far)
                                          : glm::frustum(shift - right, shift + right, -top, top, near, far);
    // A small part of a large frame, mostly: lines in the image have as many nodes to a frame at any size.
    view.reference_scale = choices.chance(0.02) ? std::max(height, 1) / reference_height : choices.size(-0.7, 0.3);
    view.frame = dvec4(0.0, 0.0, width, height);
    if (choices.chance(0.1)) view.frame = dvec4(-choices.between(0, 50), -choices.between(0, 50), 200.0, 150.0);
    if (choices.chance(0.05)) view.world_to_view[choices.below(4)][choices.below(4)] = choices.broken();
    if (choices.chance(0.05)) view.view_to_clip[choices.below(4)][choices.below(4)] = choices.broken();
    if (choices.chance(0.02)) view.reference_scale = choices.broken();
    if (choices.chance(0.02)) view.frame[choices.below(4)] = choices.broken();
    return view;
}

Options random_options(Choices& choices) {
    Options options{.visibility = static_cast<Visibility>(choices.below(4)),
                    .sample_step = choices.between(0.5, 8.0),
                    .depth_scale = choices.between(1, 3),
                    .probes = choices.one_of({1, 4, 9, 16}),
                    .layers = choices.between(1, 3)};
    style::for_each_field<Options>([&]<typename V>(const style::Field<Options, V>& field) {
        if constexpr (std::is_same_v<V, double>) {
            if (choices.chance(0.03)) options.*field.member *= choices.one_of({0.1, 10.0, 100.0});
            if (choices.chance(0.003)) options.*field.member = choices.broken();
        } else if constexpr (std::is_same_v<V, int>) {
            if (choices.chance(0.004)) options.*field.member = choices.one_of({-1, 0, 17});
        }
    });
    options.focus_step = choices.chance(0.2) ? choices.between(2, 5) : options.focus_step;
    options.with_depth = choices.chance(0.5);
    options.with_focus = choices.chance(0.5);
    return options;
}

std::shared_ptr<const Scene> random_scene(Choices& choices) {
    std::vector<std::shared_ptr<const Surface>> surfaces;
    for (int i = choices.between(1, 2); i > 0; --i)
        surfaces.push_back(random_surface(choices, "Surface " + std::to_string(surfaces.size() + 1)));
    std::vector<Placement> placements;
    for (int i = choices.between(choices.chance(0.02) ? 0 : 1, 3); i > 0; --i) {
        Placement placement{.surface = choices.one_of(surfaces), .object_to_world = placing(choices)};
        placement.id = choices.chance(0.1) ? 7 : choices.bits();
        placement.usage = std::uint8_t(choices.chance(0.8) ? usage_draw | usage_occlude : choices.below(8));
        placement.group = choices.chance(0.2) ? std::uint64_t(choices.between(1, 2)) : 0;
        placements.push_back(std::move(placement));
    }
    return std::make_shared<Scene>(std::move(placements));
}

MaterialFilter random_filter(Choices& choices, std::size_t placements) {
    MaterialFilter filter{.row = {}, .masks = {{1, 0, 1}, {0}, {}}};
    for (std::size_t i = 0; i < placements; ++i)
        filter.row.push_back(Index(choices.below(choices.chance(0.02) ? 5 : 3)));
    return filter;
}

float value(Choices& choices, double broken) {
    return float(choices.chance(broken) ? choices.broken() : choices.between(0.0, 1.0));
}

void override_some(Choices& choices, OwningJob& made) {
    Job& job = made.job;
    const auto& placements = job.scene->placements;
    const double broken = choices.one_of({0.0, 0.0, 0.2});
    const auto values = [&](std::size_t count) -> In<float> {
        std::vector<float>& kept = made.borrowed.emplace_back(choices.chance(0.01) ? count + 1 : count);
        for (float& v : kept) v = value(choices, broken);
        return kept;
    };
    if (choices.chance(0.2)) job.overrides.importance = values(placements.size());
    const style::Paint paint{style::PaintSource::attribute, "paint"};
    if (choices.chance(0.4))
        for (const Placement& placement : placements)
            job.overrides.painted[paint].push_back(choices.chance(0.5) ? values(placement.surface->corner_count())
                                                                       : In<float>());
    if (choices.chance(0.3))
        for (const Placement& placement : placements) job.overrides.objects.push_back({placement.surface->name()});
    if (choices.chance(0.2)) {
        std::vector<float> pixels(12);
        for (float& v : pixels) v = value(choices, broken);
        job.overrides.density_map = std::make_shared<ColorTexture>(pixels, 2, 2, 3, choices.chance(0.5));
    }
    OwnLines& lines = job.overrides.lines;
    if (choices.chance(0.1))
        for (std::size_t i = 0; i < placements.size(); ++i) lines.kinds.push_back(Kinds(choices.bits()));
    if (choices.chance(0.1)) lines.materials = random_filter(choices, placements.size());
    if (choices.chance(0.1)) {
        const auto definition = Index(choices.below(int(line_definitions().size())));
        const auto& parameters = line_definitions()[definition]->parameters;
        for (std::size_t p = 0; p < parameters.size(); ++p) {
            OwnLines::Parameter own{definition, Index(p), {}};
            for (std::size_t i = 0; i < placements.size(); ++i)
                own.values.push_back(choices.chance(0.3) ? NAN
                                                         : choices.between(parameters[p].low, parameters[p].high));
            lines.parameters.push_back(own);
        }
    }
    if (!choices.chance(0.1)) return;
    for (std::size_t set = 0; set < job.style.line_sets.size(); ++set) {
        draw::Overrides::Filter filter;
        for (std::size_t i = 0; i < placements.size(); ++i) filter.placements.push_back(std::uint8_t(choices.below(2)));
        if (choices.chance(0.5)) filter.materials = random_filter(choices, placements.size());
        job.overrides.line_sets.push_back(std::move(filter));
    }
}

std::shared_ptr<SurfaceColor> random_color(Choices& choices, const Surface& surface, double broken) {
    const auto number = [&] { return value(choices, broken); };
    auto color = std::make_shared<SurfaceColor>();
    const std::size_t corners = surface.corner_count();
    if (choices.chance(0.3)) {
        color->uvs.emplace_back(corners);
        for (vec2& uv : color->uvs[0]) uv = vec2{number(), number()};
    }
    if (choices.chance(0.3)) {
        color->attributes.emplace_back(corners);
        for (vec3& c : color->attributes[0]) c = vec3{number(), number(), number()};
    }
    if (choices.chance(0.3)) {
        color->normals.resize(choices.chance(0.01) ? 1 : corners);
        for (vec3& n : color->normals) n = vec3{number(), number(), number()};
    }
    for (int s = choices.below(3); s > 0; --s) {
        ColorSlot slot;
        slot.color = vec3{number(), number(), number()};
        slot.unlit = choices.chance(0.2);
        if (choices.chance(0.3)) slot.opacity = choices.chance(0.9) ? 0.3f : number();
        if (choices.chance(0.5)) {
            std::vector<float> pixels(12);
            for (float& v : pixels) v = number();
            slot.texture = std::make_shared<ColorTexture>(pixels, 4, 1, 3, true);
        }
        if (!color->uvs.empty() && choices.chance(0.8)) slot.uv = 0;
        if (!color->attributes.empty() && choices.chance(0.8)) slot.attribute = 0;
        if (choices.chance(0.01)) slot.uv = 3;
        color->slots.push_back(slot);
    }
    return color;
}

ColorSources random_colors(Choices& choices, const Scene& scene) {
    const double broken = choices.one_of({0.0, 0.0, 0.1});
    ColorSources sources;
    for (const Placement& placement : scene.placements)
        sources.surfaces.push_back(choices.chance(0.5) ? random_color(choices, *placement.surface, broken) : nullptr);
    for (int i = choices.below(4); i > 0; --i) {
        Light light{.kind = static_cast<Light::Kind>(choices.below(4))};
        light.position = 4.0 * direction(choices);
        light.direction = direction(choices);
        light.color = vec3{value(choices, broken), value(choices, broken), value(choices, broken)} * 10.0f;
        light.cos_outer = float(choices.between(-1.0, 1.0));
        light.cos_inner = choices.chance(0.1) ? light.cos_outer : std::min(1.0f, light.cos_outer + 0.1f);
        if (choices.chance(broken)) light.position[choices.below(3)] = choices.broken();
        if (choices.chance(broken)) light.direction = dvec3(choices.broken());
        sources.lights.push_back(light);
    }
    sources.world = vec3{value(choices, broken), value(choices, broken), value(choices, broken)};
    return sources;
}

std::shared_ptr<const Assets> shipped() {
    static const auto assets = std::make_shared<const Assets>(FOVEA_ADDON);
    return assets;
}

}  // namespace

OwningJob random_job(Choices& choices) {
    OwningJob made;
    Job& job = made.job;
    job.style = random_style(choices);
    job.view = random_view(choices);
    job.options = random_options(choices);
    job.assets = shipped();
    job.backend = std::make_shared<CpuBackend>(choices.one_of({6144, 6144, 256}));
    job.scene = random_scene(choices);
    job.style = style::read_style(style::write_style(job.style));
    override_some(choices, made);
    if (choices.chance(0.7)) {
        job.colors = random_colors(choices, *job.scene);
        auto lit = std::make_shared<Scene>(*job.scene);
        lit->lights = job.colors->lights;
        job.scene = lit;
    }
    if (choices.chance(0.05))
        for (const auto& [name, parameters] : job.style.line_sets[0].kinds)
            job.options.outlines.push_back({choices.between(0, 2), {name}});
    return made;
}

Job plain_job(const style::Style& style) {
    using namespace drawing;
    static const auto scene = std::make_shared<const Scene>(
        Scene({place(meshes::box()), place(meshes::sphere(8), moved({1.5, 2.5, 0.3}), 2)}));
    Job job{.scene = scene, .view = perspective({3, -8, 4}, {0, 1, 0}, 50, 64, 48), .style = style};
    job.view.reference_scale = 0.25;
    job.view.frame = dvec4(0.0, 0.0, 64.0, 48.0);
    job.options.with_depth = job.options.with_focus = true;
    job.assets = shipped();
    job.backend = std::make_shared<CpuBackend>();
    job.colors.emplace().surfaces.resize(2);
    return job;
}

}  // namespace fovea::fuzz
