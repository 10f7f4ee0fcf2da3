#pragma once
// Reports to the user on changed and unused input: nothing is changed or dropped silently.

#include <string>

#include "tramline/geometry/point.h"

namespace tramline {

/// One repair of the input made by admission.
struct Repair {
  std::string what;   ///< one sentence: "hole 2 reached outside the field; the outside part was removed"
  std::string where;  ///< position in the input: "outer ring, vertex 14" or "hole 2"
  Point at;           ///< in the input's own coordinates
  double area_change_m2 = 0;  ///< change of the field's workable area (field minus obstacles)
};

/// A part of the input that was not used, and why.
struct Skipped {
  std::string what;
  std::string where;
  std::string why;
};

}  // namespace tramline
