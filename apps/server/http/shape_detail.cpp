#include "server/http/shape_detail.h"

#include <fmt/format.h>

#include <cmath>

#include "tramline/geometry/error.h"

namespace tramline::server {

double detail_in(const Call& call, double coarsest_m) {
  const double out = call.query_number("detail_m");
  if (std::isnan(out)) return 0;
  if (!(out >= 0 && out <= coarsest_m))
    throw bad_input(fmt::format("detail_m has to be between 0 and {:g}, not {:g}", coarsest_m, out));
  return out;
}

}  // namespace tramline::server
