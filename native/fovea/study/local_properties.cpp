// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/study/local_properties.h>

#include <algorithm>
#include <cmath>

#include <fovea/field/corner_normals.h>
#include <fovea/field/fields.h>
#include <fovea/field/view_curvature.h>
#include <fovea/image/gaussian.h>
#include <fovea/image/local_fit.h>
#include <fovea/image/shaded_buffer.h>
#include <fovea/line/look_at.h>
#include <fovea/mesh/stretch.h>
#include <fovea/study/curvature_at.h>
#include <fovea/study/nearest_pixel.h>

namespace fovea::study {
namespace {

constexpr double blur = 2.0;           // px
constexpr double around = 2.0 * blur;  // px beyond outlines: what is known there, too
constexpr float tone_of_paper = 1.0f;

float& at(PropertyRow& row, Property property) { return row[std::size_t(property)]; }

/// The nodes of a shaded scene that properties are of.
struct Nodes {
    const image::ShadedBuffer& shaded;
    int border;
    int width = shaded.lattice.width - 2 * border, height = shaded.lattice.height - 2 * border;

    std::size_t number(int x, int y) const { return std::size_t(y) * std::size_t(width) + std::size_t(x); }
    dvec2 px(int x, int y) const { return shaded.lattice.px(dvec2(x + border, y + border)); }
};

/// Properties of the image. `sigma`: the blur, in steps.
void add_image(const Nodes& nodes, double sigma, LocalProperties& found) {
    const image::ShadedBuffer& shaded = nodes.shaded;
    const image::Lattice& lattice = shaded.lattice;
    image::Buffer tone(lattice.size());
    parallel_for(tone.size(),
                 [&](std::size_t i) { tone[i] = shaded.tone[i] + (1.0f - shaded.coverage[i]) * tone_of_paper; });
    const image::Buffer smooth = image::gaussian(tone, lattice.width, lattice.height, sigma);
    const auto unit = float(sigma);
    parallel_for(std::size_t(nodes.height), 8, [&](std::size_t y) {
        for (int x = 0; x < nodes.width; ++x) {
            const int i = x + nodes.border, j = int(y) + nodes.border;
            const image::LocalFit fit = image::fit_at(smooth, lattice, i, j);
            PropertyRow& row = found.rows[nodes.number(x, int(y))];
            at(row, Property::luminance) = tone[lattice.at(i, j)];
            at(row, Property::image_gradient) = unit * glm::length(fit.gradient);
            at(row, Property::image_most_curvature) = unit * unit * image::greatest_bend(fit, 1.0f).curvature;
            at(row, Property::image_least_curvature) = -unit * unit * image::greatest_bend(fit, -1.0f).curvature;
        }
    });
}

/// A placement with what is known of its vertices.
struct Placed {
    std::shared_ptr<const Surface> surface;  // pre-stretched
    std::shared_ptr<const field::Fields> fields;
    std::shared_ptr<const field::CornerNormals> normals;
    glm::mat3 normal_to_view{1.0f};
    dvec3 eye{0.0};  // as SurfaceView has it
};

std::vector<Placed> placed_of(const Tracer& tracer, const Cancel& cancel) {
    const auto& placements = tracer.scene().placements;
    std::vector<Placed> all(placements.size());
    for (std::size_t i = 0; i < all.size(); ++i) {
        cancel.poll();
        const Placement& placement = placements[i];
        if (!(placement.usage & usage_draw) || !in_frame(placement, tracer.view(), image::lattice_margin)) continue;
        Placed& placed = all[i];
        placed.surface = as_placed(placement.surface, placement.object_to_world);
        placed.fields = field::fields_of(*placed.surface);
        placed.normals = field::corner_normals(*placement.surface);
        const dmat3 to_view(tracer.view().world_to_view * placement.object_to_world);
        placed.normal_to_view = glm::mat3(glm::transpose(glm::inverse(to_view)));
        placed.eye = line::look_at(*placed.surface, Index(i), tracer).eye_obj;
    }
    return all;
}

/// n . v of the shading normal, and whether the surface is seen from its back.
std::pair<float, bool> facing_at(const Tracer& tracer, const Placed& placed, const Hit& hit, const vec3& to_eye) {
    const Surface& surface = *tracer.scene().placements[hit.placement].surface;
    const Triangle& t = surface.triangles[hit.triangle];
    const auto normal = [&](int k) { return placed.normals->at(t, hit.triangle, k); };
    const vec3 mixed = (1.0f - hit.u - hit.v) * normal(0) + hit.u * normal(1) + hit.v * normal(2);
    const vec3 turned = placed.normal_to_view * mixed;
    const vec3 facet = placed.normal_to_view * vec3(surface.facet_plane[surface.triangle_facet[hit.triangle]]);
    const bool from_back = glm::dot(facet, to_eye) < 0.0f;
    const float value = (from_back ? -1.0f : 1.0f) * glm::dot(turned, to_eye) / glm::length(turned);
    return {std::clamp(value, 0.0f, 1.0f), from_back};
}

/// Properties of the surface and of the view.
void set_surface(const Placed& placed, const Hit& hit, bool from_back, bool orthographic, PropertyRow& row) {
    const Triangle& t = placed.surface->triangles[hit.triangle];
    const auto& p = placed.surface->positions;
    const vec3 weights(1.0f - hit.u - hit.v, hit.u, hit.v);
    const auto& curvature = placed.fields->curvature;
    field::CurvatureD c = mixed(curvature[t.x], curvature[t.y], curvature[t.z], weights);
    if (from_back) c = turned_around(c);
    const double unit = placed.fields->feature_size;
    c.k1 *= unit, c.k2 *= unit;
    for (double& third : c.C) third *= unit * unit;
    const dvec3 point =
        double(weights.x) * dvec3(p[t.x]) + double(weights.y) * dvec3(p[t.y]) + double(weights.z) * dvec3(p[t.z]);
    const dvec3 towards = orthographic ? placed.eye : placed.eye - point;
    const double distance = glm::length(towards);
    const auto seen = field::see(c, towards / distance, orthographic ? 0.0 : unit / distance);
    const auto view = field::view_curvature(c, seen);
    const auto radial = field::radial(c, seen);
    const double as_seen = std::sqrt(view.squared);
    const auto set = [&](Property property, double value) {
        at(row, property) = std::isfinite(value) ? float(value) : 0.0f;
    };
    set(Property::first_curvature, c.k1);
    set(Property::second_curvature, c.k2);
    set(Property::mean_curvature, 0.5 * (c.k1 + c.k2));
    set(Property::gaussian_curvature, c.k1 * c.k2);
    set(Property::first_curvature_change, std::abs(c.C[0]));
    set(Property::view_curvature, as_seen);
    set(Property::view_curvature_change, as_seen > 0.0 ? std::abs(view.derivative) / (2.0 * as_seen) : 0.0);
    set(Property::radial_curvature, radial.curvature);
    set(Property::radial_curvature_change, radial.derivative);
    set(Property::radial_torsion, radial.torsion);
}

void add_surfaces(const Tracer& tracer, const Nodes& nodes, const Cancel& cancel, LocalProperties& found) {
    const View& view = tracer.view();
    const std::vector<Placed> placed = placed_of(tracer, cancel);
    const dmat4 clip_to_view = glm::inverse(view.view_to_clip);
    parallel_for(std::size_t(nodes.height), 1, [&](std::size_t y) {
        cancel.poll();
        for (int x = 0; x < nodes.width; ++x) {
            const dvec2 px = nodes.px(x, int(y));
            const auto hit = tracer.seen(px);
            if (!hit || !placed[hit->placement].surface) continue;
            const std::size_t i = nodes.number(x, int(y));
            const vec3 to_eye =
                view.orthographic ? vec3(0, 0, 1) : vec3(glm::normalize(-from_pixels(view, clip_to_view, px, 1.0)));
            const auto [facing, from_back] = facing_at(tracer, placed[hit->placement], *hit, to_eye);
            found.known.set[i] = 1;
            at(found.rows[i], Property::facing) = facing;
            set_surface(placed[hit->placement], *hit, from_back, view.orthographic, found.rows[i]);
        }
    });
}

/// Pixels beside surfaces get their properties.
void widen(double distance, LocalProperties& found) {
    const Array<Index> nearest = nearest_pixels(found.known);
    const int width = found.known.width;
    constexpr auto first = std::size_t(Property::first_curvature);
    Bitmap known = found.known;
    parallel_for(nearest.size(), [&](std::size_t i) {
        const Index from = nearest[i];
        if (found.known.set[i] || from == none) return;
        if (glm::distance(center_of(i, width), center_of(from, width)) > distance) return;
        known.set[i] = 1;
        std::copy(found.rows[from].begin() + first, found.rows[from].end(), found.rows[i].begin() + first);
    });
    found.known = std::move(known);
}

}  // namespace

LocalProperties local_properties(const Tracer& tracer, const image::ShadedBuffer& shaded, int border,
                                 const Cancel& cancel) {
    const Nodes nodes{shaded, border};
    const double scale = scale_of(tracer.view().width, tracer.view().height) / shaded.lattice.step_px;
    LocalProperties found{Bitmap(nodes.width, nodes.height), {}};
    found.rows.assign(found.known.set.size(), PropertyRow{});
    add_image(nodes, blur * scale, found);
    add_surfaces(tracer, nodes, cancel, found);
    widen(around * scale, found);
    for (std::size_t i = 0; i < found.rows.size(); ++i)
        if (!found.known.set[i]) found.rows[i] = {};
    return found;
}

LocalProperties local_properties(const Tracer& tracer, const Cancel& cancel) {
    tracer.check_current();
    const View& view = tracer.view();
    const int border = int(std::ceil(3.5 * blur * scale_of(view.width, view.height))) + image::fit_reach;
    const image::Lattice lattice{dvec2(0.5 - border), 1.0, view.width + 2 * border, view.height + 2 * border};
    return local_properties(tracer, image::shade(tracer, lattice, {}, cancel), border, cancel);
}

}  // namespace fovea::study
