// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/draw/pen_paints.h>

#include <algorithm>

namespace fovea::draw {
namespace {

/// A pen may keep the name of another source.
style::Paint paint_of(style::PaintSource source, const std::string& name) {
    style::Paint paint{source, name};
    if (!paint.is_named()) paint.name.clear();
    return paint;
}

/// The values of a paint along paths, found once. Empty if there is no such paint in the picture.
template <typename Key, typename T>
In<T> values_of(std::map<Key, Array<T>>& known, const Key& key, const std::map<style::Paint, std::vector<In<T>>>& given,
                const style::Paint& paint, const T& instead, const Paths& paths, const Scene& scene) {
    const auto painted = given.find(paint);
    if (!paint.any() || painted == given.end()) return {};
    const auto found = known.find(key);
    if (found != known.end()) return found->second;
    return known[key] = values_on_paths(paths, scene, painted->second, instead, painted_on(paint));
}

}  // namespace

PaintedOn painted_on(const style::Paint& paint) {
    switch (paint.source) {
        case style::PaintSource::material:
            return PaintedOn::materials;
        case style::PaintSource::object:
            return PaintedOn::surface;
        default:
            return PaintedOn::corners;
    }
}

PenPaints::PenPaints(const std::vector<Pen>& pens, const Paths& paths, const Scene& scene, const Overrides& overrides) {
    const auto number = [&](style::PaintSource source, const std::string& name) {
        const style::Paint paint = paint_of(source, name);
        return values_of(numbers_, paint, overrides.painted, paint, 1.0f, paths, scene);
    };
    for (const Pen& pen : pens) {
        const style::Pen& look = pen.look;
        const style::Paint color = paint_of(look.paint_color, look.paint_color_name);
        const Color own{look.color.x, look.color.y, look.color.z};
        of_pens_.push_back(
            {number(look.paint_width, look.paint_width_name), number(look.paint_opacity, look.paint_opacity_name),
             values_of(colors_, {color, own}, overrides.painted_colors, color, vec3(look.color), paths, scene)});
    }
    if (std::ranges::none_of(of_pens_, &PenPaint::any)) of_pens_.clear();
}

}  // namespace fovea::draw
