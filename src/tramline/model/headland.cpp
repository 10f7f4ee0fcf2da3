#include "tramline/model/headland.h"

namespace tramline {

bool is_closed(const HeadlandPass& pass) {
  constexpr double kJoint_m = 1e-6;
  return distance(pass.path.back().to, pass.path.front().from) < kJoint_m;
}

Polygon swath(const HeadlandPass& pass, double width_m, double sagitta_m) {
  if (is_closed(pass)) return closed_band(pass.path, width_m, sagitta_m);
  return {band(pass.path, width_m, sagitta_m), {}};
}

double length(const Headland& headland) {
  double sum = 0;
  for (const HeadlandPass& pass : headland.passes) sum += length(pass.path);
  return sum;
}

}  // namespace tramline
