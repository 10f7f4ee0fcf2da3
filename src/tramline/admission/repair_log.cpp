#include "tramline/admission/repair_log.h"

#include <fmt/format.h>

namespace tramline {

std::string shown_coordinates(Point input, const Crs& crs) {
  return crs.in_degrees() ? fmt::format("({:.7f}, {:.7f})", input.x, input.y)
                          : fmt::format("({:.2f}, {:.2f})", input.x, input.y);
}

void RepairLog::repair(std::string what, std::string where, Point local, double area_change_m2) {
  repair_at_input(std::move(what), std::move(where), input_of(local), area_change_m2);
}

void RepairLog::repair_at_input(std::string what, std::string where, Point input, double area_change_m2) {
  repairs_.push_back({std::move(what), std::move(where), input, area_change_m2});
}

Point RepairLog::input_of(Point local) const {
  const Point input = projection_->to_input(local);
  return {input.x + prefix_m_, input.y};
}

std::string RepairLog::shown(Point local) const {
  return shown_coordinates(input_of(local), projection_->crs());
}

}  // namespace tramline
