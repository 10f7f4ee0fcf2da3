#include "tramline/avoidance/choice/track_options.h"

#include <algorithm>
#include <iterator>
#include <tuple>
#include <utility>

namespace tramline {
namespace {

/// Stretches up to this many times the least length are valued exactly: their piece may be dropped.
constexpr double kShort = 2;

Box box_round(const std::vector<Box>& boxes) {
  Box out;
  for (const Box& box : boxes) out.extend(box);
  return out;
}

/// The area that a shape covers alone.
class Valuer {
 public:
  Valuer(const BlockedTrack& blocked, const TrackFamily& family, const std::vector<Ring>& body,
         const WorkedGround& ground)
      : blocked_(blocked),
        grid_(family.grid),
        track_(family.tracks[blocked.place]),
        body_(body),
        ground_(ground) {}

  double of_detour(const TrackOption& option) const {
    RisingCurves curves = surroundings(box_round(option.reaches), option.reaches);
    append_band(option.way.detour.path, grid_.width_m, Layer::kNew, curves);
    return newly_covered_area(curves);
  }

  /// The value of the parts that keep to the track.
  double of_part(const Interval& part) const {
    const Path path = is_straight(track_) ? Path{} : path_along(track_, part.from, part.to);
    if (!is_straight(track_) && path.empty()) return 0;
    const Box box = is_straight(track_) ? swath_box(grid_, track_, part) : reach_of(path, grid_.width_m);
    if (ground_.is_alone(blocked_.family, box, blocked_.place))
      return inside_between(track_, part.from, part.to);
    RisingCurves curves = surroundings(box, {box});
    if (is_straight(track_))
      append_box(box, Layer::kNew, box, curves);
    else
      append_band(path, grid_.width_m, Layer::kNew, curves);
    return newly_covered_area(curves);
  }

  /// The stretches in which the track may be driven within a range.
  double of_stretches(const Interval& range) const {
    double sum = 0;
    for (const Interval& part : common(track_.stretches, {range})) sum += of_part(part);
    return sum;
  }

  double profile_of(const Interval& range) const {
    double sum = 0;
    for (const Interval& part : common(track_.stretches, {range}))
      sum += inside_between(track_, part.from, part.to);
    return sum;
  }

 private:
  RisingCurves surroundings(const Box& window, const std::vector<Box>& boxes) const {
    RisingCurves out;
    for (const Ring& ring : body_) append_ring(ring, Layer::kBody, window, out);
    ground_.append_covered(blocked_.family, window, boxes, blocked_.place, out);
    return out;
  }

  const BlockedTrack& blocked_;
  const StripGrid& grid_;
  const Track& track_;
  const std::vector<Ring>& body_;
  const WorkedGround& ground_;
};

bool may_be_chosen(const TrackOption& option, WaysPast ways) {
  const bool own = option.by == Construction::kOwn;
  switch (ways) {
    case WaysPast::kOwn:
      return own && !option.far_too_expensive;
    case WaysPast::kPaper:
      return !own;
    case WaysPast::kBoth:
      break;
  }
  return own ? option.has_twin || !option.far_too_expensive : !option.has_twin;
}

/// By the gap they begin at; at the same gap ours first, in the order found.
bool comes_before(const TrackOption& a, const TrackOption& b) {
  return std::tuple(a.way.first_gap, a.by, a.found) < std::tuple(b.way.first_gap, b.by, b.found);
}

bool is_short(const Interval& stretch, double min_length_m) {
  return stretch.length() < kShort * min_length_m;
}

}  // namespace

std::vector<std::size_t> hard_gaps(const Track& track) {
  std::vector<std::size_t> out;
  for (std::size_t gap = 1; gap < track.stretches.size(); ++gap)
    if (!common(track.hard_stretches, {{track.stretches[gap - 1].to, track.stretches[gap].from}}).empty())
      out.push_back(gap);
  return out;
}

TrackOption option_of(WayRound way, const StripGrid& grid, const Track& track) {
  TrackOption out;
  out.reaches = reaches_of(way.detour.path, grid.width_m);
  out.replaced = {way.detour.from, way.detour.to};
  out.reach = box_round(out.reaches);
  out.reach.extend(swath_box(grid, track, out.replaced));
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
    option.replaced_m2 = valuer.of_stretches(option.replaced);
    option.profile_m2 = valuer.profile_of(option.replaced);
    option.stale = false;
  }
  const Intervals& stretches = family.tracks[track.place].stretches;
  track.correction_m2.assign(stretches.size(), 0);
  for (std::size_t i = 0; i < stretches.size(); ++i)
    if (is_short(stretches[i], min_length_m))
      track.correction_m2[i] = valuer.of_part(stretches[i]) - valuer.profile_of(stretches[i]);
  track.stale = false;
}

void allow(BlockedTrack& track, WaysPast ways) {
  std::vector<TrackOption> all = std::move(track.options);
  all.insert(all.end(), std::make_move_iterator(track.not_allowed.begin()),
             std::make_move_iterator(track.not_allowed.end()));
  std::sort(all.begin(), all.end(), comes_before);
  track.options.clear();
  track.not_allowed.clear();
  for (TrackOption& option : all) {
    const bool open = may_be_chosen(option, ways);
    if (open && option.stale) track.stale = true;
    (open ? track.options : track.not_allowed).push_back(std::move(option));
  }
}

void mark_stale(BlockedTrack& track, const TrackFamily& family, const Box& changed) {
  const Track& own = family.tracks[track.place];
  for (TrackOption& option : track.options)
    if (intersects(option.reach, changed)) option.stale = track.stale = true;
  for (TrackOption& option : track.not_allowed)
    if (intersects(option.reach, changed)) option.stale = true;
  for (const Interval& stretch : own.stretches)
    if (intersects(swath_box(family.grid, own, stretch), changed)) track.stale = true;
}

void mark_all_stale(BlockedTrack& track) {
  track.stale = true;
  for (std::vector<TrackOption>* options : {&track.options, &track.not_allowed})
    for (TrackOption& option : *options) option.stale = true;
}

}  // namespace tramline
