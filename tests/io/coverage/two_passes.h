#pragma once
// An evaluation small enough to know by heart.

#include <limits>

#include "tramline/model/coverage.h"

namespace tramline {

inline Ring box_ring(double min_x, double min_y, double max_x, double max_y) {
  return {{min_x, min_y}, {max_x, min_y}, {max_x, max_y}, {min_x, max_y}};
}

/// A field [0, 40]², w = 20 m. The first pass goes up at x = 10 from y = 0 to 40, the second down at x = 26
/// from y = 45 to 0:
///
///   quads        20·40 + 20·45                    = 1700 m²
///   twice        [16, 20] × [0, 40]               =  160 m²
///   covered      1700 − 160                       = 1540 m²
///   outside      [16, 36] × [40, 45]              =  100 m²
///   inside       1540 − 100                       = 1440 m²
///   missed       [36, 40] × [0, 40] = 1600 − 1440 =  160 m²
///   once         1540 − 160                       = 1380 m²
inline Coverage two_passes() {
  Coverage out;
  out.log = "drive.csv";
  out.field_id = "square";
  out.field = {{box_ring(0, 0, 40, 40), {}}};
  out.frame = {true, 13, 52, 0, 0};
  out.width_m = 20;
  out.engine = "exact";
  out.areas = {1700, 1540, 1440, 100, 160, 0, 160, 0, {160, 1380, 160, 0}};
  out.covered = {{{{0, 0}, {36, 0}, {36, 45}, {16, 45}, {16, 40}, {0, 40}}, {}}};
  out.repeated = {{box_ring(16, 0, 20, 40), {}}};
  out.missed = {{box_ring(36, 0, 40, 40), {}}};
  out.worked_times[1] = {{box_ring(0, 0, 16, 40), {}},
                         {{{20, 0}, {36, 0}, {36, 45}, {16, 45}, {16, 40}, {20, 40}}, {}}};
  out.worked_times[2] = out.repeated;
  out.gaps = {{1, out.missed[0], 160, {38, 20}, 4}};
  out.lines = {{0, {{10, 0}, {10, 40}}, 100, 120},
               {-1, {{10, 40}, {18, 52}, {26, 45}}, 120, 131.5},
               {1, {{26, 45}, {26, 0}}, 131.5, 154}};
  out.fixes = 5;
  out.fixes_used = 4;
  out.runs = 2;
  out.worked_s = 42.5;
  out.skipped.add(3, "no position");
  out.warnings = {"the log has \"holes\""};
  return out;
}

}  // namespace tramline
