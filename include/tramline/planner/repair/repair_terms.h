#pragma once

#include "tramline/model/machine.h"
#include "tramline/model/plan.h"

namespace tramline {

/// What repairs are laid for.
struct RepairTerms {
  Machine machine;
  Objective objective;
  EndRule end_rule = EndRule::kCheapest;
};

}  // namespace tramline
