#include "server/work/work_frame.h"

#include <cmath>

namespace tramline::server {

double remaining_s(const WorkFigures& figures) {
  if (!figures.has_field || !(figures.present_m2_per_s > 0)) return std::nan("");
  return figures.areas.missed_m2 / figures.present_m2_per_s;
}

std::vector<Point> thinned(const std::vector<Point>& way, double apart_m) {
  std::vector<Point> out;
  for (std::size_t i = 0; i < way.size(); ++i)
    if (out.empty() || i + 1 == way.size() || length(way[i] - out.back()) >= apart_m) out.push_back(way[i]);
  return out;
}

std::vector<Point> way_of(const std::vector<DrivenLine>& lines) {
  std::vector<Point> out;
  for (const DrivenLine& line : lines) out.insert(out.end(), line.line.begin(), line.line.end());
  return out;
}

}  // namespace tramline::server
