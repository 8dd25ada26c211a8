// SPDX-License-Identifier: GPL-3.0-or-later
// The colour layer, its effects, and paper.
#include <algorithm>
#include <pybind11/stl.h>

#include <fovea/color/effects.h>
#include <fovea/color/layer.h>
#include <fovea/color/map.h>
#include <fovea/color/painted_image.h>
#include <fovea/color/paper.h>
#include <fovea/color/png_bytes.h>
#include <fovea/stroke/texture_file.h>

#include "bindings/arrays.h"
#include "bindings/bind.h"
#include "bindings/painted.h"

namespace fovea::bindings {
namespace {

using Image = py::array_t<float, py::array::c_style | py::array::forcecast>;
using Color = std::array<float, 3>;

vec3 vector(const Color& color) { return {color[0], color[1], color[2]}; }

std::optional<vec3> vector(const std::optional<Color>& color) {
    return color ? std::optional<vec3>(vector(*color)) : std::nullopt;
}

In<vec4> pixels(const Image& image, const char* name) {
    check(image.ndim() == 3 && image.shape(2) == 4, std::string(name) + ": expected shape (height, width, 4)");
    return {reinterpret_cast<const vec4*>(image.data()), std::size_t(image.shape(0) * image.shape(1))};
}

In<float> values(const Image& image, const char* name) {
    check(image.ndim() == 2, std::string(name) + ": expected shape (height, width)");
    return {image.data(), std::size_t(image.size())};
}

py::array as_image(Array<vec4>&& image, py::ssize_t height, py::ssize_t width) {
    return to_numpy(std::move(image)).reshape({height, width, py::ssize_t(4)});
}

std::shared_ptr<ColorTexture> make_texture(const Image& image, bool encoded) {
    check(image.ndim() == 3 && image.shape(0) < (1 << 16) && image.shape(1) < (1 << 16),
          "texture: expected pixels of shape (height, width, channels)");
    const In<float> all(image.data(), std::size_t(image.size()));
    py::gil_scoped_release release;
    return std::make_shared<ColorTexture>(all, int(image.shape(1)), int(image.shape(0)), int(image.shape(2)), encoded);
}

std::shared_ptr<SurfaceColor> make_surface_color(const std::vector<ColorSlot>& slots,
                                                 const std::optional<Arg<vec3>>& normals,
                                                 const std::vector<Arg<vec2>>& uvs,
                                                 const std::vector<Arg<vec3>>& attributes) {
    auto color = std::make_shared<SurfaceColor>();
    color->slots = slots;
    if (normals) color->normals = copy<vec3>(*normals, "normals");
    for (const auto& uv : uvs) color->uvs.push_back(copy<vec2>(uv, "uvs"));
    for (const auto& attribute : attributes) color->attributes.push_back(copy<vec3>(attribute, "attributes"));
    return color;
}

Light make_light(const std::string& kind, const std::array<double, 3>& position, const std::array<double, 3>& direction,
                 const Color& color, float cos_outer, float cos_inner) {
    static constexpr const char* names[] = {"sun", "point", "spot", "area"};
    const auto named = std::find(std::begin(names), std::end(names), kind);
    check(named != std::end(names), "light: there is no kind '" + kind + "'; there are: sun, point, spot, area");
    return {Light::Kind(named - std::begin(names)),
            {position[0], position[1], position[2]},
            {direction[0], direction[1], direction[2]},
            vector(color),
            cos_outer,
            cos_inner};
}

Shading shading_of(const std::string& name) {
    check(name == "flat" || name == "smooth" || name == "toon",
          "there is no shading '" + name + "'; there are: flat, smooth, toon");
    return name == "flat" ? Shading::flat : name == "smooth" ? Shading::smooth : Shading::toon;
}

py::array draw_layer(const Tracer& tracer, const SceneColor& colors, const std::vector<Light>& lights,
                     const Color& world, const std::string& shading, int bands, const Cancel* cancel) {
    check(bands >= 2 && bands <= 64, "toon shading has 2 to 64 bands");
    const LayerOptions options{shading_of(shading), bands};
    const Cancel never;
    Array<vec4> layer;
    {
        py::gil_scoped_release release;
        layer = color_layer(tracer, colors, lights, vector(world), options, cancel ? *cancel : never);
    }
    return as_image(std::move(layer), tracer.view().height, tracer.view().width);
}

/// The effects whose amounts are given, in the order of the arguments, on a copy.
py::array effects(const Image& image, const std::optional<Image>& desaturation, const std::optional<Image>& fading,
                  const std::optional<Color>& background, const std::optional<Image>& blur_px) {
    const In<vec4> before = pixels(image, "image");
    const auto amounts = [](const std::optional<Image>& amount, const char* name) {
        return amount ? std::optional<In<float>>(values(*amount, name)) : std::nullopt;
    };
    const auto grey = amounts(desaturation, "desaturate"), pale = amounts(fading, "fade"),
               soft = amounts(blur_px, "blur_px");
    const auto width = int(image.shape(1));
    Array<vec4> after(before.size());
    {
        py::gil_scoped_release release;
        parallel_blocks(before.size(), 1 << 16, [&](std::size_t, std::size_t begin, std::size_t end) {
            std::copy(before.begin() + begin, before.begin() + end, after.begin() + begin);
        });
        if (grey) desaturate(after, *grey);
        if (pale) fade(after, *pale, vector(background));
        if (soft) blur(after, width, *soft);
    }
    return as_image(std::move(after), image.shape(0), width);
}

void bind_effects(py::module_& m) {
    m.def(
        "color_effects", &effects, py::arg("image"), py::arg("desaturate") = py::none(), py::arg("fade") = py::none(),
        py::arg("background") = py::none(), py::arg("blur_px") = py::none(),
        R"((H, W, 4) moved towards grey by (H, W) amounts, then towards a background (None: towards nothing), then blurred as
by discs of (H, W) radii; where an amount is 0 that effect changes nothing. See native/fovea/color/effects.h.)");
}

void bind_paper(py::module_& m) {
    py::class_<PaperTexture>(m, "PaperTexture", "Heights of a paper, repeated over the picture.")
        .def(py::init([](const Image& heights) {
                 const In<float> all = values(heights, "paper");
                 return PaperTexture(all, int(heights.shape(1)), int(heights.shape(0)));
             }),
             py::arg("heights"), "(rows, columns) float32, bottom row first.");
    m.def(
        "on_paper",
        [](const Image& lines, const std::optional<Image>& layer, const std::optional<Image>& holdout, const View& view,
           const PaperTexture* texture, const Color& color, bool transparent, const std::optional<Color>& background,
           float layer_opacity, float texel_px, float tooth, float granulation, float tint) {
            const PaperOptions options{vector(color), transparent, vector(background), layer_opacity,
                                       texel_px,      tooth,       granulation,        tint};
            const In<vec4> strokes = pixels(lines, "lines");
            const In<vec4> colors = layer ? pixels(*layer, "layer") : In<vec4>{};
            const In<float> cut = holdout ? values(*holdout, "holdout") : In<float>{};
            Array<vec4> out;
            {
                py::gil_scoped_release release;
                on_paper(strokes, colors, cut, view, texture, options, out);
            }
            return as_image(std::move(out), view.height, view.width);
        },
        py::arg("lines"), py::arg("layer"), py::arg("holdout"), py::arg("view"), py::arg("texture"), py::arg("color"),
        py::arg("transparent") = false, py::arg("background") = py::none(), py::arg("layer_opacity") = 1.0f,
        py::arg("texel_px") = 1.0f, py::arg("tooth") = 0.0f, py::arg("granulation") = 0.0f, py::arg("tint") = 0.0f,
        "Lines over the colour layer over paper; layer, holdout and texture may be None; see "
        "native/fovea/color/paper.h.");
    m.def(
        "read_paper",
        [](const std::string& path) {
            const PenTexture file = read_texture(path);
            return PaperTexture(file.ink, file.width, file.height);
        },
        py::arg("path"), "A PaperTexture from a PNG; white is high.");
    m.def(
        "png_bytes",
        [](const py::array_t<std::uint8_t, py::array::c_style>& rgb) {
            check(rgb.ndim() == 3 && rgb.shape(2) == 3, "rgb: expected shape (height, width, 3)");
            return py::bytes(png_bytes({rgb.data(), std::size_t(rgb.size())}, int(rgb.shape(1)), int(rgb.shape(0))));
        },
        py::arg("rgb"), "The bytes of a PNG file of (height, width, 3) uint8 sRGB, bottom row first.");
    m.def("toothed", &toothed, py::arg("opacity"), py::arg("lower"), py::arg("tooth"),
          "Share of a place that ink covers where so much of the paper is lower.");
}

}  // namespace

void bind_color(py::module_& m) {
    py::class_<ColorTexture, std::shared_ptr<ColorTexture>>(m, "ColorTexture", "An image of base colours.")
        .def(py::init(&make_texture), py::arg("pixels"), py::arg("encoded"),
             "(height, width, 1 to 4 channels) float32, bottom row first; encoded: as sRGB, else scene-linear.")
        .def(
            "at",
            [](const ColorTexture& texture, float u, float v, float footprint) {
                const vec3 color = texture.at({u, v}, footprint);
                return std::array{color.x, color.y, color.z};
            },
            py::arg("u"), py::arg("v"), py::arg("footprint") = 0.0f,
            "Scene-linear colour at a place of the unit square.");
    py::class_<ColorSlot>(m, "ColorSlot", "What a material says about colour.")
        .def(py::init([](const Color& color, std::shared_ptr<ColorTexture> texture, std::optional<Index> uv,
                         std::optional<Index> attribute, bool unlit) {
                 return ColorSlot{vector(color), std::move(texture), uv.value_or(none), attribute.value_or(none),
                                  unlit};
             }),
             py::arg("color"), py::arg("texture") = py::none(), py::arg("uv") = py::none(),
             py::arg("attribute") = py::none(), py::arg("unlit") = false);
    py::class_<SurfaceColor, std::shared_ptr<SurfaceColor>>(m, "SurfaceColor",
                                                            "Colours of a surface; see native/fovea/color/source.h.")
        .def(py::init(&make_surface_color), py::arg("slots"), py::arg("normals") = py::none(),
             py::arg("uvs") = std::vector<Arg<vec2>>(), py::arg("attributes") = std::vector<Arg<vec3>>(),
             "normals (C, 3), each of uvs (C, 2), each of attributes (C, 3): float32 per corner of the mesh.");
    py::class_<Light>(m, "Light", "A light; see native/fovea/color/light.h.")
        .def(py::init(&make_light), py::arg("kind"), py::arg("position"), py::arg("direction"), py::arg("color"),
             py::arg("cos_outer") = -1.0f, py::arg("cos_inner") = -1.0f);
    m.def(
        "color_layer",
        [](const Tracer& tracer, const std::vector<std::shared_ptr<SurfaceColor>>& colors,
           const std::vector<Light>& lights, const Color& world, const std::string& shading, int bands,
           const Cancel* cancel) {
            return draw_layer(tracer, SceneColor(colors.begin(), colors.end()), lights, world, shading, bands, cancel);
        },
        py::arg("tracer"), py::arg("colors"), py::arg("lights"), py::arg("world"), py::arg("shading"),
        py::arg("bands") = 3, py::arg("cancel") = py::none(),
        R"((H, W, 4) float32 premultiplied: what each pixel sees. colors: a SurfaceColor or None per placement; shading:
flat, smooth or toon.)");
    m.def(
        "painted_image",
        [](const Tracer& tracer, const PaintedArrays& painted, const Cancel* cancel) {
            const Painted in = borrow_painted(painted);
            const Cancel never;
            Array<float> values;
            {
                py::gil_scoped_release release;
                values = painted_image(tracer, in, cancel ? *cancel : never);
            }
            return to_numpy(std::move(values)).reshape({tracer.view().height, tracer.view().width});
        },
        py::arg("tracer"), py::arg("painted"), py::arg("cancel") = py::none(),
        "(H, W) float32 in [0, 1]: what is painted where each pixel looks, 0 where nothing is; as for "
        "values_on_paths.");
    m.def(
        "map_of_samples",
        [](const ClippedPaths& clipped, const View& view, const ColorTexture& image) {
            Array<float> values;
            {
                py::gil_scoped_release release;
                values = map_of_samples(clipped, view, image);
            }
            return to_numpy(std::move(values));
        },
        py::arg("clipped"), py::arg("view"), py::arg("image"),
        "(samples,) float32 in [0, 1]: luminance of an image laid over the camera's frame.");
    bind_effects(m);
    bind_paper(m);
}

}  // namespace fovea::bindings
