// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/draw/focus_function.h>

#include <algorithm>

namespace fovea {
namespace {

/// Distance from what the scene shows of an object and of what it makes instances of; null where that is nothing.
std::shared_ptr<const SurfaceDistance> surface_of(const std::string& name, const Scene* scene, const View& view,
                                                  const std::vector<std::vector<std::string>>& objects) {
    Array<Index> placements;
    for (Index i = 0; i < objects.size(); ++i)
        if (std::ranges::find(objects[i], name) != objects[i].end()) placements.push_back(i);
    if (!scene || placements.empty()) return nullptr;
    return std::make_shared<SurfaceDistance>(*scene, view, placements);
}

}  // namespace

Focus focus_function(const style::Focus& focus, const Scene* scene, const View& view,
                     const std::vector<std::vector<std::string>>& objects) {
    const bool of_objects = focus.basis() == style::FocusBasis::surfaces;
    const bool in_scene = of_objects || focus.basis() == style::FocusBasis::scene;
    Focus made{in_scene ? FocusSpace::scene : FocusSpace::image, {}, focus.combine == style::Combine::sum};
    if (!focus.active()) return made;
    const dvec4& frame = view.frame;  // left, lower, width, height
    for (const style::FocusPlace& place : focus.points) {
        const double unit = in_scene ? 1.0 : frame.w;
        const dvec3 at = in_scene ? dvec3(view.world_to_view * dvec4(place.at, 1.0))
                                  : dvec3(frame.x + place.at.x * frame.z, frame.y + (1.0 - place.at.y) * frame.w, 0.0);
        made.points.push_back({vec3(at), float(place.near * unit), float(place.far * unit),
                               of_objects ? surface_of(place.object, scene, view, objects) : nullptr});
    }
    return made;
}

}  // namespace fovea
