#include "tramline/cost/part_rows.h"

namespace tramline {
namespace {

double at(const BoundaryPart& part, double along) {
  return part.from.x + (part.to.x - part.from.x) * ((along - part.from.y) / (part.to.y - part.from.y));
}

}  // namespace

void PartRows::list_places(std::span<const BoundaryPart> parts, double width_m,
                           std::span<const double> cuts) {
  places_.assign(cuts.begin(), cuts.end());
  for (const BoundaryPart& part : parts) {
    places_.push_back(part.from.y);
    places_.push_back(part.to.y);
    for (const double line : {0.0, width_m})
      if ((part.from.x < line) != (part.to.x < line))
        places_.push_back(part.from.y +
                          (part.to.y - part.from.y) * ((line - part.from.x) / (part.to.x - part.from.x)));
  }
  std::sort(places_.begin(), places_.end());
}

bool PartRows::right_inside(double along) const {
  const auto rightmost = std::max_element(
      active_.begin(), active_.end(),
      [&](const BoundaryPart* a, const BoundaryPart* b) { return at(*a, along) < at(*b, along); });
  return (*rightmost)->to.y < (*rightmost)->from.y;
}

double PartRows::inside_width(double along, double width_m, bool right) const {
  double sum = right ? width_m : 0;
  for (const BoundaryPart* part : active_)
    sum += (part->to.y > part->from.y ? 1 : -1) * std::clamp(at(*part, along), 0.0, width_m);
  return sum;
}

}  // namespace tramline
