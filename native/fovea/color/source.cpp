// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/color/source.h>

#include <fovea/base/check.h>

namespace fovea::color {

void check_color(const SurfaceColor& color, const Surface& surface) {
    const auto fits = [&](const auto& values, const char* what) {
        check(values.size() == surface.corner_count(), surface.name() + ": one " + what + " per corner expected");
    };
    if (!color.normals.empty()) fits(color.normals, "normal");
    for (const auto& uv : color.uvs) fits(uv, "uv");
    for (const auto& attribute : color.attributes) fits(attribute, "color");
    for (const ColorSlot& slot : color.slots) {
        check(slot.uv == none || slot.uv < color.uvs.size(), surface.name() + ": a slot must name uvs that are given");
        check(slot.attribute == none || slot.attribute < color.attributes.size(),
              surface.name() + ": a slot must name an attribute that is given");
        check(slot.opacity >= 0.0f && slot.opacity <= 1.0f,
              surface.name() + ": the opacity of a slot must be between 0 and 1");
    }
}

}  // namespace fovea::color
