// SPDX-License-Identifier: GPL-3.0-or-later
// Pixels of a frame: color layer, focus effects, paper, and the passes.
#include <algorithm>

#include <fovea/base/check.h>
#include <fovea/color/effects.h>
#include <fovea/color/painted_image.h>
#include <fovea/color/wash.h>
#include <fovea/draw/along_lines.h>
#include <fovea/draw/frame.h>
#include <fovea/scene/seen.h>
#include <fovea/visibility/depth_image.h>

namespace fovea::draw {
namespace {

/// Distance from the placements of an object, including instances that it makes; null if there are none, then the
/// object's own position is used.
std::shared_ptr<const SurfaceDistance> surface_of(const std::string& name, const Job& job) {
    const Overrides& overrides = job.overrides;
    Array<std::uint8_t> named(overrides.objects.size());
    for (std::size_t i = 0; i < named.size(); ++i)
        named[i] = std::ranges::find(overrides.objects[i], name) != overrides.objects[i].end();
    Array<Index> placements;
    for (Index i = 0; i < overrides.objects_of_placement.size(); ++i)
        if (named[overrides.objects_of_placement[i]]) placements.push_back(i);
    if (!job.scene || placements.empty()) return nullptr;
    return std::make_shared<SurfaceDistance>(*job.scene, job.view, placements);
}

/// Amount of an effect per pixel, in [0, most]. `emphasis`: of all effects.
Array<float> amounts(const style::Transfer& transfer, double emphasis, In<float> focus, float most = 1.0f) {
    const Transfer answer = transfer_of(transfer, emphasis);
    Array<float> result(focus.size());
    parallel_for(focus.size(), [&](std::size_t i) { result[i] = most * answer(focus[i]); });
    return result;
}

/// Upsamples an image from view `fewer` to view `view` (nearest neighbor).
Array<float> magnified(const Array<float>& image, const View& fewer, const View& view) {
    const auto nearest = [](int i, int size, int of) { return int((i + 0.5) * of / size); };
    Array<float> result(std::size_t(view.width) * view.height);
    parallel_for(view.height, [&](std::size_t y) {
        const float* row = &image[std::size_t(nearest(int(y), view.height, fewer.height)) * fewer.width];
        for (int x = 0; x < view.width; ++x) result[y * view.width + x] = row[nearest(x, view.width, fewer.width)];
    });
    return result;
}

}  // namespace

void Frame::picture() {
    ink();
    if (has(Step::picture)) return;
    if (job.colors && job.style.has_color())
        stage("color", 0.05, [&] {
            const style::Color& color = job.style.color;
            const ColorSources& from = *job.colors;
            passes.color = color_layer(*tracer, from.surfaces, from.lights, from.world, color, cancel());
            if (color.desaturation != 0.0)
                desaturate(passes.color, Array<float>(passes.color.size(), float(color.desaturation)));
        });
    stage("focus", 0.05, [&] {
        if (job.options.with_focus || colors_answer()) passes.focus = focus_of_pixels();
        if (!passes.color.empty()) focus_colors();
    });
    stage("paper", 0.05, [&] { put_on_paper(passes.lines, passes.color, passes.combined); });
    if (job.options.with_depth)
        stage("depth", 0.05, [&] {
            depth();
            passes.depth = std::move(depth_);
        });
    if (wants_line_passes(job.options))
        stage("passes", 0.05, [&] {
            passes.of_lines = line_passes(*this);
            if (job.exposure) job.exposure->replace(passes.of_lines);
        });
    done_ = Step::picture;
}

/// Whether the color layer depends on focus.
bool Frame::colors_answer() const {
    const style::Effects& e = job.style.effects;
    const double strongest = std::max({e.desaturation.strength, e.fade.strength, e.blur.strength});
    return !passes.color.empty() && e.colors == style::Mode::emphasized && strongest > 0.0 && job.style.focus.active();
}

void Frame::focus_colors() {
    const style::Effects& e = job.style.effects;
    Array<float> uniform;
    if (e.colors == style::Mode::uniform) uniform.assign(passes.color.size(), float(e.uniform));
    const In<float> at = uniform.empty() ? In<float>(passes.focus) : In<float>(uniform);
    if (at.empty()) return;
    if (e.desaturation.strength != 0.0) desaturate(passes.color, amounts(e.desaturation, e.emphasis, at));
    const auto& background = job.style.color.background;
    if (e.fade.strength != 0.0)
        fade(passes.color, amounts(e.fade, e.emphasis, at),
             background ? std::optional(vec3(*background)) : std::nullopt);
    if (e.blur.strength != 0.0)
        blur(passes.color, job.view.width, amounts(e.blur, e.emphasis, at, float(e.blur_radius * scale())));
}

Array<vec4> Frame::ground() const {
    Array<vec4> pixels;
    put_on_paper(Array<vec4>(std::size_t(job.view.width) * job.view.height, vec4(0.0f)), passes.color, pixels);
    return pixels;
}

Array<vec4> Frame::bare_paper() const {
    Array<vec4> pixels;
    put_on_paper(Array<vec4>(std::size_t(job.view.width) * job.view.height, vec4(0.0f)), {}, pixels);
    return pixels;
}

Array<vec4> Frame::lines_of(In<std::uint8_t> pens) {
    check(strokes != nullptr, "frame: its strokes are not made yet");
    const std::shared_ptr<const Strokes> all = strokes;
    auto some = std::make_shared<Strokes>(*all);
    std::erase_if(some->triangles, [&](const glm::uvec3& t) { return !pens[all->pen[t.x]]; });
    strokes = some;
    const std::unique_ptr<void, std::function<void(void*)>> put_back(this, [&](void*) { strokes = all; });
    return job.backend->draw(*this);
}

void Frame::put_on_paper(In<vec4> lines, In<vec4> colors, Array<vec4>& out) const {
    const style::Paper& paper = job.style.paper;
    const Array<float> holdout = holdout_image(*tracer, cancel());
    const auto texture = job.assets->paper(paper.texture);
    const auto water = job.style.color.backruns > 0.0 ? job.assets->wash("water") : nullptr;
    const Array<float> density =
        paper.transparent ? Array<float>() : wash_density(colors, job.view, water.get(), paper, job.style.color);
    on_paper(lines, colors, density, holdout, job.view, texture.get(), paper, job.style.color, out);
}

Array<float> Frame::focus_of_pixels() {
    const style::Focus& focus = job.style.focus;
    const Cancelling scope(job.cancel.get());
    if (!focus.active()) return {};
    if (job.options.focus_step > 1 && focus.basis() != style::FocusBasis::image) return focus_of_fewer_pixels();
    if (focus.is_painted()) return inverted(painted_image(rays(), painted(focus.attribute), cancel()));
    if (focus.basis() == style::FocusBasis::image)
        return focus::focus_of_pixels(job.view, Array<float>(std::size_t(job.view.width) * job.view.height, 0.0f),
                                      focus_function());
    return focus::focus_of_pixels(job.view, depth(), focus_function());
}

/// Focus evaluated at a resolution reduced by focus_step, upsampled by nearest neighbor.
Array<float> Frame::focus_of_fewer_pixels() {
    Job coarse{.scene = job.scene, .view = smaller(job.view, 1.0 / job.options.focus_step), .style = {}};
    coarse.style.focus = job.style.focus;
    coarse.overrides = job.overrides;
    coarse.cancel = job.cancel;
    Frame fewer(std::move(coarse));
    // The focus function does not depend on the resolution if focus lies in the scene, and is costly to build.
    if (!job.style.focus.is_painted()) fewer.focus_ = focus_function();
    return magnified(fewer.focus_of_pixels(), fewer.job.view, job.view);
}

const Tracer& Frame::rays() {
    check(job.scene != nullptr, "frame: there is no scene");
    if (!tracer) tracer = std::make_shared<Tracer>(*job.scene, job.view);
    return *tracer;
}

const Array<float>& Frame::depth() {
    if (depth_.empty()) depth_ = depth_image(rays(), cancel());
    return depth_;
}

const Focus& Frame::focus_function() {
    if (focus_) return *focus_;
    const style::Focus& focus = job.style.focus;
    const bool of_objects = focus.basis() == style::FocusBasis::surfaces;
    const bool in_scene = of_objects || focus.basis() == style::FocusBasis::scene;
    Focus made{in_scene ? FocusSpace::scene : FocusSpace::image, {}, focus.combine == style::Combine::sum};
    const dvec4& frame = job.view.frame;  // left, lower, width, height
    if (focus.active())
        for (const style::FocusPlace& place : focus.points) {
            const double unit = in_scene ? 1.0 : frame.w;
            const dvec3 at = in_scene
                                 ? dvec3(job.view.world_to_view * dvec4(place.at, 1.0))
                                 : dvec3(frame.x + place.at.x * frame.z, frame.y + (1.0 - place.at.y) * frame.w, 0.0);
            made.points.push_back({vec3(at), float(place.near * unit), float(place.far * unit),
                                   of_objects ? surface_of(place.object, job) : nullptr});
        }
    return focus_.emplace(std::move(made));
}

}  // namespace fovea::draw
