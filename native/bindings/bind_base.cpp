// SPDX-License-Identifier: GPL-3.0-or-later
// Threads, cancellation, and hashes.
#include <fovea/base/hash.h>
#include <fovea/base/parallel.h>
#include <fovea/base/release_memory.h>
#include <fovea/base/threads.h>

#include "bindings/arrays.h"
#include "bindings/bind.h"

namespace fovea::bindings {
namespace {

/// A context of Python in which a Cancel is polled.
struct Scope {
    std::shared_ptr<const Cancel> cancel;
    Cancelling polled;

    explicit Scope(std::shared_ptr<const Cancel> of) : cancel(std::move(of)), polled(cancel.get()) {}
};

thread_local std::vector<std::unique_ptr<Scope>> scopes;  // the innermost last

}  // namespace

void bind_base(py::module_& m) {
    py::class_<Cancel, std::shared_ptr<Cancel>>(m, "Cancel",
                                                "A flag that long calls poll; cancel() makes them raise Cancelled. "
                                                "As a context: calls in it, by the same thread, poll it.")
        .def(py::init<>())
        .def("cancel", [](Cancel& cancel) { cancel.requested = true; })
        .def_property_readonly("requested", [](const Cancel& cancel) { return cancel.requested.load(); })
        .def("__enter__",
             [](std::shared_ptr<Cancel> cancel) {
                 scopes.push_back(std::make_unique<Scope>(cancel));
                 return cancel;
             })
        .def("__exit__", [](const Cancel&, const py::args&) { scopes.pop_back(); });
    py::register_exception<Cancelled>(m, "Cancelled", PyExc_RuntimeError);
    m.def("limit_threads", &limit_threads, py::arg("most"),
          "Most threads that work at once from now on; 0: as many as the machine has. Results never depend on it.");
    m.def("release_memory", &release_large_memory,
          "Returns memory that is kept for the arrays of the next pictures to the system, or to Blender's heap.");
    m.def(
        "content_hash",
        [](const py::array& array) {
            check(array.flags() & py::array::c_style, "content_hash: a contiguous array is needed");
            const auto size = static_cast<std::size_t>(array.nbytes());
            return without_gil([data = array.data(), size] { return hash_many_bytes(data, size); });
        },
        py::arg("array"), "64-bit hash of an array's bytes.");
}

}  // namespace fovea::bindings
