// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/vector/compose.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include <fovea/base/check.h>
#include <fovea/color/png.h>
#include <fovea/color/srgb.h>
#include <fovea/line/registry.h>
#include <fovea/vector/fit.h>
#include <fovea/vector/marks.h>
#include <fovea/vector/outline.h>
#include <fovea/vector/text.h>

namespace fovea::vector {
namespace {

constexpr double outline_share = 0.5;  // of the tolerance: a stroke has two sides
constexpr double mitre_limit = -0.17;  // cosine of the sharpest mitred bend: 100 degrees (stroke/strip.h)

dvec3 displayed(const dvec3& linear) {
    dvec3 color(0.0);
    for (int c = 0; c < 3; ++c) color[c] = color::to_srgb(std::clamp(float(linear[c]), 0.0f, 1.0f));
    return color;
}

bool is_sharp(const Points& points) {
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
        const dvec2 a = points[i] - points[i - 1], b = points[i + 1] - points[i];
        if (glm::dot(a, b) < mitre_limit * glm::length(a) * glm::length(b)) return true;
    }
    return false;
}

/// Makes paths of marks.
class Tracing {
   public:
    Tracing(const Frame& frame, const Options& options, const Page& page, const std::vector<Grain>& grains)
        : frame_(frame), inking_(frame.inking(frame.shown)), options_(options), grains_(grains),
          tolerance_(options.tolerance / page.unit_mm), scale_(page.scale) {}

    /// The mark as a path, without its id.
    Path path_of(const Mark& mark) const {
        const Index number = inking_.pen_of_run[mark.run];
        const Pen& pen = inking_.pens[number];
        const Grain& grain = grains_[number];
        Path path = owner_of(mark);
        const bool round = pen.look.cap == Cap::round;
        path.look = {.color = mark.color, .opacity = mark.opacity, .width = mean_width(mark), .round_caps = round,
                     .round_joins = is_sharp(mark.points)};
        const bool as_line = options_.widths == Widths::center || !grain.dashes.empty() ||
                             (is_even(mark) && (!round || mark.closed || (mark.starts && mark.ends)));
        if (as_line) {
            path.curves = {fit(mark.points, mark.closed, tolerance_)};
            add_dashes(mark, pen, grain, path.look);
            path.look.round_caps = path.look.dashes.empty() ? round && mark.starts && mark.ends : grain.round;
            if (options_.widths == Widths::center && path.look.dashes.empty()) path.look.round_caps = round;
        } else {
            path.look.width = 0.0;
            path.curves = outline(mark.points, mark.widths, mark.closed, {round && mark.starts, round && mark.ends},
                                  outline_share * tolerance_);
        }
        std::erase_if(path.curves, [](const Curve& curve) { return curve.empty(); });
        return path;
    }

   private:
    /// Whether the width is next to the same all along.
    bool is_even(const Mark& mark) const {
        const auto [low, high] = std::ranges::minmax(mark.widths);
        return high - low <= outline_share * tolerance_;
    }

    /// What the line of a mark is.
    Path owner_of(const Mark& mark) const {
        const Index piece = inking_.runs.piece[mark.run], p = inking_.clipped.path[piece];
        const Paths& paths = *frame_.paths;
        Path path;
        path.invisibility = inking_.runs.invisibility[mark.run];
        const Index point = inking_.clipped.source[inking_.clipped.segment_at(piece, inking_.runs.start_px[mark.run])];
        const Kinds kinds = paths.kinds[point];
        const auto& definitions = line_definitions();
        for (std::size_t bit = 0; bit < definitions.size() && path.kind.empty(); ++bit)
            if (kinds >> bit & 1u) path.kind = definitions[bit]->name;
        const Overrides& overrides = frame_.job.overrides;
        const Index placement = paths.placement[p];
        if (placement < overrides.objects_of_placement.size()) {
            const auto& names = overrides.objects[overrides.objects_of_placement[placement]];
            if (!names.empty()) path.object = names.front();
        }
        return path;
    }

    void add_dashes(const Mark& mark, const Pen& pen, const Grain& grain, Look& look) const {
        if (grain.dashes.empty()) return;
        const double repetition = scale_ * pen.texture_length_px, cut = grain.round ? look.width : 0.0;
        for (std::size_t k = 0; k < grain.dashes.size(); ++k) {
            const double length = repetition * grain.dashes[k] + (k % 2 ? cut : -cut);
            look.dashes.push_back(std::max(length, 0.0));
        }
        const double into = mark.arc - repetition * grain.first - 0.5 * cut;
        look.dash_start = into - repetition * std::floor(into / repetition);
    }

    const Frame& frame_;
    const Inking inking_;
    const Options& options_;
    const std::vector<Grain>& grains_;
    double tolerance_, scale_;
};

/// Layers of the line sets, empty; what is not drawn is taken out later.
std::vector<Layer> layers_of(const style::Style& style) {
    std::vector<Layer> layers;
    for (const style::LineSet& set : style.line_sets) {
        const std::string number = std::to_string(layers.size() + 1), id = "lines" + number;
        layers.push_back({id, number + " " + set.name, set.name, {}, {}});
        layers.back().layers = {{id + "-hidden", "hidden", {}, {}, {}}, {id + "-visible", "visible", {}, {}, {}}};
    }
    return layers;
}

void take_out_empty(std::vector<Layer>& layers) {
    for (Layer& layer : layers) take_out_empty(layer.layers);
    std::erase_if(layers, [](const Layer& layer) { return layer.paths.empty() && layer.layers.empty(); });
}

/// The colors and the paper below the lines, if they are more than one color.
std::optional<Image> image_of(Frame& frame, const Page& page) {
    const style::Style& style = frame.job.style;
    const bool colored = frame.job.colors && style.has_color();
    if (!colored && (style.paper.transparent || style.paper.texture == "none" || style.paper.tint == 0.0)) return {};
    frame.picture();
    const View& view = frame.job.view;
    const Array<vec4> pixels = frame.ground();
    Array<std::uint8_t> rgb(3 * pixels.size());
    parallel_for(pixels.size(), [&](std::size_t i) {
        for (int c = 0; c < 3; ++c) rgb[3 * i + c] = color::srgb_byte(pixels[i][c] + 1.0f - pixels[i].a);
    });
    const dvec2 size(view.width, view.height);
    return Image{png_bytes(rgb, view.width, view.height), page.lower, page.scale * size};
}

void check_options(const Options& options) {
    style::for_each_field<Options>([&]<typename V>(const style::Field<Options, V>& field) {
        if constexpr (std::is_same_v<V, double>) {
            const double value = options.*field.member;
            check(value >= field.domain.least && value <= field.domain.most,
                  std::string("vectors: ") + field.name + " is " + number(value) + ", outside " +
                      number(field.domain.least) + " to " + number(field.domain.most) + " mm");
        }
    });
}

}  // namespace

Drawing compose(Frame& frame, const Options& options) {
    check_options(options);
    frame.ink();
    const Page page = page_of(frame.job.view, frame.job.style.paper, options);
    Drawing made;
    Document& document = made.document;
    document.size = page.size;
    document.in_pixels = options.sheet == Sheet::pixels;
    if (options.ground) {
        if (!frame.job.style.paper.transparent) document.paper = displayed(frame.job.style.paper.color);
        document.image = image_of(frame, page);
    }
    const Marks found =
        marks_of(frame, page, options.tolerance / page.unit_mm, options.widths == Widths::center);
    const Tracing tracing(frame, options, page, found.grains);
    std::vector<Path> paths(found.marks.size());
    parallel_for(paths.size(), 16, [&](std::size_t i) { paths[i] = tracing.path_of(found.marks[i]); });
    document.layers = layers_of(frame.job.style);
    std::map<std::uint64_t, int> parts;  // of a path so far
    std::set<Index> strokes;
    for (std::size_t i = 0; i < paths.size(); ++i) {
        if (paths[i].curves.empty()) continue;
        const Index run = found.marks[i].run, path = frame.clipped->path[frame.drawn->piece[run]];
        const std::uint64_t id = frame.paths->id[path];
        paths[i].id = "p" + hexadecimal(id) + "-" + std::to_string(++parts[id]);
        strokes.insert(run);
        for (const Curve& curve : paths[i].curves) made.figures.numbers += 2 * curve.points.size();
        const bool visible = paths[i].invisibility == 0;
        document.layers[frame.paths->line_set[path]].layers[visible].paths.push_back(std::move(paths[i]));
        ++made.figures.paths;
    }
    take_out_empty(document.layers);
    made.figures.strokes = strokes.size();
    made.figures.polyline_numbers = found.numbers;
    return made;
}

}  // namespace fovea::vector
