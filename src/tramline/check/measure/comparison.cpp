#include "tramline/check/measure/comparison.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "tramline/check/tolerances.h"

namespace tramline::check {
double rounding_of(double value) { return kRounding * std::max(1.0, std::abs(value)); }

void Comparison::number(const char* what, const char* unit, double stored, double found, double tolerance) {
  // Written so that a stored NaN is a violation too.
  if (std::abs(stored - found) <= tolerance) return;
  out_.push_back({Rule::kTally,
                  fmt::format("the plan says {} {:.6f}{}, {} amount to {:.6f}{}", what, stored, unit,
                              of_what_, found, unit),
                  at_, stored - found});
}

void Comparison::count(const char* what, int stored, int found) {
  if (stored == found) return;
  out_.push_back({Rule::kTally,
                  fmt::format("the plan counts {} {}, {} have {}", stored, what, of_what_, found), at_,
                  static_cast<double>(stored - found)});
}

}  // namespace tramline::check
