#include "tramline/coverage/doubts.h"

#include <fmt/format.h>

#include <cmath>

namespace tramline::coverage {

std::vector<std::string> doubts_on(const CoverageAreas& areas, const MachineCounters& counters,
                                   double width_m) {
  std::vector<std::string> out;
  if (areas.repeated_m2 > kDoubtfulRepeat * areas.covered_m2)
    out.push_back(
        fmt::format("{:.0f} % of the covered land was worked again: check that the machine is {:g} m wide "
                    "and that the log is of one job",
                    100 * areas.repeated_m2 / areas.covered_m2, width_m));
  const double counted_m2 = counters.area_m2;
  if (counted_m2 > 0 && std::abs(areas.covered_m2 - counted_m2) > kDoubtfulCounter * counted_m2)
    out.push_back(
        fmt::format("the machine's own counter says {:.4f} ha and the covered land is {:.4f} ha ({:.4f} ha "
                    "including repeated land): check the width and when the work was on",
                    counted_m2 / 1e4, areas.covered_m2 / 1e4, areas.gross_m2 / 1e4));
  return out;
}

}  // namespace tramline::coverage
