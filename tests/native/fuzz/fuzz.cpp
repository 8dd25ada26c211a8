// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz.h"

#include <nlohmann/json.hpp>
#include <sstream>

#include <fovea/style/json.h>
#include <fovea/style/mix.h>

#include "random_job.h"
#include "random_style.h"
#include "refused.h"
#include "rules.h"

namespace fovea::fuzz {
namespace {

using nlohmann::ordered_json;

constexpr const char* kinds[] = {"meshes", "styles"};

void draw_picture(Job job) {
    Frame frame(std::move(job));
    frame.picture();
    check_arrays(frame);
}

ordered_json told(const Surface& surface) {
    return {{"name", surface.name()},
            {"vertices", surface.vertex_count()},
            {"polygons", surface.polygon_count()},
            {"triangles", surface.triangles.size()},
            {"center", {surface.center.x, surface.center.y, surface.center.z}},
            {"radius", surface.radius}};
}

ordered_json told(const dmat4& matrix) {
    ordered_json rows;
    for (int r = 0; r < 4; ++r) rows.push_back({matrix[0][r], matrix[1][r], matrix[2][r], matrix[3][r]});
    return rows;
}

ordered_json told(const View& view) {
    return {{"world_to_view", told(view.world_to_view)},
            {"view_to_clip", told(view.view_to_clip)},
            {"size", {view.width, view.height}},
            {"orthographic", view.orthographic},
            {"near_clip", view.near_clip},
            {"far_clip", view.far_clip},
            {"reference_scale", view.reference_scale}};
}

ordered_json told(const Options& options) {
    ordered_json members;
    style::for_each_field<Options>([&]<typename V>(const style::Field<Options, V>& field) {
        if constexpr (std::is_arithmetic_v<V>) members[field.name] = options.*field.member;
        if constexpr (std::is_enum_v<V>) members[field.name] = style::choices_of<V>[int(options.*field.member)].name;
    });
    return members;
}

void draw_mesh(Choices& choices) {
    OwningJob made = random_job(choices);
    if (made.job.style.elision.enabled && made.job.style.elision.frames > 0) {
        Frame before(made.job);
        made.job.near = {{-1, before.found_lines()->lines}};
    }
    draw_picture(std::move(made.job));
}

/// What is read is written and read again as the same.
void draw_style(Choices& choices) {
    const style::Shipped shipped{{std::begin(textures), std::end(textures)}, {std::begin(papers), std::end(papers)}};
    const std::string json = mutated(choices, style::write_style(random_style(choices)));
    const style::Style style = style::read_style(json, &shipped);
    const std::string written = style::write_style(style);
    const style::Style again = style::read_style(written, &shipped);
    if (again != style || style::write_style(again) != written) throw Broken("a style is not what it was written as");
    if (!choices.chance(0.2)) return draw_picture(plain_job(style));
    const style::Style other = style::read_style(style::write_style(random_style(choices)));
    draw_picture(plain_job(style::mix(style, other, choices.about_one())));
}

Choices choices_of(const Input& input) { return Choices(hash_numbers(input.kind, input.seed)); }

}  // namespace

std::string Input::text() const { return std::string(kinds[kind]) + " " + std::to_string(seed); }

Input Input::read(const std::string& text) {
    std::istringstream words(text);
    std::string kind;
    Input input;
    words >> kind >> input.seed;
    const auto known = std::ranges::find(kinds, kind);
    check(words && known != std::end(kinds), "'" + text + "' is no input: 'meshes' or 'styles' and a number expected");
    input.kind = static_cast<Kind>(known - kinds);
    return input;
}

std::string description(const Input& input) {
    Choices choices = choices_of(input);
    if (input.kind == Input::styles) return mutated(choices, style::write_style(random_style(choices)));
    const OwningJob made = random_job(choices);
    ordered_json all{{"view", told(made.job.view)}, {"options", told(made.job.options)}};
    for (const Placement& placement : made.job.scene->placements)
        all["placements"].push_back({{"surface", told(*placement.surface)},
                                     {"object_to_world", told(placement.object_to_world)},
                                     {"usage", placement.usage}});
    all["style"] = ordered_json::parse(style::write_style(made.job.style));
    return all.dump(2);
}

std::string run(const Input& input) {
    Choices choices = choices_of(input);
    const std::string message =
        refused([&] { input.kind == Input::meshes ? draw_mesh(choices) : draw_style(choices); });
    if (!message.empty()) check_sentence(message);
    return message;
}

}  // namespace fovea::fuzz
