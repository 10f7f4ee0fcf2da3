#pragma once
// Keywords of Python as the options of the program's commands: what is asked for, as values of the library.

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "options/compare_options.h"
#include "options/option_parser.h"
#include "options/price_options.h"
#include "request/asked_plans.h"
#include "request/drive_request.h"
#include "request/field_input.h"
#include "request/given_land.h"
#include "request/plan_request.h"
#include "request/price_input.h"
#include "tramline/model/raw_feature.h"

namespace tramline::python {

/// Features in memory; nullptr: the words name a file.
using Features = std::shared_ptr<const RawDataset>;
/// "--width=6"
using Words = std::vector<std::string>;

/// What a plan is asked for with, but for its field.
struct PlanRequest {
  app::FieldOptions field;
  app::PlanOptions plan;
  app::LandOptions land;
  std::optional<double> seconds;
  int threads = 0;
};

/// What `tramline plan` would plan for these words. Throws kBadInput.
PlanRequest plan_request(const Words& words, const Features& features);
/// What `tramline compare` would compare: the plans of tracks alone for one machine, or the whole plans for
/// several. Throws kBadInput.
struct CompareRequest {
  app::CompareOptions options;
  std::optional<app::AskedComparison> plans;  ///< for one machine
  std::optional<app::AskedMachines> machines;
  std::optional<double> seconds;
  int threads = 0;
};
CompareRequest compare_request(const Words& words, const Features& features);

struct PriceRequest {
  app::PriceOptions options;
  std::optional<double> seconds;
  int threads = 0;
};
PriceRequest price_request(const Words& words, const Features& features, const Features& lines);

struct EvaluateRequest {
  std::string log_file;  ///< empty: the drive of a plan
  app::FieldOptions field;
  app::DriveOptions drive;
  std::optional<std::size_t> job;
  int threads = 0;
};
EvaluateRequest evaluate_request(const Words& words, const Features& features);

/// The file of the field that a plan was made from, of `tramline check`.
app::FieldOptions check_request(const Words& words, const Features& features);

/// The options of a command: "plan", "compare", "price", "evaluate" or "check".
std::vector<app::OptionText> options_of(const std::string& command);

}  // namespace tramline::python
