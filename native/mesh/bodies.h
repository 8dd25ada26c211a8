// Which parts of a surface are solid: of these, only what faces the viewer can be seen or hide first.
#pragma once

#include "mesh/surface.h"

namespace fovea {

/// A body is a part of a surface, joined over edges, that is closed: two facets at each of its edges, which agree about
/// the side that is out; that faces outwards (the volume inside is positive); and that hides what lies behind with all
/// of its facets.
struct Bodies {
    Array<std::uint8_t> of_facet;  ///< per facet: 1 where it bounds a body
    bool all = false;              ///< every facet does, and there is one
};

/// Kept with the surface.
std::shared_ptr<const Bodies> bodies(const Surface& surface);

}  // namespace fovea
