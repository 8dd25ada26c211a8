// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/vector/areas.h>

#include <algorithm>
#include <map>
#include <stdexcept>
#include <tuple>

#include <fovea/color/shader.h>
#include <fovea/color/srgb.h>
#include <fovea/vector/fit.h>

namespace fovea::vector {
namespace {

constexpr double many_pixels = 8e6;                     // of which more points than one each take too much memory
constexpr double shared_weight = 1e-6;                  // weight of pixels that other areas share
constexpr Label bands = 1u << 8, materials = 1u << 24;  // more than there are

/// Labels of what is seen: which placement, material and band of light.
class Seen {
   public:
    Seen(const Frame& frame, const ColorSources& from)
        : tracer_(*frame.tracer),
          lighting_(from.lights, from.world, tracer_.scene(), tracer_.view(), frame.job.style.color),
          shader_(tracer_.scene(), tracer_.view(), from.surfaces, lighting_) {}

    Label at(const dvec2& px) const {
        const auto hit = tracer_.seen(px);
        if (!hit || shader_.holdout(hit->placement)) return nothing;
        const color::SeenTriangle triangle = shader_.triangle(hit->placement, hit->triangle);
        const Surface& surface = *tracer_.scene().placements[hit->placement].surface;
        const int material = surface.material(surface.triangle_facet[hit->triangle]);
        const int band = shader_.band(triangle, px, triangle.screen.at(px));
        return (Label(hit->placement) * materials + Label(std::max(material, 0)) % materials) * bands + Label(band);
    }

    static Index placement(Label label) { return Index(label / bands / materials); }

   private:
    const Tracer& tracer_;
    const color::Lighting lighting_;
    const color::ColorShader shader_;
};

/// Mean colors of labels, premultiplied: of pixels inside them, or of those that they share where there are none.
std::map<Label, dvec4> means(const Labels& labels, In<vec4> pixels, int width, int height) {
    std::map<Label, std::pair<dvec4, double>> sums;
    auto known = sums.end();
    for (int y = 0; y < labels.rows; ++y)
        for (int x = 0; x < labels.columns; ++x) {
            const Label label = labels.at(x, y);
            if (label == nothing) continue;
            if (known == sums.end() || known->first != label) known = sums.try_emplace(label, dvec4(0.0), 0.0).first;
            const int per_px = labels.per_px, u = std::min(x / per_px, width - 1), v = std::min(y / per_px, height - 1);
            bool inside = true;
            for (const int b : {per_px * v, per_px * v + per_px})
                for (const int a : {per_px * u, per_px * u + per_px}) inside = inside && labels.at(a, b) == label;
            const double weight = inside ? 1.0 : shared_weight;
            known->second.first += weight * dvec4(pixels[std::size_t(v) * width + u]);
            known->second.second += weight;
        }
    std::map<Label, dvec4> found;
    for (const auto& [label, sum] : sums) found[label] = sum.first / sum.second;
    return found;
}

/// A border with a label on its left.
struct Directed {
    Label label;
    Index from, to, border;
    bool backward;
    auto key() const { return std::tie(label, from, border, backward); }
};

}  // namespace

std::vector<std::pair<Label, std::vector<Curve>>> outlines_of(const std::vector<Border>& borders, const Page& page,
                                                              double tolerance) {
    std::vector<Curve> curves(borders.size());
    parallel_for(borders.size(), 16, [&](std::size_t i) {
        Points points;
        for (const dvec2& px : borders[i].points) points.push_back(page.place(px));
        curves[i] = fit(points, borders[i].from == none, tolerance);
    });
    std::vector<Directed> parts;
    for (Index i = 0; i < borders.size(); ++i) {
        if (curves[i].empty()) continue;
        const Border& b = borders[i];
        if (b.left != nothing) parts.push_back({b.left, b.from, b.to, i, false});
        if (b.right != nothing) parts.push_back({b.right, b.to, b.from, i, true});
    }
    std::ranges::sort(parts, {}, &Directed::key);
    std::vector<bool> done(parts.size());
    const auto next_of = [&](Label label, Index from) {
        auto next = std::ranges::lower_bound(parts, std::tuple(label, from), {},
                                             [](const Directed& d) { return std::tuple(d.label, d.from); });
        while (next != parts.end() && next->label == label && next->from == from && done[next - parts.begin()]) ++next;
        return next != parts.end() && next->label == label && next->from == from ? next : parts.end();
    };
    std::vector<std::pair<Label, std::vector<Curve>>> found;
    for (auto start = parts.begin(); start != parts.end(); ++start) {
        if (done[start - parts.begin()]) continue;
        Curve loop;
        for (auto part = start; part != parts.end();
             part = loop.end() == loop.start() ? parts.end() : next_of(part->label, part->to)) {
            done[part - parts.begin()] = true;
            loop.append(part->backward ? reversed(curves[part->border]) : curves[part->border]);
        }
        loop.closed = true;
        if (found.empty() || found.back().first != start->label) found.push_back({start->label, {}});
        found.back().second.push_back(std::move(loop));
    }
    return found;
}

Layer colors_layer(Frame& frame, const Page& page, double tolerance) {
    frame.picture();
    const View& view = frame.job.view;
    if (!frame.job.colors) throw std::invalid_argument("areas of color: the frame has no colors");
    const Seen seen(frame, *frame.job.colors);
    const LabelAt at = [&](const dvec2& px) { return seen.at(px); };
    const int per_px = double(view.width) * view.height > many_pixels ? 1 : 2;
    const Labels labels = without_specks(labels_of(view.width, view.height, per_px, at), per_px * per_px);
    const std::map<Label, dvec4> colors = means(labels, frame.ground(), view.width, view.height);
    Layer layer{"colors", "colors", {}, {}, {}};
    std::map<Index, int> parts;  // of placements so far
    for (auto& [label, curves] : outlines_of(borders_of(labels, at), page, tolerance)) {
        const Index placement = Seen::placement(label);
        const dvec4 mean = colors.at(label);
        if (!(mean.w > 0.0)) continue;
        Path path;
        path.id = "area" + std::to_string(placement) + "-" + std::to_string(++parts[placement]);
        path.kind = "area";
        path.object = frame.job.overrides.object_of(placement);
        path.look = {.color = color::displayed(dvec3(mean) / mean.w), .opacity = std::min(mean.w, 1.0)};
        path.curves = std::move(curves);
        layer.paths.push_back(std::move(path));
    }
    return layer;
}

}  // namespace fovea::vector
