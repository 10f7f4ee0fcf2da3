#pragma once

#include "tramline/model/plan.h"
#include "tramline/render/page/legend_content.h"

namespace tramline::render {

/// Has the legend of the plan a row with the symbol?
inline bool shows(const Plan& plan, Symbol symbol) {
  for (const LegendBlock& block : legend_of(plan))
    for (const LegendRow& row : block.rows)
      if (row.symbol == symbol) return true;
  return false;
}

}  // namespace tramline::render
