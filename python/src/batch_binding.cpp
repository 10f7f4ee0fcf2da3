#include "batch_binding.h"

#include <pybind11/functional.h>
#include <pybind11/stl.h>
#include <tbb/task_arena.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "batch/batch.h"
#include "options/batch_options.h"
#include "options/common_options.h"
#include "options/option_parser.h"
#include "report/report_parts.h"

namespace py = pybind11;

namespace tramline::python {
namespace {

/// A batch as the words of `tramline batch` ask for it, with the number of threads.
struct BatchObject {
  app::Batch batch;
  int threads = 0;
};

std::unique_ptr<BatchObject> opened(const std::vector<std::string>& words) {
  app::OptionParser parser("batch");
  app::BatchRequest request;
  bool resume = false;
  int threads = 0;
  app::add_batch_options(parser.command(), request, resume);
  app::add_threads_option(parser.command(), threads);
  parser.parse(words);
  app::take_batch_defaults(parser.command(), request);
  const auto start = resume ? app::BatchFolder::Start::kResume : app::BatchFolder::Start::kAnew;
  return std::unique_ptr<BatchObject>(new BatchObject{{std::move(request), start}, threads});
}

std::pair<std::size_t, std::size_t> work_on(BatchObject& object, long long chunk) {
  const int threads = object.threads > 0 ? object.threads : tbb::task_arena::automatic;
  app::ChunkCounts counts;
  tbb::task_arena(threads).execute([&] { counts = object.batch.work_on(chunk); });
  return {counts.planned, counts.refused};
}

}  // namespace

void declare_batch(py::module_& module) {
  using Unlocked = py::call_guard<py::gil_scoped_release>;
  py::class_<BatchObject>(module, "Batch")
      .def(py::init(&opened), Unlocked())
      .def_property_readonly("fields", [](const BatchObject& object) { return object.batch.fields(); })
      .def_property_readonly("chunks", [](const BatchObject& object) { return object.batch.chunks(); })
      .def_readonly("threads", &BatchObject::threads)
      .def("missing", [](const BatchObject& object) { return object.batch.missing(); })
      .def("fields_in",
           [](const BatchObject& object, long long chunk) { return object.batch.fields_in(chunk); })
      .def("work_on", &work_on, Unlocked())
      .def(
          "finish",
          [](const BatchObject& object) { return app::json_line(app::versioned(object.batch.finish())); },
          Unlocked());
}

}  // namespace tramline::python
