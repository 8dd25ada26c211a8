// SPDX-License-Identifier: GPL-3.0-or-later
// Threads, and how to stop what they do.
#include <fovea/base/parallel.h>
#include <fovea/base/threads.h>

#include "bindings/bind.h"

namespace fovea::bindings {

namespace py = pybind11;

void bind_base(py::module_& m) {
    py::class_<Cancel, std::shared_ptr<Cancel>>(m, "Cancel",
                                                "A flag that long calls poll; cancel() makes them raise Cancelled.")
        .def(py::init<>())
        .def("cancel", [](Cancel& cancel) { cancel.requested = true; })
        .def_property_readonly("requested", [](const Cancel& cancel) { return cancel.requested.load(); });
    py::register_exception<Cancelled>(m, "Cancelled", PyExc_RuntimeError);
    m.def("limit_threads", &limit_threads, py::arg("most"),
          "Most threads that work at once from now on; 0: as many as the machine has. Results never depend on it.");
    m.def("thread_limit", &thread_limit, "The limit that holds.");
}

}  // namespace fovea::bindings
