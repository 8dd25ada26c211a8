// What a style asks for.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "line/registry.h"

namespace fovea {

/// One of a style's line sets: which definitions with which parameters, of what, and where paths split.
struct LineSet {
    struct Kind {
        Index definition;  ///< index into line_definitions()
        Values values;
    };
    std::vector<Kind> kinds;
    double corner_angle_rad = 1.0;
    std::vector<std::uint8_t> placements = {};  ///< of the scene, 1: its lines are for this set; empty: all are

    bool is_for(Index placement) const { return placements.empty() || placements[placement]; }

    bool has(Index definition) const {
        return std::any_of(kinds.begin(), kinds.end(), [&](const Kind& kind) { return kind.definition == definition; });
    }
};

/// Every definition that some line set asks for.
inline Kinds asked_of(const std::vector<LineSet>& sets) {
    Kinds asked = 0;
    for (const LineSet& set : sets)
        for (const LineSet::Kind& kind : set.kinds) asked |= Kinds(1) << kind.definition;
    return asked;
}

}  // namespace fovea
