#include "tramline/headland/ceded_to_tracks.h"

#include <algorithm>
#include <cmath>

#include "tramline/geometry/polygon/boolean.h"
#include "tramline/geometry/polygon/significant_vertices.h"

namespace tramline {
namespace {

/// Whether two corners are at least so far apart.
bool extends_over(const Polygon& polygon, double length_m) {
  const Box box = bounds(polygon);
  if (box.empty() || std::hypot(box.width(), box.height()) < length_m) return false;
  if (std::max(box.width(), box.height()) >= length_m) return true;
  const Ring& ring = polygon.outer;
  for (std::size_t i = 0; i < ring.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (distance(ring[i], ring[j]) >= length_m) return true;
  return false;
}

/// Strips that tracks are laid in: as wide as a swath, or, at the price of some overlap, narrower and longer.
struct Strip {
  double width_m = 0;
  double least_length_m = 0;
};

/// Strips of just the width and length asked for are accepted in spite of chords and grids.
constexpr double kAlmost = 0.999;

double perimeter_m(const Polygon& polygon) {
  double out = perimeter(polygon.outer);
  for (const Ring& hole : polygon.holes) out += perimeter(hole);
  return out;
}

/// Whether the polygon is large and long enough for a track; neither is any part of one that is not. Its
/// edges may lie `off_m` beside the true ones.
bool may_hold_a_track(const Polygon& polygon, const Strip& strip, double off_m = 0) {
  const double largest_m2 = area(polygon) + off_m * perimeter_m(polygon);
  if (largest_m2 < kAlmost * kAlmost * strip.width_m * strip.least_length_m) return false;
  return extends_over(polygon, kAlmost * strip.least_length_m - 2 * off_m);
}

bool holds_a_track(const Polygon& polygon, const Strip& strip) {
  if (!may_hold_a_track(polygon, strip)) return false;
  // Vertices beside chords, which the grid leaves where two regions share an edge, can cost the polygon
  // engine a thousand times what it takes without them.
  const Polygon outline = simplified(polygon, (1 - kAlmost) * 0.25 * strip.width_m);
  return !buffered({outline}, -kAlmost * 0.5 * strip.width_m, JoinStyle::kMitre).empty();
}

void keep_tracks(Region& region, const Strip& strip) {
  std::erase_if(region, [&](const Polygon& part) { return !holds_a_track(part, strip); });
}

/// Whether some part of the polygon may hold a track; the grid moves edges of a part.
bool may_have_a_part_for(const Polygon& polygon, const Strip& strip, double off_m = 0) {
  constexpr double kMore = 0.99;
  return may_hold_a_track(polygon, {kMore * strip.width_m, kMore * strip.least_length_m}, off_m);
}

Region with_parts_for(const Region& region, const Strip& strip) {
  Region out;
  for (const Polygon& polygon : region)
    if (may_have_a_part_for(polygon, strip)) out.push_back(polygon);
  return out;
}

/// Chords of arcs that tell whether it is worth while to look closer, as a share of the width.
constexpr double kRoughSagitta_share = 0.01;

/// Whether a part of the ground that no pass works is large and long enough for one of the strips, on a look
/// with long chords: exact areas of that ground cost many times as much, and mostly it is what corners leave.
bool may_cede(const Headland& headland, double width_m, const std::vector<Strip>& strips) {
  const double sagitta_m = kRoughSagitta_share * width_m;
  const Region roughly = unworked_ground(headland, width_m, sagitta_m);
  return std::any_of(roughly.begin(), roughly.end(), [&](const Polygon& part) {
    return std::any_of(strips.begin(), strips.end(),
                       [&](const Strip& strip) { return may_have_a_part_for(part, strip, sagitta_m); });
  });
}

/// The region without parts narrower than the width; corners stay.
Region opened(const Region& region, double width_m) {
  constexpr double kOpened = 0.998;
  const double half = kOpened * 0.5 * width_m;
  return buffered(buffered(region, -half, JoinStyle::kMitre), half, JoinStyle::kMitre);
}

Strip wide_strip(double width_m, double least_length_m) { return {width_m, least_length_m}; }
Strip narrow_strip(double width_m, double least_length_m) {
  return {width_m * kNarrowestStrip, least_length_m * kNarrowStripLength};
}

}  // namespace

Region without_room_for_tracks(const Region& region, double width_m, double least_length_m) {
  Region out = region;
  std::erase_if(out, [&](const Polygon& part) {
    return holds_a_track(part, wide_strip(width_m, least_length_m)) ||
           holds_a_track(part, narrow_strip(width_m, least_length_m));
  });
  return out;
}

Region ceded_to_tracks(const HeadlandAndBody& headland, const ClearLand& clear, double width_m,
                       double least_length_m) {
  const Strip wide = wide_strip(width_m, least_length_m), narrow = narrow_strip(width_m, least_length_m);
  if (headland.uncovered_m2 <
      0.99 * std::min(wide.width_m * wide.least_length_m, narrow.width_m * narrow.least_length_m))
    return {};
  if (!may_cede(headland, width_m, {wide, narrow})) return {};
  const Region unworked = unworked_ground(headland, width_m);
  Region out;
  for (const Strip& strip : {wide, narrow}) {
    const Region hopeful = with_parts_for(unworked, strip);
    if (hopeful.empty()) continue;
    Region parts =
        intersection(hopeful, strip.width_m < width_m ? clear.for_track_sides : clear.for_track_ends);
    keep_tracks(parts, strip);
    if (parts.empty()) continue;
    parts = intersection(opened(unite(headland.body, parts), strip.width_m), parts);
    keep_tracks(parts, strip);
    out = unite(out, parts);
  }
  return out;
}

}  // namespace tramline
