// SPDX-License-Identifier: GPL-3.0-or-later
// Local properties of pixels, models that learn from drawings by them, and lines of what these find likely.
#include <fovea/study/learn.h>
#include <fovea/study/model_likelihood.h>
#include <fovea/study/probable_lines.h>

#include "bindings/arrays.h"
#include "bindings/bind.h"
#include "bindings/records.h"

namespace fovea::bindings {
namespace {

using study::LineModel;
using study::LocalProperties;
using study::PropertyRow;

constexpr auto count = py::ssize_t(study::property_count);

LocalProperties properties_of(const Scene& scene, const View& view) {
    return without_gil([&] { return study::local_properties(Tracer(scene, view), Cancel()); });
}

/// Borrowed rows of properties.
In<PropertyRow> rows_of(const Pixels& rows) {
    check(rows.ndim() == 2 && rows.shape(1) == count,
          "rows: expected shape (n, " + std::to_string(study::property_count) + ")");
    return {reinterpret_cast<const PropertyRow*>(rows.data()), std::size_t(rows.shape(0))};
}

study::Samples samples_of(const Pixels& rows, const Arg<float>& target, const Arg<float>& weight) {
    return {rows_of(rows), borrow<float>(target, "target"), borrow<float>(weight, "weight")};
}

LineModel learned(const py::str& kind, const Pixels& rows, const Arg<float>& target, const Arg<float>& weight) {
    const auto wanted = value_from<LineModel::Kind>(kind, "kind");
    const study::Samples samples = samples_of(rows, target, weight);
    return without_gil([&] { return study::learned(wanted, samples); });
}

py::dict importance_of(const LineModel& model, const Pixels& rows, const Arg<float>& target, const Arg<float>& weight) {
    const study::Samples samples = samples_of(rows, target, weight);
    const auto found = without_gil([&] { return study::importance(model, samples); });
    py::dict told;
    for (std::size_t i = 0; i < found.size(); ++i) told[study::property_names[i].name] = found[i];
    return told;
}

Array<float> values_of(const LineModel& model, const Pixels& rows) {
    const In<PropertyRow> given = rows_of(rows);
    return without_gil([&] {
        return parallel_map<float>(given.size(), [&](std::size_t i) { return float(model.probability(given[i])); });
    });
}

study::Strengths crests_of(const Pixels& probability) {
    check(probability.ndim() == 2 && probability.size() > 0, "probability: expected shape (height, width)");
    study::Plane plane(int(probability.shape(1)), int(probability.shape(0)));
    std::copy_n(probability.data(), probability.size(), plane.values.begin());
    return without_gil([&] { return study::crests_of(plane); });
}

void bind_properties(py::module_& m) {
    py::class_<LocalProperties> properties(m, "LocalProperties", "What is known of each pixel of a scene alone.");
    py::list names;
    for (const study::PropertyName& each : study::property_names) names.append(py::make_tuple(each.name, each.label));
    properties.attr("names") = py::tuple(names);
    properties
        .def(py::init(&properties_of), py::arg("scene"), py::arg("view"),
             "Of the pixels of a view; see native/fovea/study/local_properties.h.")
        .def_property_readonly(
            "known",
            [](const py::object& self) {
                const study::Bitmap& known = self.cast<const LocalProperties&>().known;
                return view_numpy(known.set, self).reshape({known.height, known.width});
            },
            "(H, W) uint8, bottom row first; 1: a surface is seen there or beside")
        .def_property_readonly(
            "values",
            [](const py::object& self) {
                const auto& found = self.cast<const LocalProperties&>();
                const std::vector<py::ssize_t> shape{found.known.height, found.known.width, count};
                py::array_t<float> view(shape, found.rows.front().data(), self);
                view.attr("flags").attr("writeable") = false;
                return view;
            },
            "(H, W, 15) float32, in the order of `names`, which are pairs of name and label");
}

}  // namespace

void bind_learn(py::module_& m) {
    bind_properties(m);
    py::class_<LineModel> model(m, "LineModel", "How likely a line is at pixels, learned from drawings.");
    model.attr("kinds") = py::tuple(choices<LineModel::Kind>());
    model
        .def(py::init(&learned), py::arg("kind"), py::arg("rows"), py::arg("target"), py::arg("weight"),
             "kind: one of `kinds`; rows (n, 15) of LocalProperties, target (n,) in [0, 1], weight (n,) positive.")
        .def_static("of_json", &study::read_model, NoGil(), py::arg("text"), "Of a model file's text.")
        .def("json", &study::write_model, NoGil(), "The text of a model file, of which the same model is read.")
        .def_property_readonly(
            "kind",
            [](const LineModel& self) { return py::str(style::choices_of<LineModel::Kind>[int(self.kind)].name); })
        .def_readonly("threshold", &LineModel::threshold, "Probability from which on there are lines")
        .def_property_readonly(
            "content",
            [](const LineModel& self) {
                return std::const_pointer_cast<FileContent>(
                    std::static_pointer_cast<const FileContent>(study::likelihood_of(self)));
            },
            "As FileContent of a line definition.")
        .def(
            "with_threshold",
            [](LineModel self, double threshold) {
                check(threshold >= 0.0 && threshold <= 1.0, "threshold: expected a number from 0 to 1");
                self.threshold = threshold;
                return self;
            },
            py::arg("threshold"), "The same with another one.")
        .def(
            "__eq__", [](const LineModel& a, const LineModel& b) { return a == b; }, py::is_operator())
        .def("values", &values_of, py::arg("rows"), "(n,) float32 probabilities of rows (n, 15).")
        .def(
            "probabilities",
            [](const LineModel& self, const LocalProperties& properties) {
                auto found = without_gil([&] { return study::probabilities(self, properties); });
                return to_image(std::move(found), properties.known.width, properties.known.height);
            },
            py::arg("properties"), "(H, W) float32, bottom row first; 0 where the properties are not known.")
        .def("importance", &importance_of, py::arg("rows"), py::arg("target"), py::arg("weight"),
             "{property: share of the target's variance by which the error grows without it}; see "
             "native/fovea/study/samples.h.");
    model.attr("__hash__") = py::none();
    m.def("crests_of", &crests_of, py::arg("probability"),
          "The Strengths of the crests of probabilities (H, W); see native/fovea/study/probable_lines.h.");
    m.def("lines_of", &study::lines_of, NoGil(), py::arg("crests"), py::arg("threshold"),
          "The Bitmap of the crests that are as strong as the threshold somewhere, as far as they have half of it.");
}

}  // namespace fovea::bindings
