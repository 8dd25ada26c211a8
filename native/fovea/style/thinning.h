// SPDX-License-Identifier: GPL-3.0-or-later
// Settings of line elision (Cole 2009, 5.2.2).
#pragma once

#include <string>

#include <fovea/style/field.h>

namespace fovea::style {

/// Thins lines that run alongside each other closer than their pens' spacing, by priority.
struct Elision {
    bool enabled = false;
    double fade_from = 0.35;  ///< share of its band at which a line begins to show; opaque at 1
    double cut = 0.0;
    int frames = 0;
    double length = 1.0, kind = 0.5, strength = 0.25, depth = 0.25, object = 1.0, painted = 1.0;
    std::string priority_attribute;  ///< empty: no painted term
    std::string density_attribute;

    bool operator==(const Elision&) const = default;
    /// Whether any priority term has an effect.
    bool ranks() const {
        return length > 0 || kind > 0 || strength > 0 || depth > 0 || object > 0 ||
               (painted > 0 && !priority_attribute.empty());
    }

    static constexpr Domain room{0.0, 0.99, 0.99, Unit::share};
    static constexpr Domain weight = number(0.0, 10.0, 2.0);
    static constexpr const char* weights = "weights";
    static constexpr auto fields = each_of(
        Field{"enabled", &Elision::enabled, "Line Thinning",
              "Thin lines that go alongside each other nearer than the minimum distance of their pens"},
        Field{"fade_from", &Elision::fade_from, "Fade Threshold",
              "Share of the distance around it that a line must have for itself to show at all", room},
        Field{"cut", &Elision::cut, "Min Opacity", "Lines that are fainter are left out altogether", room},
        Field{"frames", &Elision::frames, "Temporal Smoothing",
              "Renders smooth how lines come and go over so many frames before and after each: a single one takes as "
              "many times as long, an animation little longer",
              number(0, 8, 8)},
        Field{"length", &Elision::length, "Length", "Of crowding lines, how far long ones stay before short ones",
              weight, weights},
        Field{"kind", &Elision::kind, "Line Type",
              "How far outlines stay before creases, and creases before smooth lines", weight, weights},
        Field{"strength", &Elision::strength, "Strength",
              "Of crowding lines, how far strong ones stay before weak ones", weight, weights},
        Field{"depth", &Elision::depth, "Depth", "Of crowding lines, how far near ones stay before far ones", weight,
              weights},
        Field{"object", &Elision::object, "Object", "Of crowding lines, how much the priority of their objects counts",
              weight, weights},
        Field{"painted", &Elision::painted, "Painted", "Of crowding lines, how much counts what is painted on meshes",
              weight, weights},
        Field{"priority_attribute", &Elision::priority_attribute, "Painted Priority",
              "Attribute of meshes: lines where it is white stay, half way where there is none",
              naming(Names::attribute)},
        Field{"density_attribute", &Elision::density_attribute, "Painted Density",
              "Attribute of meshes: lines are four times as dense where it is white, a quarter as dense where it is "
              "black",
              naming(Names::attribute)});
};

}  // namespace fovea::style
