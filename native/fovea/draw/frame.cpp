// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/draw/frame.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <tuple>

#include <fovea/base/check.h>
#include <fovea/color/map.h>
#include <fovea/color/section_fill.h>
#include <fovea/draw/along_lines.h>
#include <fovea/draw/methods.h>
#include <fovea/elision/figures.h>
#include <fovea/elision/opacity.h>
#include <fovea/elision/priority.h>
#include <fovea/path/extract.h>
#include <fovea/path/placed_set.h>
#include <fovea/project/project.h>
#include <fovea/runs/dots.h>
#include <fovea/runs/fair.h>
#include <fovea/runs/filters.h>
#include <fovea/runs/forks.h>
#include <fovea/runs/invisibility.h>
#include <fovea/runs/join_folds.h>
#include <fovea/runs/narrow_strips.h>
#include <fovea/runs/outer_parts.h>
#include <fovea/runs/own_roughness.h>
#include <fovea/stroke/tessellate.h>
#include <fovea/style/ranges.h>

namespace fovea::draw {
namespace {

constexpr double stub = 12.0;         // reference pixels; remainders of elided lines that are shorter are removed
constexpr double outline_step = 2.0;  // reference pixels between rays behind contours of groups
constexpr double hands_over = 12.0;   // reference pixels before its end at which a line begins to hand over to another

/// Files and Python cannot make pens with numbers out of their ranges, C++ can.
void check_pens(const style::Style& style) {
    for (const style::LineSet& set : style.line_sets) {
        const std::string where = "line set '" + set.name + "': ";
        style::check_ranges(set.pen, where + "pen.");
        if (set.pen_away) style::check_ranges(*set.pen_away, where + "pen_away.");
        for (const style::Hidden& hidden : set.hidden) {
            style::check_ranges(hidden.pen, where + "hidden pen.");
            if (hidden.pen_away) style::check_ranges(*hidden.pen_away, where + "hidden pen_away.");
        }
    }
}

}  // namespace

Frame::Frame(Job given) : job(std::move(given)) {
    check_view(job.view);
    style::check_ranges(job.options, "options.");
    check_pens(job.style);
}

void Frame::stage(const char* name, double share, const std::function<void()>& body) {
    if (job.progress) job.progress(share_, name);
    const auto start = std::chrono::steady_clock::now();
    const Cancelling scope(job.cancel.get());
    Cancelling::poll();
    body();
    const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - start;
    stages.emplace_back(name, took.count());
    share_ += share;
}

void Frame::find() {
    if (has(Step::find)) return;
    stage("bvh", 0.2, [&] { rays(); });
    const double step_px = std::max(job.options.sample_step * scale(), least_sample_step_px);
    stage("lines", 0.1, [&] {
        const std::vector<path::LineSet> sets = line_sets_of(job.style, job.overrides, job.files);
        path::check_filters(job.scene->placements.size(), sets, job.overrides.lines);
        const SharedSets shared = shared_by_light(sets, job.style);
        Paths found = extract_paths(*job.scene, job.view, shared.sets, *tracer, cancel(), job.overrides.lines,
                                    job.options.all_paths ? 0.0 : step_px);
        owners_ = shared.owners;
        if (!owners_.empty()) {
            owners_of_path_ = found.line_set;
            for (std::uint8_t& set : found.line_set) set = std::uint8_t(std::ranges::min(owners_[set]));
        }
        paths = std::make_shared<Paths>(std::move(found));
    });
    stage("project", 0.15, [&] {
        ProjectOptions options{.sample_step_px = step_px};
        for (const auto& set : job.style.line_sets) options.least_length_px.push_back(set.least_length * scale());
        clipped = std::make_shared<ClippedPaths>(project::project(*paths, *job.scene, job.view, options, cancel()));
    });
    done_ = Step::find;
}

void Frame::see() {
    find();
    if (has(Step::see)) return;
    check(job.backend != nullptr, "frame: there is no backend");
    stage("visibility", 0.25,
          [&] { visible = std::make_shared<Runs>(method_of(job.options.visibility).visible(*this)); });
    done_ = Step::see;
}

void Frame::filter() {
    see();
    if (has(Step::filter)) return;
    stage("runs", 0.05, [&] {
        const Options& o = job.options;
        const Index levels = job.style.counted();
        const Array<float> spurs = by_view(*paths, o.contour_spur * scale(), o.spur * scale());
        unfold();
        const Runs joined = close_gaps(*clipped, *visible, o.gap * scale(), spurs, o.spur * scale());
        Runs found = trim_folds(*clipped, joined, folding(*paths), o.fold * scale());
        const ForkOptions forks{o.contour_spur * scale(), o.fold * scale(), o.joint * scale()};
        found = without_forks(*clipped, found, *paths, *job.scene, forks);
        found = without_tips(*clipped, found, paths->placement, o.tip * scale(), o.beside * scale());
        found = without_dots(*clipped, found, *paths, *job.scene, o.dot * scale());
        found = without_narrow_strips(*clipped, found, *paths, *job.scene, job.view,
                                      spacing_by_path(*paths, scale(), job.style));
        if (levels > 0) {
            found =
                without_beside_visible(*clipped, with_hidden(*clipped, found, paths->placement), o.beside * scale());
            const Array<float> least = by_view(*paths, o.fold * scale(), o.least_hidden * scale());
            found = without_short_hidden(*clipped, found, least);
            if (levels > 1) found = count_invisibility(*clipped, *paths, *tracer, found, levels, cancel());
        }
        found = without_inner_outlines(*clipped, *paths, *tracer, std::move(found), outline_step * scale(), cancel());
        if (!owners_.empty()) part_by_light(found);
        runs = std::make_shared<Runs>(std::move(found));
        focus = focus_along_lines();
        distance = distance_along_lines();
    });
    done_ = Step::filter;
}

/// Takes folds out of contours, and zigzags of edges: replaces `clipped`, `visible` and `samples`.
void Frame::unfold() {
    const Options& o = job.options;
    const Runs whole = without_own_roughness(*clipped, *paths, rays(), *visible, o.fold * scale());
    Unfolded unfolded =
        join_folds(*clipped, whole, folding(*paths), o.fold * scale(), o.joint * scale(), o.contour_spur * scale());
    // What is decided while strokes are drawn is decided where the lines are.
    if (!method_of(o.visibility).in_strokes) fair(unfolded.clipped, *paths, *job.scene, o.fair * scale());
    clipped = std::make_shared<ClippedPaths>(std::move(unfolded.clipped));
    if (!samples.empty()) {
        const Array<float> all = std::move(samples);
        samples = parallel_map<float>(clipped->samples, [&](std::size_t s) { return all[unfolded.sample[s]]; });
    }
    visible = std::make_shared<Runs>(std::move(unfolded.runs));
}

/// Gives parts of lines to line sets by their light: replaces `paths`, `clipped` and `samples`.
void Frame::part_by_light(Runs& found) {
    LitLines parted = shared_out({paths, clipped, std::move(found), std::move(samples)}, owners_of_path_, owners_,
                                 *job.scene, job.view, job.options.gap * scale(), cancel());
    paths = std::move(parted.paths);
    clipped = std::move(parted.clipped);
    samples = std::move(parted.samples);
    found = std::move(parted.runs);
}

void Frame::thin() {
    filter();
    if (has(Step::thin)) return;
    if (thins())
        stage("elision", 0.05, [&] {
            const style::Elision& elision = job.style.elision;
            if (job.near.empty()) {
                shown = left(float(elision.cut));
                return;
            }
            const auto now = found_lines();
            std::vector<FrameNear> near;
            for (const auto& [away, lines] : job.near)
                if (lines.shown && away != 0 && std::abs(away) <= elision.frames) near.emplace_back(away, lines.shown);
            shown = smoothed_in_time(now->shown, *now->lines.shown, near, elision.frames);
            leave_out_faint();
        });
    done_ = Step::thin;
}

/// Of what elision leaves, that below its threshold.
void Frame::leave_out_faint() {
    const float cut = float(job.style.elision.cut);
    for (float& opacity : shown)
        if (opacity < cut) opacity = 0.0f;
}

void Frame::shape() {
    thin();
    if (has(Step::shape)) return;
    check(job.assets != nullptr, "frame: there are no assets");
    stage("shape", 0.05, [&] {
        Runs found = with_ends(over_frames(with_halos()));
        pens = pens_of(job.style, *job.assets, scale());
        if (job.options.outlines.empty())
            pen_of_run_ = pens_of_runs(*clipped, found, paths->line_set, pens.ranges);
        else
            std::tie(found, pen_of_run_) = outlined(found);
        drawn = std::make_shared<Runs>(std::move(found));
        if (hands_on()) {
            std::vector<MarkedNear> near;
            for (const auto& [away, lines] : job.near) near.emplace_back(away, lines.marked);
            const auto now = found_ ? found_->lines.marked : marked(lines_of_view());
            marks_ = marks_in_time(now, near, job.since_key, job.style.animation.marks_frames, job.baked_marks);
        }
        pen_paints_ = PenPaints(pens.pens, *paths, *job.scene, job.overrides);
        strokes = std::make_shared<Strokes>(strokes_with(shown));
    });
    done_ = Step::shape;
}

void Frame::ink() {
    shape();
    if (has(Step::ink)) return;
    stage("strokes", 0.1, [&] {
        if (job.exposure) {
            passes.lines = job.exposure->lines();
            return;
        }
        passes.lines = job.backend->draw(*this);
        const style::Section& section = job.style.section;
        if (section.filled)
            fill_section(section_sides(*job.scene, job.view), job.view, vec3(section.color), passes.lines);
    });
    done_ = Step::ink;
}

Emphasis Frame::emphasis(In<float> opacity) const {
    const style::Effects& effects = job.style.effects;
    const auto by_focus = [&](const style::Transfer& effect) { return transfer_of(effect, effects.emphasis); };
    return {.focus = focus,
            .distance = distance,
            .shown = opacity,
            .seen = seen,
            .color = by_focus(effects.color),
            .texture = by_focus(effects.texture),
            .width = by_focus(effects.width),
            .opacity = by_focus(effects.opacity),
            .distance_width = transfer_of(job.style.distance.width),
            .distance_opacity = transfer_of(job.style.distance.opacity)};
}

Inking Frame::inking(In<float> opacity) const {
    check(drawn != nullptr, "frame: its strokes are not made yet");
    Inking made{*clipped,          *drawn,    pen_of_run_,
                paths->strength,   pens.pens, at_ends_.empty() ? samples : at_ends_,
                emphasis(opacity), paths->id, paths.get()};
    made.marks = &marks_;
    made.paints = pen_paints_.of_pens();
    const style::Animation& animation = job.style.animation;
    made.moment = {animation.boil, job.options.boil_drawing, animation.written, animation.vanish};
    return made;
}

Strokes Frame::strokes_with(In<float> opacity) const { return tessellate(inking(opacity)); }

Runs Frame::with_halos() const {
    std::vector<double> halos;
    for (const style::LineSet& set : job.style.line_sets) halos.push_back(set.halo);
    return halo(*clipped, *runs, by_path(*paths, scale(), halos), folding(*paths));
}

/// Runs for strokes: with contours extended to meet other lines, and overshoot. Overshoot is at most a quarter of a
/// line's length.
Runs Frame::with_ends(const Runs& runs) const {
    std::vector<double> near, away;
    for (const style::LineSet& set : job.style.line_sets) {
        near.push_back(set.overshoot);
        away.push_back(set.overshoot_away.value_or(set.overshoot));
    }
    const Runs joined = meet_ends(*clipped, runs, folding(*paths), meeting(*paths), job.options.meet * scale());
    const Array<double> lengths = lengths_in_frame(*paths, *clipped);
    const auto reach = [&](const std::vector<double>& of_set) {
        Array<float> amounts = by_path(*paths, scale(), of_set);
        for (std::size_t p = 0; p < amounts.size(); ++p)
            amounts[p] = float(std::min(double(amounts[p]), lengths[p] / 4.0));
        return amounts;
    };
    const style::Transfer& answer = job.style.effects.overshoot;
    if (focus.empty() || answer.strength == 0.0) return overshoot(*clipped, joined, reach(near));
    Array<float> mix(focus.size());
    std::ranges::transform(focus, mix.begin(), transfer_of(answer, job.style.effects.emphasis));
    return overshoot(*clipped, joined, reach(near), reach(away), mix);
}

bool Frame::thins() const { return job.style.elision.enabled && !method_of(job.options.visibility).in_strokes; }

bool Frame::lasts() const {
    return job.style.animation.visibility_frames > 0 && !method_of(job.options.visibility).in_strokes;
}

bool Frame::hands_on() const {
    const style::Animation& animation = job.style.animation;
    return (animation.marks_frames > 0 || animation.marks_baked) && !method_of(job.options.visibility).in_strokes &&
           job.assets && job.style.fixes_marks();
}

/// Per line set: length of the marks that its pens fix to paths [px], of the first one that does: in focus before out
/// of it, of visible parts before hidden ones; 0: none does.
std::vector<double> Frame::mark_lengths() const {
    const Pens all = pens_of(job.style, *job.assets, scale());
    std::vector<double> lengths(job.style.line_sets.size(), 0.0);
    for (const PenRange& range : all.ranges)
        for (const Index pen : {range.pen, all.pens[range.pen].away})
            if (pen != none && lengths[range.line_set] == 0.0 && is_anchored(all.pens[pen]))
                lengths[range.line_set] = mark_length_px(all.pens[pen]);
    return lengths;
}

std::string Frame::visibility_in_words() const {
    const Options& o = job.options;
    const Method& method = method_of(o.visibility);
    const std::string quality = method.quality ? ", " + std::to_string(o.*method.quality) + " " + method.counted +
                                                     " x " + std::to_string(o.depth_scale)
                                               : "";
    return method.words + quality;
}

/// The painted attribute of that name; empty on all placements if there is none.
Painted Frame::painted(const std::string& attribute) const {
    const auto found = job.overrides.painted.find({style::PaintSource::attribute, attribute});
    return found == job.overrides.painted.end() ? Painted(job.scene->placements.size()) : found->second;
}

/// Elision opacity per atlas sample, from this frame alone.
Array<float> Frame::left(float cut) {
    const style::Elision& e = job.style.elision;
    const auto along = [&](const std::string& attribute) {
        return attribute.empty() ? Array<float>() : values_on_paths(*paths, *job.scene, painted(attribute));
    };
    const Array<float> priority_paint = along(e.priority_attribute), density_paint = along(e.density_attribute);
    const Array<float> priorities =
        path_priorities(*paths, *job.scene, job.view, e, job.overrides.importance, priority_paint);
    const Array<Index> ranks = rank_runs(*clipped, *runs, priorities, paths->id);

    Array<float> painted_density, mapped;
    if (!density_paint.empty()) painted_density = values_of_samples(*clipped, density_paint);
    if (job.overrides.density_map) mapped = map_of_samples(*clipped, job.view, *job.overrides.density_map);
    const Density density{focus, distance, painted_density, mapped};
    const Array<float> half_width = half_width_px(job.style, *paths, *clipped, *runs, density, scale());

    OwnBands own = own_bands(*clipped, *runs, ranks, half_width, float(hands_over * scale()));
    const Groups figures = group_runs(*clipped, *runs, paths->placement, true);
    mark_figures(figures, *runs, ranks, float(largest_figure * scale()), own);
    mark_dots(figures, pen_width_of_runs(job.style, *paths, *clipped, *runs, scale()), own);
    Bands bands = draw_bands(*clipped, *runs, ranks, own);
    const Elision elision{std::move(own), std::move(bands)};
    const Array<vec2> crowding = job.backend->elide(*this, elision);
    const ElisionOptions options{float(e.fade_from), cut, stub * scale()};
    return elision_opacities(*clipped, elision, elision_scores(elision, crowding), options);
}

Array<float> Frame::focus_along_lines() {
    const style::Style& style = job.style;
    if (!style.has_away()) return {};
    if (style.effects.lines == style::Mode::uniform)
        return Array<float>(clipped->samples, float(style.effects.uniform));
    if (!style.focus.active()) return {};
    if (!style.focus.is_painted()) return focus_of_samples(*clipped, focus_function());
    const Array<float> values = values_on_paths(*paths, *job.scene, painted(style.focus.attribute));
    return inverted(values_of_samples(*clipped, values));
}

Array<float> Frame::distance_along_lines() const {
    const style::Distance& d = job.style.distance;
    const double strongest = std::max({d.width.strength, d.opacity.strength, d.density.strength});
    if (strongest == 0.0 || !job.style.has_away()) return {};
    return distance_of_samples(*clipped, float(d.near), float(d.far));
}

}  // namespace fovea::draw
