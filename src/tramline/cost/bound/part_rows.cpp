#include "tramline/cost/bound/part_rows.h"

namespace tramline {

void PartRows::list_ends(std::span<const BoundaryPart> parts, double width_m, std::span<const double> cuts) {
  ends_.assign(cuts.begin(), cuts.end());
  for (const BoundaryPart& part : parts) {
    ends_.push_back(part.from.y);
    ends_.push_back(part.to.y);
    for (const double line : {0.0, width_m})
      if ((part.from.x < line) != (part.to.x < line))
        ends_.push_back(part.from.y +
                        (part.to.y - part.from.y) * ((line - part.from.x) / (part.to.x - part.from.x)));
  }
  std::sort(ends_.begin(), ends_.end());
}

PartRow PartRows::row_of_all(double from, double to, double width_m) const {
  const double middle = 0.5 * (from + to);
  const auto rightmost = std::max_element(
      active_.begin(), active_.end(),
      [&](const BoundaryPart* a, const BoundaryPart* b) { return x_at(*a, middle) < x_at(*b, middle); });
  const double right_of_all = rises(**rightmost) ? 0 : width_m;
  PartRow row{from, to, right_of_all, right_of_all, active_};
  for (const BoundaryPart* part : active_) {
    const int sense = rises(*part) ? 1 : -1;
    row.inside_from += sense * std::clamp(x_at(*part, from), 0.0, width_m);
    row.inside_to += sense * std::clamp(x_at(*part, to), 0.0, width_m);
  }
  return row;
}

}  // namespace tramline
