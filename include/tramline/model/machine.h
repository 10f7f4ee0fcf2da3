#pragma once

#include <string>

namespace tramline {

/// Lengths in metres. width_m is the working width w, radius_m the least turning radius r.
struct Machine {
  std::string name;
  double width_m = 3;
  double radius_m = 6;
  double min_length_m = -1;  ///< shortest piece worth driving; negative: the default, 2 w (Versleijen §2.2.1)
};

inline double min_length_m(const Machine& machine) {
  return machine.min_length_m >= 0 ? machine.min_length_m : 2 * machine.width_m;
}

}  // namespace tramline
