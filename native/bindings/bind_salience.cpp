// SPDX-License-Identifier: GPL-3.0-or-later
// Salience of pictures, and where eyes go by it.
#include <algorithm>

#include <fovea/study/fixations.h>
#include <fovea/study/salience.h>

#include "bindings/arrays.h"
#include "bindings/bind.h"

namespace fovea::bindings {
namespace {

using Bytes = py::array_t<std::uint8_t, py::array::c_style | py::array::forcecast>;

/// Salience of a picture, and its shape.
struct Salience {
    study::Plane map;
    double shape;  ///< width over height of the picture
};

using Model = study::Plane (*)(const color::RgbImage&);

template <Model model>
Salience salience_of(const Bytes& pixels) {
    check(pixels.ndim() == 3 && pixels.shape(2) == 3 && pixels.size() > 0 && pixels.size() < py::ssize_t(none),
          "a picture: expected pixels of shape (height, width, 3)");
    const color::RgbImage picture{
        int(pixels.shape(1)), int(pixels.shape(0)), {pixels.data(), pixels.data() + pixels.size()}};
    return without_gil([&] { return Salience{model(picture), double(picture.width) / picture.height}; });
}

Numpy<double> fixations_of(const Salience& salience, int most) {
    Array<double> rows;
    for (const auto& [at, value] : study::fixations(salience.map, salience.shape, most))
        rows.insert(rows.end(), {at.x, at.y, value});
    const auto count = py::ssize_t(rows.size() / 3);
    return to_numpy(std::move(rows)).reshape({count, py::ssize_t(3)});
}

double share_of(const Salience& salience, const Pixels& weights) {
    check(weights.ndim() == 2 && weights.size() > 0, "weights: expected shape (height, width)");
    study::Plane plane(int(weights.shape(1)), int(weights.shape(0)));
    std::copy_n(weights.data(), weights.size(), plane.values.begin());
    return without_gil([&] { return study::salient_share(salience.map, plane); });
}

}  // namespace

void bind_salience(py::module_& m) {
    py::class_<Salience> salience(m, "Salience", "How far places of a picture stand out of the rest.");
    salience.attr("usual_diagonal") = study::usual_diagonal;
    salience
        .def_static("itti_koch", &salience_of<study::itti_koch>, py::arg("pixels"),
                    "By the model of Itti, Koch and Niebur; pixels: (H, W, 3) uint8 as displayed, bottom row first.")
        .def_static("spectral_residual", &salience_of<study::spectral_residual>, py::arg("pixels"),
                    "By that of Hou and Zhang.")
        .def_property_readonly(
            "map",
            [](const py::object& self) {
                const study::Plane& map = self.cast<const Salience&>().map;
                return view_numpy(map.values, self).reshape({map.height, map.width});
            },
            "(h, w) float32 of cells, bottom row first; all 0: nothing stands out")
        .def(
            "of_pixels",
            [](const Salience& salience, int width, int height) {
                check(width > 0 && height > 0, "a picture needs pixels");
                study::Plane found = without_gil([&] { return study::resized(salience.map, width, height); });
                const float most = *std::ranges::max_element(found.values);
                for (float& value : found.values) value = most > 0.0f ? value / most : 0.0f;
                return to_image(std::move(found.values), width, height);
            },
            py::arg("width"), py::arg("height"), "(H, W) float32 of a picture's pixels, as shares of the most.")
        .def("fixations", &fixations_of, py::arg("most"),
             "(n, 3) float64, at most `most`, in the order in which eyes go there: the place, 0 to 1 from the left and "
             "the bottom, and its salience as a share of the first one's.")
        .def("share", &share_of, py::arg("weights"),
             "Share of all salience that lies where weights (H, W), 0 to 1, say.");
}

}  // namespace fovea::bindings
