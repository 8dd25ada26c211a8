// SPDX-License-Identifier: GPL-3.0-or-later
// Frames: their input, steps and passes, and backends.
#include <pybind11/functional.h>
#include <pybind11/stl/filesystem.h>
#include <pybind11/typing.h>

#include <fovea/draw/ahead.h>
#include <fovea/draw/content.h>
#include <fovea/draw/cryptomatte.h>
#include <fovea/draw/object_at.h>
#include <fovea/draw/polylines.h>
#include <fovea/visibility/exact.h>

#include "bindings/bind.h"
#include "bindings/overrides.h"
#include "bindings/records.h"

namespace fovea::bindings {
namespace {

/// A backend implemented in Python: its methods are called with the GIL held, on the thread that draws.
class PythonBackend : public Backend {
   public:
    std::string name() const override {
        py::gil_scoped_acquire held;
        return py::cast(static_cast<const Backend*>(this)).attr("name").cast<std::string>();
    }
    Array<float> visibility(const Frame& frame) override {
        py::gil_scoped_acquire held;
        const auto values = method("visibility")(frame_of(frame)).cast<Arg<float>>();
        return copy<float>(values, "visibility");
    }
    Array<vec2> elide(const Frame& frame, const Elision& elision) override {
        py::gil_scoped_acquire held;
        const py::object bands = py::cast(&elision, py::return_value_policy::reference);
        const auto crowding = method("elide")(frame_of(frame), bands).cast<Arg<vec2>>();
        return copy<vec2>(crowding, "crowding");
    }
    Array<vec4> draw(const Frame& frame) override {
        py::gil_scoped_acquire held;
        const View& view = frame.job.view;
        Array<vec4> image(std::size_t(view.width) * view.height);
        // A view of memory, not initialized, that the method fills and does not keep.
        const py::capsule borrowed(&image, [](void*) {});
        method("draw")(frame_of(frame),
                       Numpy<float>({view.height, view.width, 4}, reinterpret_cast<float*>(image.data()), borrowed));
        return image;
    }

   private:
    py::function method(const char* of) const {
        const py::function found = py::get_override(static_cast<const Backend*>(this), of);
        if (!found) throw py::type_error(std::string("the backend has no method '") + of + "'");
        return found;
    }
    static py::object frame_of(const Frame& frame) { return py::cast(&frame, py::return_value_policy::reference); }
};

using Near = std::map<int, NearLines>;
using Poses = std::map<int, std::shared_ptr<Pose>>;
using GivenFiles = std::map<std::string, std::shared_ptr<FileContent>>;

std::shared_ptr<Frame> make_frame(std::shared_ptr<Scene> scene, const View& view, const style::Style& style,
                                  const Options& options, std::shared_ptr<Assets> assets,
                                  std::shared_ptr<Backend> backend, const OwningOverrides* overrides,
                                  const ColorSources* colors, const Near& near, int since_key,
                                  const Optional<double>& baked_marks, const Poses& poses,
                                  std::shared_ptr<Exposure> exposure, const GivenFiles& files,
                                  std::shared_ptr<Cancel> cancel, const std::optional<py::function>& progress) {
    Job job{.scene = std::move(scene), .view = view, .style = style, .options = options};
    if (overrides) job.overrides = overrides->overrides;
    job.assets = std::move(assets);
    job.backend = std::move(backend);
    if (colors) job.colors = *colors;
    job.near.assign(near.begin(), near.end());
    job.since_key = since_key;
    const In<double> marks = borrow<double>(baked_marks, "baked_marks");
    job.baked_marks.assign(marks.begin(), marks.end());
    for (const auto& [away, pose] : poses) {
        check(away == -1 || away == 1, "poses: they are those of the frames beside the frame, at -1 and 1");
        (away < 0 ? job.before : job.after) = pose;
    }
    job.exposure = std::move(exposure);
    job.files.insert(files.begin(), files.end());
    if (cancel) job.cancel = std::move(cancel);
    if (progress)
        job.progress = [heard = *progress](double share, const std::string& stage) {
            py::gil_scoped_acquire held;
            heard(share, stage);
        };
    return std::make_shared<Frame>(std::move(job));
}

/// Getter of an array of the frame; None if it is empty.
template <typename T>
auto member(Array<T> Frame::* array) {
    return [array](py::object self) -> std::optional<Numpy<T>> {
        const Array<T>& values = self.cast<const Frame&>().*array;
        return values.empty() ? std::nullopt : std::optional(view_numpy(values, self));
    };
}

template <typename T>
std::shared_ptr<T> mutable_pointer(const std::shared_ptr<const T>& pointer) {
    return std::const_pointer_cast<T>(pointer);  // bound functions do not modify it
}

/// A pass as an image, moved out of the frame; None if it is empty.
template <typename T>
std::optional<Numpy<T>> image(Array<T>& pixels, const View& view) {
    return pixels.empty() ? std::nullopt : std::optional(to_image(std::exchange(pixels, {}), view.width, view.height));
}

py::typing::Dict<std::string, py::object> passes(Frame& frame) {
    const View& view = frame.job.view;
    Picture& p = frame.passes;
    py::dict line_sets;
    for (auto& [name, pixels] : p.of_lines.line_sets) line_sets[py::str(name)] = image(pixels, view);
    py::list mattes;
    for (Array<vec4>& pixels : p.of_lines.mattes) mattes.append(image(pixels, view));
    return py::dict(py::arg("combined") = image(p.combined, view), py::arg("lines") = image(p.lines, view),
                    py::arg("color") = image(p.color, view), py::arg("focus") = image(p.focus, view),
                    py::arg("depth") = image(p.depth, view), py::arg("hidden_lines") = image(p.of_lines.hidden, view),
                    py::arg("line_sets") = line_sets, py::arg("line_depth") = image(p.of_lines.depth, view),
                    py::arg("line_vector") = image(p.of_lines.vector, view),
                    py::arg("line_id") = image(p.of_lines.id, view), py::arg("mattes") = mattes);
}

void bind_backend(py::module_& m) {
    py::class_<Backend, PythonBackend, std::shared_ptr<Backend>>(
        m, "Backend", "Who decides what a depth buffer hides, what crowds, and who puts strokes on paper.")
        .def(py::init<>())
        .def_property_readonly("name", &Backend::name)
        .def("visibility", &Backend::visibility, NoGil(), py::arg("frame"),
             "(samples,) float32 in [0, 1] of a frame's atlas, by its sampled method.")
        .def("elide", &Backend::elide, NoGil(), py::arg("frame"), py::arg("elision"),
             "(D, 2) float32 crowding of the samples that runs cover.")
        .def(
            "draw",
            [](Backend& backend, const Frame& frame) {
                const View& view = frame.job.view;
                return to_image(without_gil([&] { return backend.draw(frame); }), view.width, view.height);
            },
            py::arg("frame"), "(H, W, 4) float32: the frame's strokes alone, premultiplied, bottom row first.");
    py::class_<CpuBackend, Backend, std::shared_ptr<CpuBackend>>(m, "CpuBackend", "The reference, all in software.")
        .def(py::init<int>(), py::arg("most_side") = CpuBackend().most_side, "texels of a tile of the depth buffer")
        .def_readwrite("most_side", &CpuBackend::most_side);
}

void bind_found_lines(py::module_& m) {
    py::class_<NearLines>(m, "NearLines", "Lines of a frame as neighboring frames need them.")
        .def_property_readonly(
            "marks_content", [](const NearLines& lines) { return lines.marked ? lines.marked->content() : 0; },
            "Hash of the lines that marks are handed on along; 0: there are none.")
        .def(
            "own_marks",
            [](const NearLines& lines) {
                return to_numpy(lines.marked ? lines.marked->packed(lines.marked->own) : Array<double>());
            },
            "(n,) float64 places of marks along them, in pixels, as the frame alone has them.")
        .def(
            "marks_handed_on",
            [](const NearLines& lines, const NearLines& before, const Arg<double>& marks) {
                const In<double> values = borrow<double>(marks, "marks");
                return to_numpy(without_gil([&] {
                    if (!lines.marked || !before.marked) return Array<double>();
                    const MarkedLines &now = *lines.marked, &there = *before.marked;
                    return now.packed(handed_on(now, there, there.unpacked(values)));
                }));
            },
            py::arg("before"), py::arg("marks"),
            "(n,) float64 marks, handed on from those of the NearLines of a frame beside it.");
    py::class_<FoundLines, std::shared_ptr<FoundLines>>(
        m, "FoundLines", "What a frame has found of its lines, without neighboring frames.")
        .def_property_readonly("near_lines", [](const FoundLines& found) { return found.lines; })
        .def_property_readonly(
            "shown_lines", [](const FoundLines& found) { return mutable_pointer(found.lines.shown); },
            "what elision leaves of them; None: there is no elision")
        .def_property_readonly("bytes", &FoundLines::bytes, "about");
}

void bind_exposure(py::module_& m) {
    py::class_<Exposure, std::shared_ptr<Exposure>>(
        m, "Exposure", "The ink of moments while a shutter is open, averaged; see native/fovea/draw/exposure.h.")
        .def(py::init<>())
        .def("add", &Exposure::add, NoGil(), py::arg("moment"), py::arg("weight"),
             "Draws the ink of a moment's Frame, with this weight above 0, and takes it out of the frame.")
        .def("again", &Exposure::again, NoGil(), py::arg("weight"), "Once more the moment that was added last.")
        .def_property_readonly("empty", &Exposure::empty);
}

void bind_ahead(py::module_& m) {
    py::class_<Ahead>(m, "Ahead",
                      "Computes what frames of a style will need of surfaces, on other threads, while others are read. "
                      "As a context: at its end what is not done is left.")
        .def(py::init<const style::Style&, std::shared_ptr<Cancel>>(), py::arg("style"), py::arg("cancel"),
             "cancel: a Cancel, or None")
        .def(
            "add", [](Ahead& ahead, std::shared_ptr<Surface> surface) { ahead.add(std::move(surface)); },
            py::arg("surface"), "A surface that is not changed before the end.")
        .def("__enter__", [](py::object self) { return self; })
        .def("__exit__", [](Ahead& ahead, const py::args&) { without_gil([&] { ahead.finish(); }); });
}

void bind_parts(py::module_& m) {
    bind_record<Options>(m, "Options",
                         "Numbers of the method that are not the style's; see native/fovea/draw/options.h.");
    m.attr("VISIBILITY") = choices<Visibility>();
    m.def("murmur_hash", &murmur_hash, py::arg("name"), "Cryptomatte's hash of a name.");
    m.def("cryptomatte_id", &cryptomatte_id, py::arg("name"), "Bits of the float that stands for a name in mattes.");
    py::class_<Assets, std::shared_ptr<Assets>>(m, "Assets", "Pen textures and papers that ship, by name.")
        .def(py::init<std::filesystem::path>(), py::arg("folder"));
    py::class_<ColorSources>(m, "ColorSources", "Where the colors of a scene come from.")
        .def(py::init([](SceneColor surfaces, std::vector<Light> lights, const vec3& world) {
                 return ColorSources{std::move(surfaces), std::move(lights), world};
             }),
             py::arg("surfaces"), py::arg("lights"), py::arg("world"),
             "surfaces: a SurfaceColor or None per placement; world: radiance of the sky.");
    bind_overrides(m);
    m.def(
        "content_of",
        [](const Scene& scene, const View& view, const OwningOverrides& told) {
            return without_gil([&] { return content_of(scene, view, told.overrides); });
        },
        py::arg("scene"), py::arg("view"), py::arg("overrides"),
        "Hash of what the lines of a frame depend on, beside its style, options and backend.");
}

using FrameClass = py::class_<Frame, std::shared_ptr<Frame>>;

void bind_steps(FrameClass& frame) {
    frame
        .def(
            py::init(&make_frame), py::arg("scene"), py::arg("view"), py::arg("style"), py::kw_only(),
            py::arg("options") = Options(), py::arg("assets") = nullptr, py::arg("backend") = nullptr,
            py::arg("overrides") = nullptr, py::arg("colors") = nullptr, py::arg("near") = Near(),
            py::arg("since_key") = 0, py::arg("baked_marks") = py::none(), py::arg("poses") = Poses(),
            py::arg("exposure") = nullptr, py::arg("files") = GivenFiles(), py::arg("cancel") = nullptr,
            py::arg("progress") = py::none(), py::keep_alive<1, 7>(), py::keep_alive<1, 8>(),
            R"(near: {how many frames later another is: its NearLines}; since_key: how many frames earlier the last key of marks
is (Animation.since_key); baked_marks: (n,) float64 of its own lines, in place of those handed on; poses: of the frames before and after, {-1: Pose, 1: Pose}, either of which may be
missing, for line vectors; exposure: an Exposure, whose ink is drawn in place of
the frame's own; files: {path as the style has it: FileContent}, others are missing; progress(share, stage) is called before each stage.)")
        .def("find", &Frame::find, NoGil())
        .def("see", &Frame::see, NoGil())
        .def("filter", &Frame::filter, NoGil())
        .def("thin", &Frame::thin, NoGil())
        .def("shape", &Frame::shape, NoGil())
        .def("ink", &Frame::ink, NoGil())
        .def("picture", &Frame::picture, NoGil())
        .def("passes", &passes,
             "{name: pixels, or None}, of line_sets {name of the set: pixels}, of mattes [pixels]; they are handed "
             "over, "
             "once.")
        .def("answers", &Frame::answers, "Whether lines answer to frames near this one.")
        .def(
            "found_lines", [](Frame& frame) { return mutable_pointer(frame.found_lines()); }, NoGil())
        .def("take_over", &Frame::take_over, NoGil(), py::arg("same"),
             "Takes over the FoundLines of a Frame of the same content (content_of), style, options and backend.")
        .def(
            "focus_of_pixels",
            [](Frame& frame) {
                Array<float> pixels = without_gil([&] { return frame.focus_of_pixels(); });
                return image(pixels, frame.job.view);
            },
            "(H, W) float32 in [0, 1] of what each pixel shows; None: all is in focus.")
        .def("object_at", &object_at, py::arg("px"), py::arg("radius"),
             "Name of the object that a disc of the picture shows most of, around a place (x, y) in pixels from the "
             "lower left; empty: none.")
        .def(
            "strokes_with",
            [](const Frame& frame, const Arg<float>& shown) {
                const In<float> opacity = borrow<float>(shown, "shown");
                return without_gil([&] { return std::make_shared<Strokes>(frame.strokes_with(opacity)); });
            },
            py::arg("shown"), "Strokes of which elision leaves (samples,) so much.")
        .def(
            "seen_beside",
            [](const Frame& frame, double offset_px) {
                check(frame.clipped != nullptr, "frame: its lines are not found yet");
                return seen_beside(*frame.clipped, *frame.paths, *frame.tracer, offset_px, frame.cancel());
            },
            NoGil(), py::arg("offset_px"),
            "(samples,) uint8: exactly seen so many pixels to the left of the line; see "
            "native/fovea/visibility/exact.h.")
        .def("polylines", &polylines_of, NoGil(), py::arg("drawn") = false,
             "Polylines of what pens draw, without haloes and overshoot; takes the steps up to `thin`. drawn: as "
             "strokes have it, with these, and with what is seen in frames near by; up to `shape`.")
        .def("layouts", &Frame::depth_layouts, py::arg("most_side"), py::arg("overlap_px") = 0,
             "DepthLayouts in at most so many texels along each axis; cores are looked out of by so many pixels.");
}

void bind_members(FrameClass& frame) {
    frame.def_property_readonly("focus_function", [](Frame& frame) { return frame.focus_function(); })
        .def_property_readonly("scene", [](const Frame& f) { return mutable_pointer(f.job.scene); })
        .def_property_readonly("view", [](const Frame& f) { return f.job.view; })
        .def_property_readonly("options", [](const Frame& f) { return f.job.options; })
        .def_property_readonly("cancel", [](const Frame& f) { return mutable_pointer(f.job.cancel); })
        .def_property_readonly("paths", [](const Frame& f) { return mutable_pointer(f.paths); })
        .def_property_readonly("clipped", [](const Frame& f) { return mutable_pointer(f.clipped); })
        .def_property_readonly("visible", [](const Frame& f) { return mutable_pointer(f.visible); })
        .def_property_readonly("runs", [](const Frame& f) { return mutable_pointer(f.runs); })
        .def_property_readonly(
            "drawn", [](const Frame& f) { return mutable_pointer(f.drawn); }, "Runs with haloes and overshoot")
        .def_property_readonly("strokes", [](const Frame& f) { return mutable_pointer(f.strokes); })
        .def_property_readonly("pens", [](const Frame& f) { return f.pens.pens; })
        .def_property_readonly("textures", [](const Frame& f) { return f.pens.textures; })
        .def_property_readonly("samples", member(&Frame::samples), "(samples,) float32 visibility, or None")
        .def_property_readonly("focus", member(&Frame::focus), "(samples,) float32 in [0, 1], 0: in focus; or None")
        .def_property_readonly("distance", member(&Frame::distance), "(samples,) float32 in [0, 1], 0: near; or None")
        .def_property_readonly("shown", member(&Frame::shown), "(samples,) float32 that elision leaves; or None")
        .def_property_readonly("visibility_in_words", &Frame::visibility_in_words)
        .def_property_readonly(
            "stages", [](const Frame& f) { return value_to(f.stages); },
            "{stage: milliseconds}, in the order in which they ran");
}

}  // namespace

void bind_draw(py::module_& m) {
    FrameClass frame(m, "Frame",
                     "One picture on its way: each step takes those before it; see native/fovea/draw/frame.h.");
    bind_found_lines(m);
    bind_exposure(m);
    bind_ahead(m);
    bind_backend(m);
    bind_parts(m);
    bind_steps(frame);
    bind_members(frame);
}

}  // namespace fovea::bindings
