#include "tramline/cost/worked/worked_ground.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

namespace tramline {
namespace {

Box box_in(const Box& window, const TrackFrame& from, const TrackFrame& to) {
  Box out;
  for (const double x : {window.min_x, window.max_x})
    for (const double y : {window.min_y, window.max_y}) out.extend(to.to_track(from.to_field({x, y})));
  return out;
}

bool follows_curve(const TrackFamily& family) {
  return !family.tracks.empty() && !is_straight(family.tracks.front());
}

/// Indices of the tracks whose swaths, or whose detours, can reach into the window; of curved ones all.
/// Precondition: one track for each strip from the first on.
StripRange tracks_near(const TrackFamily& family, const Box& window, double bulge_m) {
  if (family.tracks.empty()) return {};
  if (follows_curve(family)) return {0, static_cast<int>(family.tracks.size()) - 1};
  const StripGrid& grid = family.grid;
  const int lowest = family.tracks.front().index, highest = family.tracks.back().index;
  const double first = std::floor((window.min_x - bulge_m - grid.origin_m) / grid.width_m);
  const double last = std::floor((window.max_x + bulge_m - grid.origin_m) / grid.width_m);
  return {static_cast<int>(std::clamp<double>(first, lowest, highest + 1.0)) - lowest,
          static_cast<int>(std::clamp<double>(last, lowest - 1.0, highest)) - lowest};
}

Ring corners(const Box& box) {
  return {{box.min_x, box.min_y}, {box.max_x, box.min_y}, {box.max_x, box.max_y}, {box.min_x, box.max_y}};
}

/// Borders of worked land along a line between two strips within the window: it begins (+1) or ends (−1).
/// Where swaths of both strips touch the line is no border: most lines through the window are left out.
void append_border(const Intervals& left, const Intervals& right, double x, const Box& window,
                   RisingCurves& out) {
  auto before = left.begin(), after = right.begin();
  double y = window.min_y;
  while (y < window.max_y) {
    while (before != left.end() && before->to <= y) ++before;
    while (after != right.end() && after->to <= y) ++after;
    const bool ends = before != left.end() && before->from <= y;
    const bool begins = after != right.end() && after->from <= y;
    double next = window.max_y;
    if (before != left.end()) next = std::min(next, ends ? before->to : before->from);
    if (after != right.end()) next = std::min(next, begins ? after->to : after->from);
    if (ends != begins) out.push_back({{x, y}, {x, next}, 0, Layer::kCovered, begins ? 1 : -1});
    y = next;
  }
}

bool meets_any(const Box& box, const std::vector<Box>& others) {
  return std::any_of(others.begin(), others.end(), [&](const Box& other) { return intersects(box, other); });
}

enum class Parts { kOnTrack, kAll };

WorkedGround ground_worked(const std::vector<TrackFamily>& families, const std::vector<LaidTracks>& tracks,
                           Parts parts) {
  assert(families.size() == tracks.size());
  WorkedGround ground(families);
  for (std::size_t i = 0; i < tracks.size(); ++i) {
    std::vector<TrackWork> works(families[i].tracks.size());
    for (const LaidPiece& piece : tracks[i].pieces) {
      TrackWork& work = works[index_in_family(families[i], piece)];
      for (const Interval& part : parts_on_track(piece)) work.on_track.push_back(part);
      if (parts == Parts::kAll)
        work.detours.insert(work.detours.end(), piece.detours.begin(), piece.detours.end());
    }
    for (std::size_t k = 0; k < works.size(); ++k) ground.set(i, k, std::move(works[k]));
  }
  return ground;
}

}  // namespace

WorkedGround::WorkedGround(const std::vector<TrackFamily>& families) {
  for (const TrackFamily& family : families) {
    assert(follows_curve(family) || family.tracks.empty() ||
           family.tracks.back().index - family.tracks.front().index + 1 == std::ssize(family.tracks));
    families_.push_back({family, std::vector<Worked>(family.tracks.size()), 0});
  }
}

void WorkedGround::set(std::size_t family, std::size_t track, TrackWork work) {
  Family& owner = families_[family];
  const StripGrid& grid = owner.tracks.grid;
  const Track& of = owner.tracks.tracks[track];
  Worked worked{std::move(work), {}};
  for (const TrackDetour& detour : worked.work.detours)
    worked.reach.push_back(reach_of(detour.path, grid.width_m));
  if (follows_curve(owner.tracks)) {
    for (const Interval& part : worked.work.on_track) {
      const Path path = path_along(of, part.from, part.to);
      const std::vector<Box> reaches = reaches_of(path, grid.width_m);
      for (std::size_t i = 0; i < path.size(); ++i) {
        worked.along.push_back({path[i], reaches[i]});
        worked.whole.extend(reaches[i]);
      }
    }
  } else {
    const double left = grid.line(of.index), right = grid.line(of.index + 1);
    for (const Box& reach : worked.reach)
      owner.bulge_m = std::max({owner.bulge_m, left - reach.min_x, reach.max_x - right});
  }
  owner.worked[track] = std::move(worked);
}

const TrackWork& WorkedGround::at(std::size_t family, std::size_t track) const {
  return families_[family].worked[track].work;
}

void WorkedGround::append_covered(std::size_t family, const Box& window, const std::vector<Box>& boxes,
                                  std::optional<std::size_t> except, RisingCurves& out) const {
  const Family& home = families_[family];
  append_detours(home, window, boxes, except, out);
  if (follows_curve(home.tracks))
    append_along(home, window, except, out);
  else
    append_rows(home, window, except, out);
  for (std::size_t other = 0; other < families_.size(); ++other)
    if (other != family) append_foreign(families_[other], home, window, out);
}

bool WorkedGround::is_alone(std::size_t family, const Box& box, std::size_t track) const {
  if (families_.size() > 1) return false;
  const Family& own = families_[family];
  const StripRange near = tracks_near(own.tracks, box, own.bulge_m);
  for (int k = near.first; k <= near.last; ++k) {
    const auto index = static_cast<std::size_t>(k);
    if (index != track && meets_any(box, own.worked[index].reach)) return false;
  }
  return true;
}

void WorkedGround::append_detours(const Family& from, const Box& window, const std::vector<Box>& boxes,
                                  std::optional<std::size_t> except, RisingCurves& out) {
  const StripRange near = tracks_near(from.tracks, window, from.bulge_m);
  for (int k = near.first; k <= near.last; ++k) {
    const auto index = static_cast<std::size_t>(k);
    if (except && *except == index) continue;
    const Worked& track = from.worked[index];
    for (std::size_t i = 0; i < track.reach.size(); ++i)
      if (meets_any(track.reach[i], boxes))
        append_band(track.work.detours[i].path, from.tracks.grid.width_m, Layer::kCovered, out);
  }
}

void WorkedGround::append_rows(const Family& from, const Box& window, std::optional<std::size_t> except,
                               RisingCurves& out) {
  if (from.worked.empty()) return;
  const StripRange near = tracks_near(from.tracks, window, from.bulge_m);
  const StripGrid& grid = from.tracks.grid;
  const int first_index = from.tracks.tracks.front().index;
  static const Intervals kNothing;
  const Intervals* left = &kNothing;
  for (int k = near.first; k <= near.last + 1; ++k) {
    const auto index = static_cast<std::size_t>(k);
    const double x = grid.line(first_index + k);
    const bool worked =
        k <= near.last && !(except && *except == index) && grid.line(first_index + k + 1) > window.min_x;
    const Intervals* right = worked ? &from.worked[index].work.on_track : &kNothing;
    if (x > window.max_x) break;
    append_border(*left, *right, x < window.min_x ? window.min_x - 1 : x, window, out);
    left = right;
  }
}

void WorkedGround::append_along(const Family& from, const Box& window, std::optional<std::size_t> except,
                                RisingCurves& out) {
  for (std::size_t k = 0; k < from.worked.size(); ++k) {
    const Worked& track = from.worked[k];
    if ((except && *except == k) || !intersects(track.whole, window)) continue;
    for (const Swath& swath : track.along)
      if (intersects(swath.reach, window))
        append_band({swath.line}, from.tracks.grid.width_m, Layer::kCovered, out);
  }
}

void WorkedGround::append_foreign(const Family& from, const Family& to, const Box& window,
                                  RisingCurves& out) {
  const TrackFrame &theirs = from.tracks.grid.frame, &ours = to.tracks.grid.frame;
  const double width_m = from.tracks.grid.width_m;
  const Box seen = box_in(window, ours, theirs);
  const auto move = [&](Point p) { return ours.to_track(theirs.to_field(p)); };
  const StripRange near = tracks_near(from.tracks, seen, from.bulge_m);
  for (int k = near.first; k <= near.last; ++k) {
    const auto index = static_cast<std::size_t>(k);
    const Worked& track = from.worked[index];
    if (!follows_curve(from.tracks))
      for (const Interval& part : track.work.on_track) {
        const Box box = swath_box(from.tracks.grid, from.tracks.tracks[index], part);
        if (!intersects(box, seen)) continue;
        Ring ring = corners(box);
        for (Point& p : ring) p = move(p);
        append_ring(ring, Layer::kCovered, window, out);
      }
    for (const Swath& swath : track.along)
      if (intersects(swath.reach, seen))
        append_band(moved({swath.line}, move), width_m, Layer::kCovered, out);
    for (std::size_t i = 0; i < track.reach.size(); ++i)
      if (intersects(track.reach[i], seen))
        append_band(moved(track.work.detours[i].path, move), width_m, Layer::kCovered, out);
  }
}

WorkedGround worked_on_tracks(const std::vector<TrackFamily>& families,
                              const std::vector<LaidTracks>& tracks) {
  return ground_worked(families, tracks, Parts::kOnTrack);
}

WorkedGround worked_by(const std::vector<TrackFamily>& families, const std::vector<LaidTracks>& tracks) {
  return ground_worked(families, tracks, Parts::kAll);
}

std::size_t index_in_family(const TrackFamily& family, const LaidPiece& piece) {
  // Strips follow one another without a gap.
  if (piece.path.empty() && !family.tracks.empty())
    return static_cast<std::size_t>(piece.track - family.tracks.front().index);
  const auto found = std::find_if(family.tracks.begin(), family.tracks.end(), [&piece](const Track& track) {
    return track.index == piece.track && track.branch == piece.branch;
  });
  return static_cast<std::size_t>(found - family.tracks.begin());
}

Box swath_box(const StripGrid& grid, const Track& track, const Interval& part) {
  if (is_straight(track)) return {grid.line(track.index), part.from, grid.line(track.index + 1), part.to};
  return reach_of(path_along(track, part.from, part.to), grid.width_m);
}

}  // namespace tramline
