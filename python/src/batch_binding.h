#pragma once
// Batches, for tramline.batch.

#include <pybind11/pybind11.h>

namespace tramline::python {

void declare_batch(pybind11::module_& module);

}  // namespace tramline::python
