#include "server/drives/work_stream.h"

#include <fmt/format.h>

#include <cmath>

#include "tramline/geometry/error.h"

namespace tramline::server {

double detail_in(const Call& call) {
  constexpr double kCoarsest_m = 10;
  const double out = call.query_number("detail_m");
  if (std::isnan(out)) return 0;
  if (!(out >= 0 && out <= kCoarsest_m))
    throw bad_input(fmt::format("detail_m has to be between 0 and {:g}, not {:g}", kCoarsest_m, out));
  return out;
}

}  // namespace tramline::server
