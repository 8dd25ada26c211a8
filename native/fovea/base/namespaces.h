// SPDX-License-Identifier: GPL-3.0-or-later
// One namespace per folder, in the order of the data flow; each sees the names of those before it. Those of `style` are
// written style::Pen, because `stroke` has a Pen of its own.
#pragma once

namespace fovea {

namespace base {}
namespace raster {
using namespace base;
}
namespace mesh {
using namespace raster;
}
namespace field {
using namespace mesh;
}
namespace scene {
using namespace field;
}
namespace repair {
using namespace scene;
}
namespace cutout {
using namespace repair;
}
namespace image {
using namespace cutout;
}
namespace line {
using namespace image;
}
namespace style {
using namespace line;
}
namespace path {
using namespace line;
}
namespace project {
using namespace path;
}
namespace visibility {
using namespace project;
}
namespace runs {
using namespace visibility;
}
namespace focus {
using namespace runs;
}
namespace elision {
using namespace focus;
}
namespace stroke {
using namespace elision;
}
namespace color {
using namespace stroke;
}
namespace draw {
using namespace color;
}
namespace vector {
using namespace draw;
}

}  // namespace fovea
