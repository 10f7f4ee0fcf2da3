#pragma once
// What a plan file says twice: noted while it is read, compared later.

#include <string>

#include "tramline/io/geopackage/rows.h"
#include "tramline/io/plan/read_plan.h"

namespace tramline::io {

/// "layer tracks, feature 12, length_m"
inline std::string place_in_file(const Row& row, const char* column) {
  return row.place().substr(row.place().find(": layer ") + 2) + ", " + column;
}

inline void derive(PlanFile& out, const Row& row, const char* column, double from_shape, Point at) {
  out.derived.push_back({place_in_file(row, column), row.number(column), from_shape, at});
}

}  // namespace tramline::io
