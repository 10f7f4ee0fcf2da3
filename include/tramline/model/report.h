#pragma once
// What the user has to be told: nothing is silently changed or dropped.

#include <string>

#include "tramline/geometry/point.h"

namespace tramline {

/// One repair of the input made by admission.
struct Repair {
  std::string what;   ///< one sentence: "hole 2 reached outside the field; the outside part was removed"
  std::string where;  ///< place in the input: "outer ring, vertex 14" or "hole 2"
  Point at;           ///< in the input's own coordinates
  double area_change_m2 = 0;  ///< change of the field's workable area (field minus obstacles)
};

/// Something of the input that was not used, and why.
struct Skipped {
  std::string what;
  std::string where;
  std::string why;
};

}  // namespace tramline
