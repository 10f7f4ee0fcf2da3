#include "tramline/avoidance/track_options.h"

#include <algorithm>

namespace tramline {
namespace {

/// Stretches up to this many times the least length are valued exactly: their piece may be dropped.
constexpr double kShort = 2;

Box box_round(const std::vector<Box>& boxes) {
  Box out;
  for (const Box& box : boxes) out.extend(box);
  return out;
}

/// What a shape of one strip covers alone.
class Valuer {
 public:
  Valuer(const BlockedTrack& track, const TrackFamily& family, const std::vector<Ring>& body,
         const WorkedGround& ground)
      : track_(track), family_(family), body_(body), ground_(ground) {}

  double of_detour(const TrackOption& option) const {
    RisingCurves curves = surroundings(box_round(option.reaches), option.reaches);
    append_band(option.way.detour.path, family_.grid.width_m, Layer::kNew, curves);
    return new_area(curves);
  }

  double of_straight(const Interval& part) const {
    const Box box = straight_box(family_.grid, strip().index, part);
    if (ground_.straight_alone(track_.subfield, box, strip().index))
      return strip().subfield.area_between(part.from, part.to);
    RisingCurves curves = surroundings(box, {box});
    append_box(box, Layer::kNew, box, curves);
    return new_area(curves);
  }

  /// Straight parts of the strip within a range.
  double of_stretches(const Interval& range) const {
    double sum = 0;
    for (const Interval& part : common(strip().stretches, {range})) sum += of_straight(part);
    return sum;
  }

  double profile_of(const Interval& range) const {
    double sum = 0;
    for (const Interval& part : common(strip().stretches, {range}))
      sum += strip().subfield.area_between(part.from, part.to);
    return sum;
  }

 private:
  const Track& strip() const { return family_.tracks[track_.strip]; }

  RisingCurves surroundings(const Box& window, const std::vector<Box>& boxes) const {
    RisingCurves out;
    for (const Ring& ring : body_) append_ring(ring, Layer::kBody, window, out);
    ground_.append_taken(track_.subfield, window, boxes, strip().index, out);
    return out;
  }

  const BlockedTrack& track_;
  const TrackFamily& family_;
  const std::vector<Ring>& body_;
  const WorkedGround& ground_;
};

bool is_short(const Interval& stretch, double min_length_m) {
  return stretch.length() < kShort * min_length_m;
}

}  // namespace

std::vector<std::size_t> hard_gaps(const Track& strip) {
  std::vector<std::size_t> out;
  for (std::size_t gap = 1; gap < strip.stretches.size(); ++gap)
    if (!common(strip.by_hard, {{strip.stretches[gap - 1].to, strip.stretches[gap].from}}).empty())
      out.push_back(gap);
  return out;
}

TrackOption option_of(WayRound way, const StripGrid& grid, int strip) {
  TrackOption out;
  out.reaches = reaches_of(way.detour.path, grid.width_m);
  out.straight = {way.detour.from, way.detour.to};
  out.reach = box_round(out.reaches);
  out.reach.extend(straight_box(grid, strip, out.straight));
  out.way = std::move(way);
  return out;
}

void value_options(BlockedTrack& track, const TrackFamily& family, const std::vector<Ring>& body,
                   const WorkedGround& ground, double min_length_m) {
  if (!track.stale) return;
  const Valuer valuer(track, family, body, ground);
  for (TrackOption& option : track.options) {
    if (!option.stale) continue;
    option.useful_m2 = valuer.of_detour(option);
    option.replaced_m2 = valuer.of_stretches(option.straight);
    option.profile_m2 = valuer.profile_of(option.straight);
    option.stale = false;
  }
  const Intervals& stretches = family.tracks[track.strip].stretches;
  track.correction_m2.assign(stretches.size(), 0);
  for (std::size_t i = 0; i < stretches.size(); ++i)
    if (is_short(stretches[i], min_length_m))
      track.correction_m2[i] = valuer.of_straight(stretches[i]) - valuer.profile_of(stretches[i]);
  track.stale = false;
}

void mark_stale(BlockedTrack& track, const TrackFamily& family, const Box& changed) {
  const int strip = family.tracks[track.strip].index;
  for (TrackOption& option : track.options)
    if (intersects(option.reach, changed)) option.stale = track.stale = true;
  for (const Interval& stretch : family.tracks[track.strip].stretches)
    if (intersects(straight_box(family.grid, strip, stretch), changed)) track.stale = true;
}

void mark_all_stale(BlockedTrack& track) {
  track.stale = true;
  for (TrackOption& option : track.options) option.stale = true;
}

}  // namespace tramline
