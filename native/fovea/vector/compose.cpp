// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/vector/compose.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <set>

#include <fovea/base/cancel.h>
#include <fovea/base/parallel.h>
#include <fovea/color/displayed.h>
#include <fovea/color/srgb.h>
#include <fovea/style/ranges.h>
#include <fovea/vector/areas.h>
#include <fovea/vector/fit.h>
#include <fovea/vector/plot.h>
#include <fovea/vector/section.h>
#include <fovea/vector/text.h>
#include <fovea/vector/title_block.h>
#include <fovea/vector/tracing.h>

namespace fovea::vector {
namespace {

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

/// The paper below the lines, and their colors if asked for, if that is more than one color.
std::optional<Image> image_of(Frame& frame, const Page& page, bool colored) {
    const style::Style& style = frame.job.style;
    if (!colored && (style.paper.transparent || style.paper.texture == "none" || style.paper.tint == 0.0)) return {};
    frame.picture();
    const View& view = frame.job.view;
    const bool with_alpha = style.paper.transparent;
    return Image{color::displayed_bytes(colored ? frame.ground() : frame.bare_paper(), with_alpha),
                 view.width,
                 view.height,
                 with_alpha ? 4 : 3,
                 page.lower,
                 page.scale * dvec2(view.width, view.height)};
}

/// Names of paths: the id of the line, and the number of the part of it.
class Names {
   public:
    explicit Names(const Frame& frame) : frame_(frame) {}

    std::string next(Index run) {
        const std::uint64_t id = frame_.paths->id[frame_.clipped->path[frame_.drawn->piece[run]]];
        return "p" + hexadecimal(id) + "-" + std::to_string(++parts_[id]);
    }

   private:
    const Frame& frame_;
    std::map<std::uint64_t, int> parts_;  // of a line so far
};

/// The line set of a drawn run.
Index line_set_of(const Frame& frame, Index run) {
    return frame.paths->line_set[frame.clipped->path[frame.drawn->piece[run]]];
}

/// Each dash as a mark: `all`, or those alone that are fixed to paths, as they are not all alike.
std::vector<Mark> dashes_apart(std::vector<Mark>& marks, const Tracing& tracing, bool all) {
    const auto fill = [&](std::vector<Mark>& dashes, std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            if (!all && marks[i].anchors.empty())
                dashes.push_back(std::move(marks[i]));
            else
                for (Mark& dash : tracing.dashes_of(marks[i])) dashes.push_back(std::move(dash));
        }
    };
    std::vector<Mark> dashes;
    for (std::vector<Mark>& part : parallel_parts<std::vector<Mark>>(marks.size(), 16, fill))
        std::ranges::move(part, std::back_inserter(dashes));
    return dashes;
}

/// Layers of the line sets with the paths of all marks.
std::vector<Layer> drawn_layers(const Frame& frame, const std::vector<Mark>& marks, const Tracing& tracing) {
    std::vector<Path> paths(marks.size());
    parallel_for(paths.size(), 16, [&](std::size_t i) { paths[i] = tracing.path_of(marks[i]); });
    std::vector<Layer> layers = layers_of(frame.job.style);
    Names names(frame);
    for (std::size_t i = 0; i < paths.size(); ++i) {
        if (paths[i].curves.empty()) continue;
        paths[i].id = names.next(marks[i].run);
        const bool visible = paths[i].invisibility == 0;
        layers[line_set_of(frame, marks[i].run)].layers[visible].paths.push_back(std::move(paths[i]));
    }
    return layers;
}

/// Black, or white on dark paper; as displayed.
dvec3 ink_on(const std::optional<dvec3>& paper) {
    return dvec3(paper && glm::dot(*paper, dvec3(0.2126, 0.7152, 0.0722)) < 0.5 ? 1.0 : 0.0);
}

/// A number before each label, by which plotters know pens.
void number_labels(std::vector<Layer>& layers) {
    for (std::size_t i = 0; i < layers.size(); ++i) layers[i].label = std::to_string(i + 1) + " " + layers[i].label;
}

/// The same with a layer for each pen, and what a plotter draws of the marks: lines of one width each.
std::vector<Layer> plotted_layers(const Frame& frame, const std::vector<Mark>& marks, const Tracing& tracing,
                                  double unit_mm) {
    std::vector<Layer> layers;
    Names names(frame);
    for (const Layer& of_set : layers_of(frame.job.style))
        for (const Layer& part : of_set.layers) {
            const bool hidden = &part == &of_set.layers.front();
            const Index set = Index(layers.size() / 2);
            std::vector<Line> lines;
            double width = 0.0;
            for (std::size_t i = 0; i < marks.size(); ++i) {
                if (line_set_of(frame, marks[i].run) != set || hidden != (frame.drawn->invisibility[marks[i].run] != 0))
                    continue;
                lines.push_back({marks[i].points, marks[i].closed, i, marks[i].is_dash ? marks[i].run : none});
                width = std::max(width, mean_width(marks[i]));
            }
            layers.push_back({part.id, of_set.line_set + (hidden ? " hidden" : ""), of_set.line_set, {}, {}});
            for (const Line& line : as_plotted(std::move(lines), unit_mm)) {
                Path path = tracing.owner_of(marks[line.origin]);
                path.look = {.color = marks[line.origin].color, .width = width};
                path.curves = {fit(line.points, line.closed, tracing.tolerance())};
                if (path.curves[0].empty()) continue;
                path.id = names.next(marks[line.origin].run);
                layers.back().paths.push_back(std::move(path));
            }
        }
    return layers;
}

}  // namespace

Drawing compose(Frame& frame, const Options& asked) {
    style::check_ranges(asked, "vectors: ");
    const Cancelling scope(frame.job.cancel.get());
    Options options = asked;
    if (options.tolerance < Options::least_tolerance) options.tolerance = 0.0;
    frame.shape();
    const Page page = page_of(frame.job.view, frame.job.style.paper, options);
    Drawing made;
    Document& document = made.document;
    document.size = page.size;
    document.in_pixels = options.sheet == Sheet::pixels;
    const bool with_ground = options.ground && !options.plotter;
    const bool colored = with_ground && frame.job.colors && frame.job.style.has_color();
    const bool as_areas = colored && options.colors == Colors::areas;
    if (with_ground) {
        if (!frame.job.style.paper.transparent) document.paper = color::displayed(frame.job.style.paper.color);
        document.image = image_of(frame, page, colored && !as_areas);
    }
    const Cutting cutting = options.plotter                    ? Cutting::elision
                            : options.widths == Widths::center ? Cutting::unseen
                                                               : Cutting::by_ink;
    Marks found = marks_of(frame, page, options.tolerance / page.unit_mm, cutting);
    const Tracing tracing(frame, options, page, found.grains);
    std::set<Index> strokes;
    for (const Mark& mark : found.marks) strokes.insert(mark.run);
    found.marks = dashes_apart(found.marks, tracing, options.plotter || options.dashes_apart);
    document.layers = options.plotter ? plotted_layers(frame, found.marks, tracing, page.unit_mm)
                                      : drawn_layers(frame, found.marks, tracing);
    if (!options.plotter) document.layers.insert(document.layers.begin(), section_layer(frame, page));
    if (as_areas) document.layers.insert(document.layers.begin(), colors_layer(frame, page, tracing.tolerance()));
    if (options.title_block) {
        const std::string scale = scale_text(frame.job.view, page, options.unit_meters);
        for (Layer& layer : title_block_layers(page, options, scale, ink_on(document.paper)))
            document.layers.push_back(std::move(layer));
    }
    take_out_empty(document.layers);
    if (options.plotter) number_labels(document.layers);
    made.figures.strokes = strokes.size();
    made.figures.polyline_numbers = found.numbers;
    for_each_path(document.layers, [&](const Path& path) {
        ++made.figures.paths;
        for (const Curve& curve : path.curves) made.figures.numbers += 2 * curve.points.size();
    });
    if (options.plotter) made.way = put_in_order(document, page.unit_mm);
    return made;
}

}  // namespace fovea::vector
