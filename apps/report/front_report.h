#pragma once
// The report of `compare` on a front, and the additions of `plan --front`.

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tramline/model/front.h"
#include "tramline/model/plan.h"

namespace tramline::app {

/// The comparison to report.
struct Comparison {
  const Field& field;
  const Machine& machine;
  const PlanSettings& settings;
  const Front& front;
  const std::vector<Objective>& asked;  ///< further prices whose winners are wanted
  double seconds = 0;
  bool cut_short = false;  ///< whether the searches were ended early
};

/// The keys of docs/json.md.
nlohmann::ordered_json compare_json(const Comparison& comparison, const std::vector<Skipped>& skipped);

/// One object for each point.
nlohmann::ordered_json front_json(const Front& front);

/// For people: a row for each point that stands apart (points_to_show()), then one for each of the prices
/// asked for.
std::string compare_table(const Comparison& comparison, const std::vector<Skipped>& skipped);

/// A header, then a line for each point; commas, and full stops in numbers. Lists within a cell are separated
/// by semicolons.
std::string front_csv(const Front& front);

}  // namespace tramline::app
