// SPDX-License-Identifier: GPL-3.0-or-later
// Styles: records, files, and the declarations of their members.
#include <fovea/base/files.h>
#include <fovea/draw/pens.h>
#include <fovea/style/json.h>
#include <fovea/style/json_value.h>
#include <fovea/style/mix.h>

#include "bindings/bind.h"
#include "bindings/records.h"

namespace fovea::bindings {

/// A tuple of the path and the parsed value.
template <>
struct Member<style::Unknown> {
    using Python = py::tuple;
    static style::Unknown from(const py::handle& given) {
        const auto [steps, value] = given.cast<std::pair<py::sequence, py::object>>();
        style::Unknown unknown;
        for (const py::handle& step : steps)
            if (py::isinstance<py::str>(step))
                unknown.path.emplace_back(step.cast<std::string>());
            else
                unknown.path.emplace_back(step.cast<std::size_t>());
        unknown.json = json().attr("dumps")(value).cast<std::string>();
        return unknown;
    }
    static Python to(const style::Unknown& unknown) {
        py::tuple path(unknown.path.size());
        for (std::size_t i = 0; i < unknown.path.size(); ++i)
            path[i] = std::visit([](const auto& step) { return py::object(py::cast(step)); }, unknown.path[i]);
        return py::make_tuple(path, json().attr("loads")(unknown.json));
    }
    static py::module_ json() { return py::module_::import("json"); }
};

/// A number, or a text of a file's path.
template <>
struct Member<ParameterValue> {
    using Python = py::object;
    static ParameterValue from(const py::handle& given) {
        if (py::isinstance<py::str>(given)) return {given.cast<std::string>()};
        return {given.cast<double>()};
    }
    static Python to(const ParameterValue& value) {
        return value.file.empty() ? py::object(py::float_(value.number)) : py::object(py::str(value.file));
    }
};

namespace {

style::Style read(const std::string& json, std::vector<std::string> textures, std::vector<std::string> papers) {
    const style::Shipped shipped{std::move(textures), std::move(papers)};
    return style::read_style(json, &shipped);
}

}  // namespace

void bind_style(py::module_& parent) {
    py::module_ m = parent.def_submodule(
        "style",
        "What a style is made of. A class tells in `fields` what each of its members is and may be: dicts of name, key "
        "(in files; None: not there), label, description, type, group, default, min, max, soft_max, unit, names, "
        "most_letters and "
        "choices.");
    bind_part<style::Transfer>(m, "Transfer", "Mix of an effect over focus, distance or the length of a stroke.");
    bind_part<style::Pen>(m, "Pen", "How strokes look.");
    bind_part<style::Hidden>(m, "Hidden",
                             "How the parts of lines are drawn that a range of numbers of surfaces hides.");
    bind_part<style::LineSet>(m, "LineSet", "Lines drawn alike.");
    bind_part<style::Paper>(m, "Paper", "The paper.");
    bind_part<style::Color>(m, "Color", "The scene's surfaces in color, under the lines.");
    bind_part<style::Section>(m, "Section", "The inside of what the scene's section plane cuts.");
    bind_part<style::Elision>(m, "Elision", "Which of the lines that crowd each other stay.")
        .def("ranks", &style::Elision::ranks, "Whether something counts for the priority of lines.");
    bind_part<style::Animation>(m, "Animation", "How drawings follow each other in an animation.")
        .def("held", &style::Animation::held, py::arg("frame"), "The frame whose drawing stands at a frame.")
        .def("since_key", &style::Animation::since_key, py::arg("frame"),
             "How many frames before this one the last key of marks is.")
        .def("boil_drawing", &style::Animation::boil_drawing, py::arg("frame"),
             "The number of the boil's drawing at a frame, in its cycle.");
    bind_part<style::Effects>(m, "Effects", "What answers to focus.");
    bind_part<style::Distance>(m, "Distance", "What answers to the distance from the camera.");
    bind_part<style::FocusPlace>(m, "FocusPlace", "A place to look at.");
    bind_part<style::Focus>(m, "Focus", "Where the viewer shall look.").def("active", &style::Focus::active);
    bind_part<style::Style>(m, "Style", "A style.")
        .def_static(
            "read", &read, py::arg("json"), py::arg("textures"), py::arg("papers"),
            "The style in a file's JSON (UTF-8), which names of textures and papers only these. ValueError says "
            "what is wrong.")
        .def("written", &style::write_style, "The JSON of its file.")
        .def("mixed", &style::mix, py::arg("other"), py::arg("share"), "The style between it (0) and another (1).")
        .def("has_color", &style::Style::has_color, "Whether there is a color layer.")
        .def("fixes_marks", &style::Style::fixes_marks, "Whether a pen fixes its marks to paths.")
        .def("pens", &pens_in_order,
             "Those in focus of visible parts by line set, of hidden parts, and all those out of focus.")
        .def("width_px", &style::Style::width_px, py::arg("pen"), py::arg("reference_scale"),
             "Width of a pen in pixels of an image, so many of which are a reference pixel.");
    m.def(
        "parameters",
        [](const std::string& definition, const py::dict& given, const std::string& where) {
            const auto checked = style::checked_parameters(definition, Member<style::Parameters>::from(given), where);
            return Member<style::Parameters>::to(checked);
        },
        py::arg("definition"), py::arg("values"), py::arg("where"),
        "{parameter: value} of a line definition, checked. ValueError says what is wrong with it.");
    m.def(
        "file_bytes",
        [](const py::bytes& path) { return py::bytes(bytes_of_file(file_of(std::string(path)), style::largest + 3)); },
        py::arg("path"),
        "The bytes of a style file; a byte order mark does not count. ValueError if it is none or too large.");
    m.attr("SCHEMA") = style::schema;
    m.attr("LARGEST") = style::largest;
    m.attr("MOST_SURFACES") = style::most_surfaces;
    m.attr("MOST_PLACES") = style::Focus::most_places;
    m.attr("MOST_CURVE_POINTS") = style::Transfer::most_points;
}

}  // namespace fovea::bindings
