// SPDX-License-Identifier: GPL-3.0-or-later
// Views, scenes and ray casting.
#include <glm/gtc/type_ptr.hpp>

#include <fovea/color/light.h>
#include <fovea/draw/along_lines.h>
#include <fovea/path/extract.h>
#include <fovea/scene/pose.h>
#include <fovea/scene/tracer.h>

#include "bindings/arrays.h"
#include "bindings/bind.h"
#include "bindings/records.h"

namespace fovea::bindings {
namespace {

using Matrix = py::array_t<double, py::array::c_style | py::array::forcecast>;

/// Row-major numpy matrix (acting on columns) to GLM's column-major one.
dmat4 matrix(const double* rows) { return glm::transpose(glm::make_mat4(rows)); }

dmat4 matrix(const Matrix& array, const char* name) {
    check(array.ndim() == 2 && array.shape(0) == 4 && array.shape(1) == 4,
          std::string(name) + ": expected shape (4, 4)");
    return matrix(array.data());
}

std::shared_ptr<Scene> make_scene(const std::vector<std::shared_ptr<Surface>>& surfaces,
                                  const Arg<int>& surface_of_placement, const Matrix& object_to_world,
                                  const Arg<std::uint64_t>& ids, const Arg<std::uint8_t>& usage,
                                  const std::optional<Arg<std::uint64_t>>& groups, const std::optional<dvec4>& section,
                                  std::vector<Light> lights) {
    const auto count = static_cast<std::size_t>(surface_of_placement.size());
    check(object_to_world.ndim() == 3 && std::size_t(object_to_world.shape(0)) == count &&
              object_to_world.shape(1) == 4 && object_to_world.shape(2) == 4,
          "object_to_world: expected shape (n, 4, 4)");
    check(std::size_t(ids.size()) == count && std::size_t(usage.size()) == count, "ids and usage: expected shape (n,)");
    check(!groups || std::size_t(groups->size()) == count, "groups: expected shape (n,)");
    for (const auto& surface : surfaces) check(surface != nullptr, "surfaces: None is no surface");
    std::vector<Placement> placements(count);
    for (std::size_t i = 0; i < count; ++i) {
        const int surface = surface_of_placement.data()[i];
        check(surface >= 0 && std::size_t(surface) < surfaces.size(),
              "surface_of_placement names a surface that does not exist");
        placements[i] = {surfaces[surface], matrix(object_to_world.data() + 16 * i), ids.data()[i], usage.data()[i],
                         groups ? groups->data()[i] : 0};
    }
    auto scene = std::make_shared<Scene>(std::move(placements));
    if (section) {
        const double length = glm::length(dvec3(*section));
        check(std::isfinite(length + section->w) && length > 0.0, "section: expected a plane with a normal");
        scene->section = *section / length;
    }
    scene->lights = std::move(lights);
    return scene;
}

Light make_light(const py::str& kind, const dvec3& position, const dvec3& direction, const vec3& color, float cos_outer,
                 float cos_inner, const dvec3& half_x, const dvec3& half_y, bool casts, std::uint64_t id,
                 double radius) {
    return {value_from<Light::Kind>(kind, "light: kind"),
            position,
            direction,
            color,
            cos_outer,
            cos_inner,
            {half_x, half_y},
            casts,
            radius,
            id};
}

View make_view(const Matrix& world_to_view, const Matrix& view_to_clip, int width, int height, bool orthographic,
               double near_clip, double far_clip, double reference_scale, const std::optional<dvec4>& frame) {
    const View view{matrix(world_to_view, "world_to_view"),
                    matrix(view_to_clip, "view_to_clip"),
                    width,
                    height,
                    orthographic,
                    near_clip,
                    far_clip,
                    reference_scale,
                    frame.value_or(dvec4(0.0, 0.0, width, height))};
    check_view(view);
    return view;
}

/// Paths of {definition: {parameter: value}}.
Paths paths_of(const Tracer& tracer, const std::map<std::string, std::map<std::string, double>>& kinds,
               double corner_angle) {
    style::Style style;
    style.line_sets[0].corner_angle = corner_angle;
    for (const auto& [name, given] : kinds) style.line_sets[0].kinds.push_back({name, {given.begin(), given.end()}});
    return extract_paths(tracer.scene(), tracer.view(), line_sets_of(style, {}), tracer, Cancel());
}

void bind_view(py::module_& m) {
    py::class_<View>(m, "View", "A camera and its image; see addon/stages.py.")
        .def(py::init(&make_view), py::arg("world_to_view"), py::arg("view_to_clip"), py::arg("width"),
             py::arg("height"), py::arg("orthographic"), py::arg("near_clip"), py::arg("far_clip"),
             py::arg("reference_scale") = 1.0, py::arg("frame") = py::none(),
             "frame: left, lower, width and height of the camera's full frame in pixels; None: the image.")
        .def_property_readonly(
            "world_to_view",
            [](const View& view) -> py::array {
                const dmat4 rows = glm::transpose(view.world_to_view);
                return py::array_t<double>({4, 4}, &rows[0][0]);
            },
            "(4, 4) float64")
        .def_readonly("frame", &View::frame, "left, lower, width and height of the camera's full frame in pixels")
        .def_readonly("width", &View::width)
        .def_readonly("height", &View::height)
        .def_readonly("orthographic", &View::orthographic)
        .def_readonly("near_clip", &View::near_clip)
        .def_readonly("far_clip", &View::far_clip)
        .def_readonly("reference_scale", &View::reference_scale)
        .def("smaller", &smaller, py::arg("scale"), "The same in fewer pixels, as many as make a whole picture.");
}

}  // namespace

void bind_scene(py::module_& m) {
    bind_view(m);
    py::enum_<Usage>(m, "Usage", "Bits: what a placement does in the drawing.", py::arithmetic())
        .value("DRAW", usage_draw, "its lines are drawn")
        .value("OCCLUDE", usage_occlude, "it hides what lies behind")
        .value("HOLDOUT", usage_holdout, "it cuts a hole where it is seen");
    py::class_<Light>(m, "Light", "A light; see native/fovea/scene/light.h.")
        .def(py::init(&make_light), py::arg("kind"), py::arg("position"), py::arg("direction"), py::arg("color"),
             py::arg("cos_outer") = -1.0f, py::arg("cos_inner") = -1.0f, py::arg("half_x") = dvec3(0.0),
             py::arg("half_y") = dvec3(0.0), py::arg("casts") = true, py::arg("id") = 0, py::arg("radius") = 0.0);
    py::class_<Scene, std::shared_ptr<Scene>>(m, "Scene", "Placements of surfaces: what one frame sees.")
        .def(
            py::init(&make_scene), py::arg("surfaces"), py::arg("surface_of_placement"), py::arg("object_to_world"),
            py::arg("ids"), py::arg("usage"), py::arg("groups") = py::none(), py::arg("section") = py::none(),
            py::arg("lights") = std::vector<Light>(),
            R"(surface_of_placement (n,) int32 into surfaces; object_to_world (n, 4, 4) float64; ids (n,) uint64 persistent ids;
usage (n,) uint8, bits of Usage; groups (n,) uint64: placements of the same one have one outline together, 0: of none. section: a plane
(x, y, z, w) in the world; where x, y and z times a point, plus w, is positive, all is cut away. lights: by which light
contours and cast shadows are found.)")
        .def("__len__", [](const Scene& scene) { return scene.placements.size(); })
        .def(
            "surface",
            [](const Scene& scene, Index placement) {
                return std::const_pointer_cast<Surface>(scene.placements.at(placement).surface);
            },
            py::arg("placement"));

    py::class_<Pose, std::shared_ptr<Pose>>(
        m, "Pose", "Where the surfaces of a scene are, as its view sees them; a copy, which outlives both.")
        .def(py::init([](const Scene& scene, const View& view) { return pose_of(scene, view); }), NoGil(),
             py::arg("scene"), py::arg("view"));

    py::class_<Tracer, std::shared_ptr<Tracer>>(m, "Tracer", "Rays through a scene as a view sees it (Embree).")
        .def(py::init<const Scene&, const View&>(), NoGil(), py::arg("scene"), py::arg("view"), py::keep_alive<1, 2>())
        .def(
            "extract_paths", &paths_of, NoGil(), py::arg("kinds"), py::arg("corner_angle") = 60.0,
            R"(Paths of what definitions find, {definition: {parameter: value}}; they end at corners sharper than so many
degrees.)");
}

}  // namespace fovea::bindings
