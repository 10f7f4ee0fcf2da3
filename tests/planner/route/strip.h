#pragma once
// A field that is five times as long as wide, for machines that can hardly turn on it.

#include "tramline/model/field.h"
#include "tramline/model/machine.h"

namespace tramline::testing {

/// 40 m by 200 m, towards the north.
inline Field strip_field() {
  Field out;
  out.id = "strip";
  out.outer = {{0, 0}, {40, 0}, {40, 200}, {0, 200}};
  return out;
}

inline Machine strip_machine() {
  Machine out;
  out.width_m = 6;
  out.radius_m = 6;
  return out;
}

}  // namespace tramline::testing
