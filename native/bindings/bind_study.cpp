// SPDX-License-Identifier: GPL-3.0-or-later
// Comparing drawings: scans and lines as sets of pixels.
#include <algorithm>
#include <glm/gtc/type_ptr.hpp>

#include <fovea/study/fit.h>
#include <fovea/study/measures.h>
#include <fovea/study/nearest_pixel.h>
#include <fovea/study/precision_recall.h>
#include <fovea/study/register.h>
#include <fovea/study/scan.h>
#include <fovea/study/sheet.h>
#include <fovea/study/stroke_look.h>
#include <fovea/study/svg_path.h>
#include <fovea/study/thin.h>
#include <fovea/vector/pdf.h>

#include "bindings/arrays.h"
#include "bindings/bind.h"
#include "bindings/records.h"

namespace fovea::bindings {
namespace {

using study::Bitmap;
using Bytes = py::array_t<std::uint8_t, py::array::c_style | py::array::forcecast>;

/// A view of an object's pixels, (height, width).
template <typename T>
Numpy<T> view_image(const Array<T>& pixels, int width, int height, py::handle owner) {
    return view_numpy(pixels, owner).reshape({height, width});
}

Array<std::uint8_t> values_of(const Bytes& image) {
    check(image.ndim() == 2 && image.size() > 0 && image.size() < py::ssize_t(none),
          "a drawing: expected pixels of shape (height, width)");
    return {image.data(), image.data() + image.size()};
}

Bitmap make_bitmap(const Bytes& pixels) {
    Bitmap bitmap;
    bitmap.set = values_of(pixels);
    bitmap.width = int(pixels.shape(1)), bitmap.height = int(pixels.shape(0));
    for (std::uint8_t& value : bitmap.set) value = value != 0;
    return bitmap;
}

Bitmap bitmap_of_lines(const Arg<vec2>& px, const Arg<std::int64_t>& offsets, int width, int height) {
    const In<vec2> points = borrow<vec2>(px, "px");
    const In<std::int64_t> rows = borrow<std::int64_t>(offsets, "offsets");
    return without_gil([&] { return study::pixels_of(points, rows, width, height); });
}

Bitmap bitmap_of_svg(const std::vector<std::string>& data, const Arg<double>& transforms,
                     const std::vector<bool>& is_filled, int width, int height) {
    check(transforms.ndim() == 2 && transforms.shape(1) == 6 && std::size_t(transforms.shape(0)) == data.size() &&
              is_filled.size() == data.size(),
          "paths: a transform (6,) and whether it is filled are needed for each");
    std::vector<study::SvgPath> paths;
    for (std::size_t i = 0; i < data.size(); ++i) {
        paths.push_back({data[i], {}, is_filled[i]});
        std::copy_n(transforms.data() + 6 * i, 6, paths.back().transform.begin());
    }
    return without_gil([&] { return study::pixels_of_svg(paths, width, height); });
}

study::Strengths make_strengths(const Arg<vec2>& px, const Arg<std::int64_t>& offsets, const Arg<float>& strength,
                                int width, int height) {
    const In<vec2> points = borrow<vec2>(px, "px");
    const In<std::int64_t> rows = borrow<std::int64_t>(offsets, "offsets");
    const In<float> values = borrow<float>(strength, "strength");
    return {width, height, without_gil([&] { return study::most_at_pixels(points, rows, values, width, height); })};
}

/// The map as rows, (3, 3).
Numpy<double> matrix_of(const study::Homography& map) {
    Array<double> rows;
    for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k) rows.push_back(map[k][i] / map[2][2]);
    return to_numpy(std::move(rows)).reshape({3, 3});
}

study::Homography homography_from(const Arg<double>& rows) {
    check(rows.ndim() == 2 && rows.shape(0) == 3 && rows.shape(1) == 3, "matrix: expected shape (3, 3)");
    return glm::transpose(glm::make_mat3(rows.data()));
}

py::object registration_of(const Bitmap& scan, const Bitmap& reference, double tolerance) {
    const auto found = without_gil([&] { return study::registered(scan, reference, tolerance); });
    if (!found) return py::none();
    return py::dict(py::arg("to_scan") = matrix_of(found->to_scan), py::arg("outer_share") = found->outer_share);
}

py::dict dict_of(const study::Measures& found) {
    py::dict measures;
    style::for_each_field<study::Measures>([&](const auto& field) { measures[field.name] = found.*field.member; });
    return measures;
}

py::dict measures_of(const Bitmap& a, const Bitmap& b, double tolerance) {
    return dict_of(without_gil([&] { return study::compare(a, b, tolerance); }));
}

void bind_nearness(py::module_& m) {
    py::class_<study::Nearness>(m, "Nearness", "How far the pixels of two drawings are from each other.")
        .def(py::init<const Bitmap&, const Bitmap&>(), NoGil(), py::arg("a"), py::arg("b"))
        .def(
            "measures",
            [](const study::Nearness& nearness, double tolerance) {
                return dict_of(without_gil([&] { return nearness.at(tolerance); }));
            },
            py::arg("tolerance"), "As Bitmap.measures.")
        .def_property_readonly("pixels", &study::Nearness::pixels, "of both")
        .def("shares_within", &study::Nearness::shares_within, NoGil(), py::arg("distances"),
             "For each of the distances [px] the share of both drawings' pixels that are that near to the other one.");
}

GrayImage make_gray(const Bytes& values) {
    return {int(values.shape(values.ndim() - 1)), int(values.shape(0)), values_of(values)};
}

GrayImage gray_of_png(const py::bytes& file) {
    const std::string_view bytes(file);
    return without_gil(
        [bytes] { return color::gray_png({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()}); });
}

py::object frame_on_scan(const GrayImage& scan, int width, int height) {
    const auto found = without_gil([&] { return study::found_by_marks(scan, width, height); });
    if (!found) return py::none();
    return matrix_of(*found);
}

py::bytes prompt_sheet(const GrayImage& picture, const std::string& title, const py::str& sheet) {
    const auto size = value_from<vector::Sheet>(sheet, "sheet");
    return without_gil([&] { return vector::pdf_bytes(study::prompt_sheet(picture, size, title)); });
}

Bitmap lines_of(const GrayImage& picture) { return study::thinned(study::ink_of(picture)); }

void bind_gray(py::module_& m) {
    m.attr("LEAST_INK") = study::least_ink / 255.0;
    py::class_<study::StrokeLooks> looks(m, "StrokeLooks",
                                         "How wide and dark strokes are; see native/fovea/study/stroke_look.h.");
    bind_columns(looks, study::StrokeLooks::columns);
    py::class_<GrayImage>(m, "GrayImage", "A scan or picture of gray values.")
        .def(py::init(&make_gray), py::arg("values"), "values: (H, W) uint8, bottom row first.")
        .def_static("of_png", &gray_of_png, py::arg("file"), "Of a PNG file's bytes; transparent parts lie on white.")
        .def_property_readonly(
            "values",
            [](const py::object& self) {
                const auto& gray = self.cast<const GrayImage&>();
                return view_image(gray.values, gray.width, gray.height, self);
            },
            "(H, W) uint8, bottom row first")
        .def(
            "resampled",
            [](const GrayImage& gray, const Arg<double>& to_picture, int width, int height) {
                const study::Homography map = homography_from(to_picture);
                return without_gil([&] { return study::resampled(gray, map, width, height); });
            },
            py::arg("to_picture"), py::arg("width"), py::arg("height"),
            "A GrayImage of other pixels, which the matrix (3, 3) maps to those of this one.")
        .def(
            "frame_by_marks", &frame_on_scan, py::arg("width"), py::arg("height"),
            "The matrix (3, 3) from pixels of a picture to those of this scan of its prompt sheet; None: the marks are "
            "not found.")
        .def("prompt_sheet", &prompt_sheet, py::arg("title"), py::arg("sheet") = "a4",
             "A PDF file's bytes: a sheet to draw on after this picture; see native/fovea/study/sheet.h.")
        .def("lines", &lines_of, NoGil(), "The Bitmap of what is drawn, one pixel wide; see native/fovea/study/scan.h.")
        .def("stroke_looks", &study::looks_of, NoGil(), py::arg("lines"),
             "The StrokeLooks of this picture along the Bitmap of its lines.");
}

void bind_strengths(py::module_& m) {
    using study::PrecisionRecall;
    py::class_<PrecisionRecall> curve(m, "PrecisionRecall",
                                      "Drawings of ever more lines, by the threshold of their strengths.");
    bind_columns(curve, PrecisionRecall::columns);
    curve
        .def("best_at", &PrecisionRecall::best_at, py::arg("precision"),
             "The number of the one with the most recall of at least this precision; -1: there is none.")
        .def("recall_at", &PrecisionRecall::recall_at, py::arg("precision"), "Its recall.")
        .def_property_readonly("area", &PrecisionRecall::area, "Mean recall at precisions of 0.5 to 1");
    py::class_<study::Strengths>(m, "Strengths", "Strengths of lines at pixels.")
        .def(py::init(&make_strengths), py::arg("px"), py::arg("offsets"), py::arg("strength"), py::arg("width"),
             py::arg("height"), "Of polylines as for Bitmap.of_lines, with the strength (M,) at their points.")
        .def("above", &study::Strengths::above, py::arg("threshold"), "The Bitmap of pixels with at least a strength.")
        .def(
            "curve",
            [](const study::Strengths& strengths, const Bitmap& always, const Bitmap& judge, double tolerance) {
                return without_gil([&] { return study::precision_recall(strengths, always, judge, tolerance); });
            },
            py::arg("always"), py::arg("judge"), py::arg("tolerance"),
            "The PrecisionRecall of these lines, with the Bitmap of lines that are drawn in any case, judged by "
            "another one.");
}

py::dict told(const study::Fit& fit) {
    return py::dict(py::arg("thresholds") = to_numpy(Array<float>(fit.thresholds)),
                    py::arg("precision") = fit.precision, py::arg("recall") = fit.recall, py::arg("f1") = fit.f(1.0),
                    py::arg("score") = fit.score);
}

using Fitting = study::Fit (*)(const study::Evidence&, In<float>, const study::FitOptions&);

template <Fitting fit>
py::dict fit_of(const study::Evidence& evidence, const Arg<float>& thresholds, double beta) {
    const In<float> given = borrow<float>(thresholds, "thresholds");
    return told(without_gil([&] { return fit(evidence, given, {.beta = beta}); }));
}

study::Evidence evidence_from(const std::vector<const study::Strengths*>& definitions,
                              const std::vector<const Bitmap*>& judges, double tolerance) {
    check(!std::ranges::count(definitions, nullptr) && !std::ranges::count(judges, nullptr),
          "a fit: Strengths and Bitmaps expected, not None");
    std::vector<study::Judging> drawings;
    for (const Bitmap* judge : judges) drawings.push_back({definitions, judge});
    return without_gil([&] { return study::evidence_of(drawings, tolerance); });
}

void bind_fit(py::module_& m) {
    py::class_<study::Evidence>(m, "Evidence",
                                "What a fit of thresholds depends on; see native/fovea/study/evidence.h and fit.h.")
        .def(py::init(&evidence_from), py::arg("definitions"), py::arg("judges"), py::arg("tolerance"),
             "Of the Strengths of D definitions and of the Bitmaps of drawings in the same view; `tolerance` [px].")
        .def("fitted", &fit_of<study::fitted>, py::arg("thresholds"), py::arg("beta") = 1.0,
             "{thresholds: (D,) float32, infinite for what is not drawn, precision, recall, f1, score} with which the "
             "definitions draw what is most like all drawings together. `thresholds`: to start from.")
        .def("judged", &fit_of<study::judged>, py::arg("thresholds"), py::arg("beta") = 1.0,
             "The same of the given thresholds.")
        .def("cross_validated", &fit_of<study::cross_validated>, py::arg("thresholds"), py::arg("beta") = 1.0,
             "The same without thresholds, of parts that are held out of the fit one after the other: each of the "
             "drawings, or of a single one blocks of the picture.");
}

}  // namespace

void bind_study(py::module_& m) {
    py::class_<Bitmap>(m, "Bitmap", "A drawing as a set of pixels.")
        .def(py::init(&make_bitmap), py::arg("pixels"), "pixels: (H, W) uint8, bottom row first; 0: not drawn.")
        .def_static("of_lines", &bitmap_of_lines, py::arg("px"), py::arg("offsets"), py::arg("width"),
                    py::arg("height"),
                    "Of polylines with points px (M, 2) float32 from the lower left corner; line i has the points "
                    "offsets[i] to offsets[i + 1].")
        .def_static(
            "of_svg", &bitmap_of_svg, py::arg("data"), py::arg("transforms"), py::arg("is_filled"), py::arg("width"),
            py::arg("height"),
            "Of path data of SVG, with transforms (N, 6) as SVG has them, to pixels from the upper left corner; "
            "of filled paths the lines in their middle.")
        .def_property_readonly(
            "pixels",
            [](const py::object& self) {
                const auto& bitmap = self.cast<const Bitmap&>();
                return view_image(bitmap.set, bitmap.width, bitmap.height, self);
            },
            "(H, W) uint8 of 1 and 0, bottom row first")
        .def_property_readonly(
            "usual_tolerance", [](const Bitmap& bitmap) { return study::usual_tolerance(bitmap.diagonal()); },
            "Distance [px] that counts as near in drawings of this size")
        .def(
            "distances",
            [](const Bitmap& bitmap) {
                auto found = without_gil([&] { return study::distances_to(bitmap); });
                return to_image(std::move(found), bitmap.width, bitmap.height);
            },
            "(H, W) float32 distances [px] to the nearest pixel that is drawn.")
        .def("measures", &measures_of, py::arg("judge"), py::arg("tolerance"),
             "{measure: number} of this drawing judged by another Bitmap; see native/fovea/study/measures.h.")
        .def("registration", &registration_of, py::arg("reference"), py::arg("tolerance"),
             "{to_scan: (3, 3) from pixels of a reference Bitmap to those of this one, outer_share: share of its outer "
             "boundary that is within the tolerance [px]}, by their lines; None if one is empty.");
    bind_nearness(m);
    bind_gray(m);
    bind_strengths(m);
    bind_fit(m);
}

}  // namespace fovea::bindings
