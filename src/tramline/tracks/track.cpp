#include "tramline/tracks/track.h"

#include <algorithm>
#include <cassert>

#include "tramline/geometry/path/path_between.h"
#include "tramline/tracks/end_rule.h"
#include "tramline/tracks/tolerances.h"

namespace tramline {
namespace {

/// Calls `visit(from, to)` for the parts before and behind the beginning of a closed track.
template <class Visit>
void visit_parts(const Track& track, double from, double to, Visit visit) {
  const double length_m = track.length_m;
  if (!track.closed || to <= length_m) {
    visit(from, to);
  } else if (from >= length_m) {
    visit(from - length_m, to - length_m);
  } else {
    visit(from, length_m);
    visit(0, to - length_m);
  }
}

}  // namespace

double inside_between(const Track& track, double from, double to) {
  double sum = 0;
  visit_parts(track, from, to,
              [&](double start, double end) { sum += track.subfield.area_between(start, end); });
  return sum;
}

Path path_along(const Track& track, double from, double to) {
  assert(!is_straight(track));
  Path out;
  visit_parts(track, from, to, [&](double start, double end) {
    const Path part = path_between(track.path, start, end);
    out.insert(out.end(), part.begin(), part.end());
  });
  return out;
}

bool stops_at(const Track& track, double end, int sense) {
  constexpr double kLeastArea_m2 = 0.5 * kLookAhead_m * kWidthTolerance;
  const double at = track.closed && end > track.length_m ? end - track.length_m : end;
  const double beyond = at + sense * kLookAhead_m;
  return track.hard.area_between(std::min(at, beyond), std::max(at, beyond)) > kLeastArea_m2;
}

}  // namespace tramline
