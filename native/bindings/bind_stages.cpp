// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes, views, projection and exact visibility.
#include <pybind11/stl.h>

#include <fovea/project/project.h>
#include <fovea/runs/beside_visible.h>
#include <fovea/runs/invisibility.h>
#include <fovea/runs/short_hidden.h>
#include <fovea/scene/seen.h>
#include <fovea/visibility/beside.h>
#include <fovea/visibility/depth_image.h>
#include <fovea/visibility/exact.h>

#include "bindings/arrays.h"
#include "bindings/bind.h"

namespace fovea::bindings {
namespace {

using Matrix = py::array_t<double, py::array::c_style | py::array::forcecast>;

/// Row-major numpy matrix (acting on columns) to GLM's column-major one.
dmat4 matrix(const double* rows) {
    dmat4 result;
    for (int r = 0; r < 4; ++r)
        for (int c = 0; c < 4; ++c) result[c][r] = rows[4 * r + c];
    return result;
}

dmat4 matrix(const Matrix& array, const char* name) {
    check(array.ndim() == 2 && array.shape(0) == 4 && array.shape(1) == 4,
          std::string(name) + ": expected shape (4, 4)");
    return matrix(array.data());
}

std::shared_ptr<Scene> make_scene(const std::vector<std::shared_ptr<Surface>>& surfaces,
                                  const Arg<int>& surface_of_placement, const Matrix& object_to_world,
                                  const Arg<std::uint64_t>& ids, const Arg<std::uint8_t>& usage) {
    const auto count = static_cast<std::size_t>(surface_of_placement.size());
    check(object_to_world.ndim() == 3 && std::size_t(object_to_world.shape(0)) == count &&
              object_to_world.shape(1) == 4 && object_to_world.shape(2) == 4,
          "object_to_world: expected shape (n, 4, 4)");
    check(std::size_t(ids.size()) == count && std::size_t(usage.size()) == count, "ids and usage: expected shape (n,)");
    for (const auto& surface : surfaces) check(surface != nullptr, "surfaces: None is no surface");
    std::vector<Placement> placements(count);
    for (std::size_t i = 0; i < count; ++i) {
        const int surface = surface_of_placement.data()[i];
        check(surface >= 0 && std::size_t(surface) < surfaces.size(),
              "surface_of_placement names a surface that does not exist");
        placements[i] = {surfaces[surface], matrix(object_to_world.data() + 16 * i), ids.data()[i], usage.data()[i]};
    }
    return std::make_shared<Scene>(std::move(placements));
}

View make_view(const Matrix& world_to_view, const Matrix& view_to_clip, int width, int height, bool orthographic,
               double near_clip, double far_clip, double reference_scale,
               const std::optional<std::array<double, 4>>& frame) {
    check(width > 0 && height > 0, "view: the image has no pixels");
    check(near_clip > 0.0 || orthographic, "view: the near clip distance must be positive");
    check(far_clip > near_clip, "view: the far clip distance must lie beyond the near one");
    return {matrix(world_to_view, "world_to_view"),
            matrix(view_to_clip, "view_to_clip"),
            width,
            height,
            orthographic,
            near_clip,
            far_clip,
            reference_scale,
            frame ? dvec4((*frame)[0], (*frame)[1], (*frame)[2], (*frame)[3]) : dvec4(0.0, 0.0, width, height)};
}

py::array view_matrix(const View& view) {
    const dmat4 rows = glm::transpose(view.world_to_view);
    return py::array_t<double>(std::vector<py::ssize_t>{4, 4}, &rows[0][0]);
}

py::array image(Array<float>&& values, const View& view) {
    if (values.empty()) return py::array_t<float>(std::vector<py::ssize_t>{0, 0});
    return to_numpy(std::move(values)).reshape({view.height, view.width});
}

void bind_scene(py::module_& m) {
    py::class_<View>(m, "View", "A camera and its image; see addon/stages.py.")
        .def(py::init(&make_view), py::arg("world_to_view"), py::arg("view_to_clip"), py::arg("width"),
             py::arg("height"), py::arg("orthographic"), py::arg("near_clip"), py::arg("far_clip"),
             py::arg("reference_scale") = 1.0, py::arg("frame") = py::none())
        .def_property_readonly(
            "world_to_view", [](const View& view) { return view_matrix(view); }, "(4, 4) float64")
        .def_property_readonly(
            "frame",
            [](const View& view) { return py::make_tuple(view.frame.x, view.frame.y, view.frame.z, view.frame.w); })
        .def_readonly("width", &View::width)
        .def_readonly("height", &View::height)
        .def_readonly("orthographic", &View::orthographic)
        .def_readonly("near_clip", &View::near_clip)
        .def_readonly("far_clip", &View::far_clip)
        .def_readonly("reference_scale", &View::reference_scale)
        .def("smaller", &smaller, py::arg("scale"), "The same in fewer pixels, as many as make a whole picture.");

    m.attr("DRAW") = int(usage_draw);
    m.attr("OCCLUDE") = int(usage_occlude);
    m.attr("HOLDOUT") = int(usage_holdout);
    py::class_<Scene, std::shared_ptr<Scene>>(m, "Scene", "Placements of surfaces: what one frame sees.")
        .def(
            py::init(&make_scene), py::arg("surfaces"), py::arg("surface_of_placement"), py::arg("object_to_world"),
            py::arg("ids"), py::arg("usage"),
            R"(surface_of_placement (n,) int32 into surfaces; object_to_world (n, 4, 4) float64; ids (n,) uint64 persistent ids;
usage (n,) uint8, bits DRAW, OCCLUDE, HOLDOUT.)")
        .def("__len__", [](const Scene& scene) { return scene.placements.size(); })
        .def("surface", [](const Scene& scene,
                           Index i) { return std::const_pointer_cast<Surface>(scene.placements.at(i).surface); })
        .def_property_readonly("usage",
                               [](const Scene& scene) {
                                   Array<std::uint8_t> usage;
                                   for (const Placement& placement : scene.placements) usage.push_back(placement.usage);
                                   return to_numpy(std::move(usage));
                               })
        .def_property_readonly("facet_base",
                               [](py::object self) { return view_numpy(self.cast<const Scene&>().facet_base, self); });

    py::class_<Tracer, std::shared_ptr<Tracer>>(m, "Tracer", "Rays through a scene as a view sees it (Embree).")
        .def(py::init([](const Scene& scene, const View& view) {
                 py::gil_scoped_release release;
                 return std::make_shared<Tracer>(scene, view);
             }),
             py::arg("scene"), py::arg("view"), py::keep_alive<1, 2>())
        .def_property_readonly("view", &Tracer::view, py::return_value_policy::reference_internal);
    m.def(
        "depth_image",
        [](const Tracer& tracer, const Cancel* cancel) {
            const Cancel never;
            Array<float> values;
            {
                py::gil_scoped_release release;
                values = depth_image(tracer, cancel ? *cancel : never);
            }
            return image(std::move(values), tracer.view());
        },
        py::arg("tracer"), py::arg("cancel") = py::none(),
        "(H, W) float32 distance along the view, 1e10 where nothing is seen.");
    m.def(
        "holdout_image",
        [](const Tracer& tracer, const Cancel* cancel) {
            const Cancel never;
            Array<float> values;
            {
                py::gil_scoped_release release;
                values = holdout_image(tracer, cancel ? *cancel : never);
            }
            return image(std::move(values), tracer.view());
        },
        py::arg("tracer"), py::arg("cancel") = py::none(),
        "(H, W) float32 share of each pixel that holdouts cut out; shape (0, 0) when there are none.");
}

}  // namespace

void bind_stages(py::module_& m) {
    bind_scene(m);
    py::class_<ClippedPaths, std::shared_ptr<ClippedPaths>> clipped_paths(
        m, "ClippedPaths",
        "Paths projected and clipped: Q pieces, M points; see native/fovea/project/clipped_paths.h.");
    clipped_paths
        .def_property_readonly(
            "offsets",
            [](py::object self) { return view_numpy(self.cast<const ClippedPaths&>().pieces.offsets, self); },
            "(Q + 1,) uint32: points of piece q")
        .def_readonly("samples", &ClippedPaths::samples, "size of the atlas")
        .def("__len__", [](const ClippedPaths& c) { return c.path.size(); });
    bind_columns(clipped_paths, ClippedPaths::piece_columns);
    bind_columns(clipped_paths, ClippedPaths::point_columns);

    m.def(
        "project",
        [](const Paths& paths, const Tracer& tracer, double sample_step_px, const std::vector<double>& least_length_px,
           const Cancel* cancel) {
            const Cancel never;
            ProjectOptions options;
            options.sample_step_px = sample_step_px;
            options.least_length_px = least_length_px;
            py::gil_scoped_release release;
            return std::make_shared<ClippedPaths>(
                project(paths, tracer.scene(), tracer.view(), options, cancel ? *cancel : never));
        },
        py::arg("paths"), py::arg("tracer"), py::arg("sample_step_px") = 2.0,
        py::arg("least_length_px") = std::vector<double>(), py::arg("cancel") = py::none(),
        R"(ClippedPaths of paths; sample_step_px: pixels between visibility samples; least_length_px: by line set, shorter
paths with an end that touches no other line are left out.)");

    py::class_<Runs, std::shared_ptr<Runs>> runs(
        m, "Runs", "Parts of pieces, sorted by piece, then by start; see native/fovea/visibility/runs.h.");
    runs.def("__len__", [](const Runs& runs) { return runs.piece.size(); });
    bind_columns(runs, Runs::columns);

    m.def(
        "exact_visibility",
        [](const ClippedPaths& clipped, const Paths& paths, const Tracer& tracer, const Cancel* cancel) {
            const Cancel never;
            py::gil_scoped_release release;
            return std::make_shared<Runs>(exact_visibility(clipped, paths, tracer, cancel ? *cancel : never));
        },
        py::arg("clipped"), py::arg("paths"), py::arg("tracer"), py::arg("cancel") = py::none(),
        "Visible runs by rays, changes found to 1/16 px.");
    m.def(
        "seen_beside",
        [](const ClippedPaths& clipped, const Paths& paths, const Tracer& tracer, double offset_px) {
            Array<std::uint8_t> seen;
            {
                py::gil_scoped_release release;
                seen = seen_beside(clipped, paths, tracer, offset_px, Cancel());
            }
            return to_numpy(std::move(seen));
        },
        py::arg("clipped"), py::arg("paths"), py::arg("tracer"), py::arg("offset_px"),
        "(samples,) uint8: exactly seen so many pixels to the left of the line; see native/fovea/visibility/beside.h.");
    m.def(
        "runs_from_samples",
        [](const ClippedPaths& clipped, const Arg<float>& visibility, float threshold) {
            return std::make_shared<Runs>(
                runs_from_samples(clipped, borrow<float>(visibility, "visibility"), threshold));
        },
        py::arg("clipped"), py::arg("visibility"), py::arg("threshold") = 0.5f,
        "Runs where the atlas samples (samples,) float32 are at least the threshold.");
    m.def(
        "samples_from_runs",
        [](const ClippedPaths& clipped, const Runs& runs) { return to_numpy(samples_from_runs(clipped, runs)); },
        py::arg("clipped"), py::arg("runs"), "(samples,) float32 share of each atlas sample that the runs cover.");
    m.def(
        "with_hidden",
        [](const ClippedPaths& clipped, const Runs& visible, const Paths& paths) {
            return std::make_shared<Runs>(with_hidden(clipped, visible, paths));
        },
        py::arg("clipped"), py::arg("visible"), py::arg("paths"),
        "Visible runs and what lies between them, of invisibility 1.");
    m.def(
        "count_invisibility",
        [](const ClippedPaths& clipped, const Paths& paths, const Tracer& tracer, const Runs& runs, Index levels,
           const Cancel* cancel) {
            const Cancel never;
            py::gil_scoped_release release;
            return std::make_shared<Runs>(
                count_invisibility(clipped, paths, tracer, runs, levels, cancel ? *cancel : never));
        },
        py::arg("clipped"), py::arg("paths"), py::arg("tracer"), py::arg("runs"), py::arg("levels"),
        py::arg("cancel") = py::none(),
        "Runs of with_hidden, the hidden ones split by how many surfaces hide them, told apart up to `levels`.");
    m.def(
        "without_beside_visible",
        [](const ClippedPaths& clipped, const Runs& runs, double near_px) {
            py::gil_scoped_release release;
            return std::make_shared<Runs>(without_beside_visible(clipped, runs, near_px));
        },
        py::arg("clipped"), py::arg("runs"), py::arg("near_px"),
        "Runs without the hidden parts that go along visible runs nearer than near_px.");
    m.def(
        "without_short_hidden",
        [](const ClippedPaths& clipped, const Runs& runs, const Arg<float>& least_px) {
            const In<float> least = borrow<float>(least_px, "least_px");
            py::gil_scoped_release release;
            return std::make_shared<Runs>(without_short_hidden(clipped, runs, least));
        },
        py::arg("clipped"), py::arg("runs"), py::arg("least_px"),
        "Runs without hidden stretches shorter than least_px, (P,) float32 per path of Paths; whole pieces stay.");
}

}  // namespace fovea::bindings
