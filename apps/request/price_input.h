#pragma once
// Lines that somebody else drew or planned, with the field and the machine to price them for.

#include <memory>
#include <string>
#include <vector>

#include "request/field_input.h"
#include "request/plan_request.h"
#include "tramline/planner/price/given_lines.h"

namespace tramline::app {

/// The options as typed; empty where the user gave none.
struct LinesOptions {
  std::string file, layer, where;
  /// Lines that are there already; `file` is what messages call them, and none is read.
  std::shared_ptr<const RawDataset> in_memory{};
};

struct PriceInput {
  Field field;
  Machine machine;
  Objective objective;
  PlanSettings settings;  ///< of the plan to compare with
  GivenLines lines;       ///< in the field's metres
  std::vector<Skipped> skipped;
};

/// Reads the lines and the field. A plan file gives what is not typed: the field, the machine, the prices and
/// the clearance; its tracks and headland passes keep their exact paths. With a layer named it is read like
/// any vector file. Throws kBadInput for faults of the files, as read_lines() does, where no field or no
/// width is given, and for the plan of a repair.
PriceInput price_input(const LinesOptions& lines, const FieldOptions& field, const PlanOptions& plan);

}  // namespace tramline::app
