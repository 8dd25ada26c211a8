// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/line/registry.h>

#include <algorithm>

#include <fovea/base/check.h>

// In the order of their bits in Kinds; each constant is in the file of the same name.
// clang-format off
#define FOVEA_LINE_DEFINITIONS(define) \
    define(contour)                    \
    define(silhouette)                 \
    define(crease)                     \
    define(border)                     \
    define(material_boundary)          \
    define(edge_mark)                  \
    define(smooth_contour)             \
    define(smooth_silhouette)          \
    define(suggestive_contour)         \
    define(suggestive_highlight)       \
    define(principal_highlight_ridge)  \
    define(principal_highlight_valley) \
    define(ridge)                      \
    define(valley)                     \
    define(apparent_ridge)             \
    define(demarcating_curve)          \
    define(laplacian_line)             \
    define(parabolic)                  \
    define(zero_mean_curvature)        \
    define(isophote)                   \
    define(topographic)                \
    define(intersection)               \
    define(image_edge)                 \
    define(abstracted_shading)         \
    define(section_cut)                \
    define(section_hatch)              \
    define(light_contour)              \
    define(cast_shadow)                \
    define(hatching)                   \
    define(learned_line)
// clang-format on

namespace fovea::line {

#define FOVEA_DECLARE(name) extern const LineDefinition name;
FOVEA_LINE_DEFINITIONS(FOVEA_DECLARE)

#define FOVEA_ADDRESS(name) &(name),
const std::vector<const LineDefinition*>& line_definitions() {
    static const std::vector<const LineDefinition*> all = {FOVEA_LINE_DEFINITIONS(FOVEA_ADDRESS)};
    return all;
}

namespace {

/// Bits of the definitions that satisfy is_one(LineDefinition).
template <typename IsOne>
Kinds kinds_that(const IsOne& is_one) {
    Kinds bits = 0;
    for (Index i = 0; i < line_definitions().size(); ++i)
        if (is_one(*line_definitions()[i])) bits |= Kinds(1) << i;
    return bits;
}

bool is_smooth_contour(const LineDefinition& definition) {
    const auto* curves = std::get_if<CurveRule>(&definition.rule);
    return curves && curves->type == CurveType::contour;
}

/// Whether a definition finds all contours of the smooth surface, not only some of those of another definition.
bool is_whole_contour(const LineDefinition& definition) {
    return is_smooth_contour(definition) && !std::get<CurveRule>(definition.rule).part_of;
}

}  // namespace

Kinds smooth_contours() {
    static const Kinds bits = kinds_that(is_smooth_contour);
    return bits;
}

Kinds contours() {
    static const Kinds bits = smooth_contours() | kinds_that([](const LineDefinition& definition) {
                                  return definition.smooth_twin && is_whole_contour(*definition.smooth_twin);
                              });
    return bits;
}

Kinds kinds_of_one_shade() {
    static const Kinds bits = kinds_that([](const LineDefinition& definition) { return definition.shade.has_value(); });
    return bits;
}

Kinds kinds_in_section() {
    static const Kinds bits = kinds_that([](const LineDefinition& definition) { return definition.in_section; });
    return bits;
}

Kinds kind_of(const LineDefinition& definition) {
    return kinds_that([&](const LineDefinition& other) { return &other == &definition; });
}

Index definition_index(std::string_view name) {
    std::string known;
    const auto& all = line_definitions();
    for (Index i = 0; i < all.size(); ++i) {
        if (all[i]->name == name) return i;
        known += (i ? ", " : "") + std::string(all[i]->name);
    }
    check(false, "no line definition is called '" + std::string(name) + "'; there are: " + known);
    return none;
}

const LineDefinition& definition_called(std::string_view name) { return *line_definitions()[definition_index(name)]; }

Values values_of(const LineDefinition& definition, std::span<const std::pair<std::string, ParameterValue>> given,
                 const Files& files) {
    Values values = default_values(definition);
    for (const auto& [name, value] : given) {
        if (definition.file && name == definition.file->name) {
            const auto found = files.find(value.file);
            if (found != files.end()) values.file = found->second;
            continue;
        }
        const auto known = std::ranges::find_if(definition.parameters, [&](const auto& p) { return p.name == name; });
        check(known != definition.parameters.end(),
              std::string(definition.name) + ": unknown parameter '" + name + "'");
        values[known - definition.parameters.begin()] = value.number;
    }
    return values;
}

}  // namespace fovea::line
