#include "tramline/check/rules/land_faults.h"

#include <fmt/format.h>

#include "tramline/check/measure/plan_facts.h"

namespace tramline::check {

void report_land(Rule rule, const Region& wrong, double tolerance_m2, const std::string& what,
                 Violations& out) {
  if (const double amount = area(wrong); amount > tolerance_m2)
    out.push_back({rule, fmt::format(fmt::runtime(what), amount), point_on_largest(wrong), amount});
}

}  // namespace tramline::check
