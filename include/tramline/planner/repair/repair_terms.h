#pragma once

#include "tramline/model/machine.h"
#include "tramline/model/plan.h"

namespace tramline {

/// The machine, prices and end rule of a repair.
struct RepairTerms {
  Machine machine;
  Objective objective;
  EndRule end_rule = EndRule::kCheapest;
};

}  // namespace tramline
