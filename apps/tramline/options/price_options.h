#pragma once
// The options of `price`, which the Python package has in common with the program.

#include "options/command_options.h"
#include "request/field_input.h"
#include "request/plan_request.h"
#include "request/price_input.h"

namespace tramline::app {

struct PriceOptions {
  LinesOptions lines;
  FieldOptions field;
  PlanOptions plan;
  bool compare = false;  ///< plan the field as well
};

/// Declares all but those of output and run. Those of the plan of --compare alone need --compare.
void add_price_options(CommandOptions& command, PriceOptions& options);

}  // namespace tramline::app
