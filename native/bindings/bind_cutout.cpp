// SPDX-License-Identifier: GPL-3.0-or-later
// Cut-outs of meshes by opacity images.
#include <fovea/cutout/cutout.h>

#include "bindings/arrays.h"
#include "bindings/bind.h"
#include "bindings/mesh.h"
#include "bindings/records.h"
#include "bindings/words.h"

namespace fovea::bindings {
namespace {

std::shared_ptr<Opacity> make_opacity(const py::array_t<float, py::array::c_style>& texels, float threshold,
                                      const py::str& extension, bool closest) {
    check(texels.ndim() == 2 && texels.shape(0) < (1 << 16) && texels.shape(1) < (1 << 16),
          "opacity: expected texels of shape (height, width)");
    auto opacity = std::make_shared<Opacity>();
    opacity->texels.assign(texels.data(), texels.data() + texels.size());
    opacity->width = int(texels.shape(1));
    opacity->height = int(texels.shape(0));
    opacity->threshold = threshold;
    opacity->extension = value_from<Extension>(extension, "opacity: extension");
    opacity->closest = closest;
    return opacity;
}

std::shared_ptr<CutSurface> make_cut(const std::string& name, const Mesh& mesh, const std::vector<Cut>& cuts,
                                     const Arg<int>& cut_of_polygon, double px_per_unit) {
    const CutOptions options{borrow<int>(cut_of_polygon, "cut_of_polygon"), px_per_unit};
    return without_gil([&] { return std::make_shared<CutSurface>(name, mesh.arrays, cuts, options); });
}

Numpy<float> mix_cut_corners(const CutSurface& surface, const Arg<float>& values) {
    check(values.ndim() == 2, surface.name() + ": values of shape (C, columns) expected");
    const In<float> all(values.data(), std::size_t(values.size()));
    const auto columns = values.shape(1);
    Array<float> mixed = without_gil([&] { return surface.mix_corners(all, int(columns)); });
    const auto corners = py::ssize_t(mixed.size()) / columns;
    return to_numpy(std::move(mixed)).reshape({corners, columns});
}

}  // namespace

void bind_cutout(py::module_& m) {
    py::class_<Opacity, std::shared_ptr<Opacity>>(m, "Opacity", "Opacity of a material over its texture coordinates.")
        .def(
            py::init(&make_opacity), py::arg("texels"), py::arg("threshold") = 0.5f, py::arg("extension") = "repeat",
            py::arg("closest") = false,
            R"((height, width) float32, bottom row first; opaque above the threshold; extension: repeat, extend, clip or
mirror; closest: texels are squares, else opacity is interpolated between their centers.)");
    py::class_<Cut>(m, "Cut", "Opacity over a mesh.")
        .def(py::init([](const Arg<vec2>& uvs, std::shared_ptr<Opacity> opacity) {
                 return Cut{copy<vec2>(uvs, "uvs"), std::move(opacity)};
             }),
             py::arg("uvs"), py::arg("opacity"), "uvs (C, 2) float32 per corner, in the image's texture space.");
    py::class_<CutSurface, Surface, std::shared_ptr<CutSurface>>(
        m, "CutSurface", "A mesh without what is transparent; see native/fovea/cutout/cutout.h.")
        .def(
            py::init(&make_cut), py::arg("name"), py::arg("mesh"), py::arg("cuts"), py::arg("cut_of_polygon"),
            py::kw_only(), py::arg("px_per_unit") = 0.0,
            R"(cut_of_polygon (F,) int32: an index into the cuts, -1: opaque. px_per_unit: pixels of the drawing per unit
of object space; images are halved to about a texel per pixel; 0: as they are. Raises ValueError, naming the object, as
Surface does.)")
        .def(
            "set_positions",
            [](CutSurface& surface, const Arg<vec3>& positions, bool refit) {
                const In<vec3> moved = borrow<vec3>(positions, "positions");
                without_gil([&] { surface.move(moved, refit); });
            },
            py::arg("positions"), py::kw_only(), py::arg("refit") = false,
            "Moves the vertices of the mesh that was cut, (V, 3) float32. refit: as Surface has it.")
        .def("mix_corners", &mix_cut_corners, py::arg("values"),
             "(C, k) float32 at the corners of the mesh that was cut, to those of the surface.");
}

}  // namespace fovea::bindings
