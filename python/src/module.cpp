// The module tramline._core: functions that release the interpreter's lock while they work.

#include <pybind11/functional.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "asked.h"
#include "batch_binding.h"
#include "features.h"
#include "interruptible.h"
#include "keywords_in.h"
#include "tramline/geometry/error.h"
#include "tramline/io/coverage/write_coverage.h"
#include "tramline/io/export/export_plan.h"
#include "tramline/io/plan/write_plan.h"
#include "tramline/render/coverage/draw_coverage.h"
#include "tramline/render/plan/draw_plan.h"
#include "work.h"

namespace py = pybind11;

namespace tramline::python {
namespace {

using Unlocked = py::call_guard<py::gil_scoped_release>;

void declare_errors(py::module_& module) {
  static py::exception<Error> input_error(module, "InputError", PyExc_ValueError);
  static py::exception<std::runtime_error> run_error(module, "RunError", PyExc_RuntimeError);
  // The name under which people know them.
  input_error.attr("__module__") = "tramline";
  run_error.attr("__module__") = "tramline";
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const Error& error) {
      const std::string text = with_keywords(error.what());
      PyErr_SetString(error.kind() == ErrorKind::kBadInput ? input_error.ptr() : run_error.ptr(),
                      text.c_str());
    }
  });
}

void declare_features(py::module_& module) {
  py::class_<RawDataset, std::shared_ptr<RawDataset>>(module, "Features");
  module.def("features", &features_of, py::arg("geometries"), py::arg("crs"), py::arg("name"), Unlocked());
}

void declare_plan(py::module_& module) {
  py::class_<PlanObject>(module, "Plan")
      .def_property_readonly("json", &json_of)
      .def_property_readonly("crs", &crs_of)
      .def_property_readonly("comparison", &comparison_of)
      .def_property_readonly("planned", &planned_beside)
      .def(
          "save",
          [](const PlanObject& object, const std::string& file) { io::write_plan(object.plan, file); },
          Unlocked())
      .def(
          "draw",
          [](const PlanObject& object, const std::string& file) { render::draw_plan(object.plan, file); },
          Unlocked());
  module.def(
      "plan",
      [](const Words& words, const std::shared_ptr<RawDataset>& features, const PyProgress& progress) {
        return interruptible(
            progress, [&](const Progress& told) { return planned(plan_request(words, features), told); });
      },
      py::arg("words"), py::arg("features") = nullptr, py::arg("progress") = nullptr);
  module.def(
      "require_plannable", [](const Words& words) { require_plannable(plan_request(words, nullptr)); },
      py::arg("words"), Unlocked());
  module.def("read", &read, py::arg("file"), py::arg("id") = "", Unlocked());
  module.def(
      "export_layer",
      [](const std::string& plan, const std::string& file, const std::string& layer, const std::string& crs) {
        io::export_plan({plan, file, crs, {layer}, 0});
      },
      Unlocked());
}

void declare_comparison(py::module_& module) {
  py::class_<ComparisonObject>(module, "Comparison")
      .def_readonly("json", &ComparisonObject::json)
      .def_readonly("csv", &ComparisonObject::csv)
      .def("plan", &plan_at, Unlocked());
  module.def(
      "compare",
      [](const Words& words, const std::shared_ptr<RawDataset>& features, const PyProgress& progress) {
        return interruptible(
            progress, [&](const Progress& told) { return compared(compare_request(words, features), told); });
      },
      py::arg("words"), py::arg("features") = nullptr, py::arg("progress") = nullptr);
}

void declare_evaluation(py::module_& module) {
  py::class_<EvaluationObject>(module, "Evaluation")
      .def_readonly("json", &EvaluationObject::json)
      .def(
          "save",
          [](const EvaluationObject& object, const std::string& file) {
            io::write_coverage(object.evaluation.coverage, file);
          },
          Unlocked())
      .def(
          "draw",
          [](const EvaluationObject& object, const std::string& file) {
            render::draw_coverage(object.evaluation.coverage, file);
          },
          Unlocked());
  module.def(
      "evaluate",
      [](const Words& words, const std::shared_ptr<RawDataset>& features, const PlanObject* plan,
         const std::string& plan_name) {
        const py::gil_scoped_release unlocked;
        return evaluated(evaluate_request(words, features),
                         plan == nullptr ? std::nullopt : std::optional<Plan>(plan->plan), plan_name);
      },
      py::arg("words"), py::arg("features") = nullptr, py::arg("plan") = nullptr, py::arg("plan_name") = "");
}

void declare_judgements(py::module_& module) {
  module.def(
      "check",
      [](const std::string& plan_file, const std::string& id, const Words& words,
         const std::shared_ptr<RawDataset>& features) {
        return checked(plan_file, id, check_request(words, features));
      },
      py::arg("plan_file"), py::arg("id"), py::arg("words"), py::arg("features") = nullptr, Unlocked());
  module.def(
      "price",
      [](const Words& words, const std::shared_ptr<RawDataset>& features,
         const std::shared_ptr<RawDataset>& lines, const PyProgress& progress) {
        return interruptible(progress, [&](const Progress& told) {
          return priced(price_request(words, features, lines), told);
        });
      },
      py::arg("words"), py::arg("features") = nullptr, py::arg("lines") = nullptr,
      py::arg("progress") = nullptr);
  module.def("options", [](const std::string& command) {
    std::vector<std::tuple<std::string, std::string, std::string>> out;
    for (const app::OptionText& option : options_of(command))
      out.emplace_back(option.name, option.takes, option.help);
    return out;
  });
}

}  // namespace

PYBIND11_MODULE(_core, module) {
  declare_errors(module);
  declare_features(module);
  declare_plan(module);
  declare_comparison(module);
  declare_evaluation(module);
  declare_judgements(module);
  declare_batch(module);
  module.attr("version") = TRAMLINE_VERSION;
}

}  // namespace tramline::python
