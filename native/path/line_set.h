// What a style asks for.
#pragma once

#include "line/registry.h"

namespace fovea {

/// One of a style's line sets: which definitions with which parameters, and where paths split.
struct LineSet {
    struct Kind {
        Index definition;  ///< index into line_definitions()
        Values values;
    };
    std::vector<Kind> kinds;
    double corner_angle_rad = 1.0;
};

/// Every definition that some line set asks for.
inline Kinds asked_of(const std::vector<LineSet>& sets) {
    Kinds asked = 0;
    for (const LineSet& set : sets)
        for (const LineSet::Kind& kind : set.kinds) asked |= Kinds(1) << kind.definition;
    return asked;
}

}  // namespace fovea
