// SPDX-License-Identifier: GPL-3.0-or-later
// Pens, strokes and their reference picture.
#include <algorithm>
#include <map>
#include <pybind11/stl.h>

#include <fovea/stroke/compose.h>
#include <fovea/stroke/ink.h>
#include <fovea/stroke/pen_range.h>
#include <fovea/stroke/raster.h>
#include <fovea/stroke/tessellate.h>
#include <fovea/stroke/texture_file.h>

#include "bindings/arrays.h"
#include "bindings/bind.h"

namespace fovea::bindings {
namespace {

using Image = py::array_t<float, py::array::c_style | py::array::forcecast>;

Pen make_pen(const std::array<float, 3>& color, float opacity, float width_px, float texture_length_px,
             const std::string& cap, float taper_px, std::optional<Index> texture, float strength_width,
             std::optional<Index> away, float wobble_px, float wobble_length_px, Index seed, float pressure,
             const std::string& texture_anchor) {
    check(cap == "round" || cap == "butt", "pen: cap must be 'round' or 'butt', not '" + cap + "'");
    check(texture_anchor == "screen" || texture_anchor == "path",
          "pen: texture_anchor must be 'screen' or 'path', not '" + texture_anchor + "'");
    check(width_px > 0.0f, "pen: the width must be positive");
    check(texture_length_px > 0.0f, "pen: the length of the texture must be positive");
    check(strength_width >= 0.0f && strength_width <= 1.0f, "pen: strength_width must be between 0 and 1");
    Pen pen;
    pen.color = {color[0], color[1], color[2]};
    pen.opacity = opacity;
    pen.width_px = width_px;
    pen.texture_length_px = texture_length_px;
    pen.cap = cap == "butt" ? Cap::butt : Cap::round;
    pen.taper_px = taper_px;
    pen.texture = texture.value_or(none);
    pen.strength_width = strength_width;
    pen.away = away.value_or(none);
    check(wobble_px >= 0.0f && wobble_length_px > 0.0f, "pen: wobble must not be negative, its length positive");
    check(pressure >= 0.0f && pressure <= 1.0f, "pen: pressure must be between 0 and 1");
    pen.wobble_px = wobble_px;
    pen.wobble_length_px = wobble_length_px;
    pen.seed = seed;
    pen.pressure = pressure;
    pen.anchor = texture_anchor == "path" ? Anchor::path : Anchor::screen;
    return pen;
}

PenTexture make_pen_texture(const Image& ink) {
    check(ink.ndim() == 2 && ink.size() > 0, "pen texture: expected ink of shape (rows, columns)");
    return {int(ink.shape(1)), int(ink.shape(0)), Array<float>(ink.data(), ink.data() + ink.size())};
}

py::array ink_of(PenTexture&& texture) {
    return to_numpy(std::move(texture.ink)).reshape({texture.height, texture.width});
}

Strokes make_strokes(const Arg<vec2>& px, const Arg<vec4>& arc, const Arg<float>& half_width, const Arg<float>& opacity,
                     const Arg<Index>& pen, const Arg<glm::uvec3>& triangles, Index count,
                     const std::optional<Arg<vec2>>& mix, const std::optional<Arg<float>>& path_px) {
    const In<vec2> mixes = borrow<vec2>(mix, "mix");
    const In<float> lengths = borrow<float>(path_px, "path_px");
    return {copy<vec2>(px, "px"),
            copy<vec4>(arc, "arc"),
            copy<float>(half_width, "half_width"),
            copy<float>(opacity, "opacity"),
            mix ? Array<vec2>(mixes.begin(), mixes.end()) : Array<vec2>(std::size_t(px.shape(0)), vec2(0.0f)),
            path_px ? Array<float>(lengths.begin(), lengths.end()) : Array<float>(std::size_t(px.shape(0)), 0.0f),
            copy<Index>(pen, "pen"),
            {},
            copy<glm::uvec3>(triangles, "triangles"),
            count};
}

py::array draw(const Strokes& strokes, const std::vector<Pen>& pens, const std::vector<PenTexture>& textures, int width,
               int height) {
    Array<vec4> image;
    {
        py::gil_scoped_release release;
        raster(strokes, pens, textures, width, height, image);
    }
    return to_numpy(std::move(image)).reshape({height, width, 4});
}

py::array compose_image(const Image& lines, const std::array<float, 3>& paper, bool film_transparent,
                        const std::optional<Image>& holdout) {
    check(lines.ndim() == 3 && lines.shape(2) == 4, "lines: expected shape (height, width, 4)");
    const auto count = std::size_t(lines.shape(0) * lines.shape(1));
    const In<vec4> pixels(reinterpret_cast<const vec4*>(lines.data()), count);
    const In<float> mask = holdout ? In<float>(holdout->data(), std::size_t(holdout->size())) : In<float>{};
    Array<vec4> out;
    {
        py::gil_scoped_release release;
        compose(pixels, {paper[0], paper[1], paper[2]}, film_transparent, mask, out);
    }
    return to_numpy(std::move(out)).reshape({lines.shape(0), lines.shape(1), py::ssize_t(4)});
}

/// The transfer functions of an Emphasis by their names.
Emphasis with_transfers(const std::map<std::string, Transfer>& transfers) {
    Emphasis emphasis;
    const std::pair<const char*, Transfer*> known[] = {{"color", &emphasis.color},
                                                       {"texture", &emphasis.texture},
                                                       {"width", &emphasis.width},
                                                       {"opacity", &emphasis.opacity},
                                                       {"distance_width", &emphasis.distance_width},
                                                       {"distance_opacity", &emphasis.distance_opacity}};
    for (const auto& [name, transfer] : transfers) {
        const auto place = std::ranges::find(known, name, [](const auto& entry) { return std::string(entry.first); });
        check(place != std::end(known), "transfers: there is no '" + name + "'");
        *place->second = transfer;
    }
    return emphasis;
}

void bind_pens(py::module_& m) {
    const Pen pen;
    py::class_<Pen>(m, "Pen", "How a stroke looks; lengths in pixels of the image.")
        .def(py::init(&make_pen), py::kw_only(), py::arg("color") = std::array<float, 3>{0.0f, 0.0f, 0.0f},
             py::arg("opacity") = pen.opacity, py::arg("width_px") = pen.width_px,
             py::arg("texture_length_px") = pen.texture_length_px, py::arg("cap") = "round",
             py::arg("taper_px") = pen.taper_px, py::arg("texture") = py::none(),
             py::arg("strength_width") = pen.strength_width, py::arg("away") = py::none(),
             py::arg("wobble_px") = pen.wobble_px, py::arg("wobble_length_px") = pen.wobble_length_px,
             py::arg("seed") = pen.seed, py::arg("pressure") = pen.pressure, py::arg("texture_anchor") = "screen",
             R"(color scene-linear; texture: index into the frame's textures, None: solid; away: index of the pen that
this one becomes out of focus.)");
    py::class_<PenTexture>(m, "PenTexture", "Ink of a pen, repeated along the stroke.")
        .def(py::init(&make_pen_texture), py::arg("ink"),
             "(rows, columns) float32 in [0, 1]; first row: left side of the way.");
    m.def("read_texture", &read_texture, py::arg("path"), "A PenTexture from a PNG; white is full ink.");
    m.def(
        "fit_texture",
        [](const PenTexture& texture, float length_px, float width_px) {
            return ink_of(fit_texture(texture, length_px, width_px));
        },
        py::arg("texture"), py::arg("length_px"), py::arg("width_px"),
        "(rows, columns) float32 ink, area-filtered to at most one texel per pixel: what a pen of "
        "this width draws.");
}

void bind_strokes(py::module_& m) {
    py::class_<Strokes, std::shared_ptr<Strokes>> strokes(
        m, "Strokes", "Visible runs shaped into V vertices and T triangles; see native/fovea/stroke/strokes.h.");
    strokes
        .def(py::init(&make_strokes), py::arg("px"), py::arg("arc"), py::arg("half_width"), py::arg("opacity"),
             py::arg("pen"), py::arg("triangles"), py::arg("count") = 0, py::arg("mix") = py::none(),
             py::arg("path_px") = py::none())
        .def_property_readonly(
            "triangles", [](py::object self) { return view_numpy(self.cast<const Strokes&>().triangles, self); },
            "(T, 3) uint32, in drawing order")
        .def_readonly("count", &Strokes::count, "strokes")
        .def("__len__", [](const Strokes& s) { return s.count; });
    bind_columns(strokes, Strokes::vertex_columns);
}

}  // namespace

void bind_stroke(py::module_& m) {
    bind_pens(m);
    bind_strokes(m);
    m.def(
        "pens_of_runs",
        [](const ClippedPaths& clipped, const Runs& runs, const Arg<std::uint8_t>& line_set,
           const Arg<glm::uvec4>& ranges) {
            const In<glm::uvec4> rows = borrow<glm::uvec4>(ranges, "ranges");
            std::vector<PenRange> by_set;
            for (const glm::uvec4& row : rows) by_set.push_back({row[0], row[1], row[2], row[3]});
            return to_numpy(pens_of_runs(clipped, runs, borrow<std::uint8_t>(line_set, "line_set"), by_set));
        },
        py::arg("clipped"), py::arg("runs"), py::arg("line_set"), py::arg("ranges"),
        R"((R,) uint32 pen of each run, 0xffffffff: none. line_set (P,) uint8 per path of Paths; ranges (n, 4) uint32: line
set, least and most surfaces that hide the run, pen; the first that holds it.)");
    m.def(
        "tessellate",
        [](const ClippedPaths& clipped, const Runs& runs, const Arg<Index>& pen_of_run,
           const std::optional<Arg<float>>& strength, const std::vector<Pen>& pens,
           const std::optional<Arg<float>>& visibility, const std::optional<Arg<float>>& focus,
           const std::optional<Arg<float>>& distance, const std::optional<Arg<float>>& shown,
           const std::map<std::string, Transfer>& transfers, const std::optional<Arg<std::uint64_t>>& ids) {
            const auto pen = borrow<Index>(pen_of_run, "pen_of_run");
            const auto per_point = borrow<float>(strength, "strength");
            const auto per_sample = borrow<float>(visibility, "visibility");
            Emphasis emphasis = with_transfers(transfers);
            emphasis.focus = borrow<float>(focus, "focus");
            emphasis.distance = borrow<float>(distance, "distance");
            emphasis.shown = borrow<float>(shown, "shown");
            const auto per_path = borrow<std::uint64_t>(ids, "ids");
            py::gil_scoped_release release;
            return std::make_shared<Strokes>(
                tessellate(clipped, runs, pen, per_point, pens, per_sample, emphasis, per_path));
        },
        py::arg("clipped"), py::arg("runs"), py::arg("pen_of_run"), py::arg("strength"), py::arg("pens"),
        py::arg("visibility") = py::none(), py::arg("focus") = py::none(), py::arg("distance") = py::none(),
        py::arg("shown") = py::none(), py::arg("transfers") = py::dict(), py::arg("ids") = py::none(),
        R"(Strokes of runs, hidden ones below visible ones. pen_of_run (R,) uint32, 0xffffffff: not drawn; strength (N,)
float32 per point of Paths, or None; visibility (samples,) float32: runs fade where samples at their ends are seen in
part; None: their ends are sharp. focus, distance, shown (samples,) float32: see native/fovea/stroke/emphasis.h; transfers: {its
name there: Transfer}; ids (P,) uint64 per path of Paths: what wobble is made from.)");
    m.def("raster", &draw, py::arg("strokes"), py::arg("pens"), py::arg("textures"), py::arg("width"),
          py::arg("height"), "(height, width, 4) float32, premultiplied, bottom row first.");
    m.def("compose", &compose_image, py::arg("lines"), py::arg("paper"), py::arg("film_transparent") = false,
          py::arg("holdout") = py::none(),
          "lines (H, W, 4) over the paper's colour; holdout (H, W): share of each pixel that is "
          "cut out of the paper.");
}

}  // namespace fovea::bindings
