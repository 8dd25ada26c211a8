// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/line/registry.h>

#include <fovea/base/check.h>

namespace fovea {

extern const LineDefinition contour, silhouette, crease, border, material_boundary, edge_mark, smooth_contour,
    smooth_silhouette, suggestive_contour, suggestive_highlight, principal_highlight_ridge, principal_highlight_valley,
    ridge, valley, apparent_ridge, demarcating_curve, laplacian_line, parabolic, zero_mean_curvature, isophote,
    topographic, intersection, image_edge, abstracted_shading;

const std::vector<const LineDefinition*>& line_definitions() {
    static const std::vector<const LineDefinition*> all = {
        &contour,
        &silhouette,
        &crease,
        &border,
        &material_boundary,
        &edge_mark,
        &smooth_contour,
        &smooth_silhouette,
        &suggestive_contour,
        &suggestive_highlight,
        &principal_highlight_ridge,
        &principal_highlight_valley,
        &ridge,
        &valley,
        &apparent_ridge,
        &demarcating_curve,
        &laplacian_line,
        &parabolic,
        &zero_mean_curvature,
        &isophote,
        &topographic,
        &intersection,
        &image_edge,
        &abstracted_shading,
    };
    return all;
}

Kinds smooth_contours() {
    static const Kinds bits = [] {
        Kinds all = 0;
        for (Index i = 0; i < line_definitions().size(); ++i)
            if (line_definitions()[i]->on_smooth_surface) all |= Kinds(1) << i;
        return all;
    }();
    return bits;
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

}  // namespace fovea
