#include "tramline/cost/worked_ground.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace tramline {
namespace {

Box box_in(const Box& window, const TrackFrame& from, const TrackFrame& to) {
  Box out;
  for (const double x : {window.min_x, window.max_x})
    for (const double y : {window.min_y, window.max_y}) out.extend(to.to_track(from.to_field({x, y})));
  return out;
}

/// TrackFamily whose swaths, or whose detours, can reach into the window.
StripRange strips_near(const StripGrid& grid, StripRange range, const Box& window, double bulge_m) {
  const double first = std::floor((window.min_x - bulge_m - grid.origin_m) / grid.width_m);
  const double last = std::floor((window.max_x + bulge_m - grid.origin_m) / grid.width_m);
  return {static_cast<int>(std::clamp<double>(first, range.first, range.last + 1.0)),
          static_cast<int>(std::clamp<double>(last, range.first - 1.0, range.last))};
}

Ring corners(const Box& box) {
  return {{box.min_x, box.min_y}, {box.max_x, box.min_y}, {box.max_x, box.max_y}, {box.min_x, box.max_y}};
}

/// What begins (+1) and ends (−1) at a line between two strips, within the window. Where swaths of both
/// touch there the line is no border: most lines that run through the window are left out.
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
    if (ends != begins) out.push_back({{x, y}, {x, next}, 0, Layer::kTaken, begins ? 1 : -1});
    y = next;
  }
}

bool meets_any(const Box& box, const std::vector<Box>& others) {
  return std::any_of(others.begin(), others.end(), [&](const Box& other) { return intersects(box, other); });
}

StripRange range_of(const LaidTracks& tracks) {
  StripRange range;
  if (tracks.pieces.empty()) return range;
  range = {tracks.pieces.front().track, tracks.pieces.front().track};
  for (const LaidPiece& piece : tracks.pieces)
    range = {std::min(range.first, piece.track), std::max(range.last, piece.track)};
  return range;
}

}  // namespace

void WorkedGround::add_subfield(const StripGrid& grid, StripRange range) {
  subfields_.push_back({grid, range, std::vector<Worked>(static_cast<std::size_t>(range.size())), 0});
}

void WorkedGround::set(std::size_t subfield, int strip, StripWork work) {
  assert(strip >= subfields_[subfield].range.first && strip <= subfields_[subfield].range.last);
  Subfield& owner = subfields_[subfield];
  Worked worked{std::move(work), {}};
  const double left = owner.grid.line(strip), right = owner.grid.line(strip + 1);
  for (const TrackDetour& detour : worked.work.detours) {
    worked.reach.push_back(detour_box(detour, owner.grid.width_m));
    owner.bulge_m =
        std::max({owner.bulge_m, left - worked.reach.back().min_x, worked.reach.back().max_x - right});
  }
  owner.strips[static_cast<std::size_t>(strip - owner.range.first)] = std::move(worked);
}

const StripWork& WorkedGround::at(std::size_t subfield, int strip) const {
  const Subfield& owner = subfields_[subfield];
  return owner.strips[static_cast<std::size_t>(strip - owner.range.first)].work;
}

void WorkedGround::append_taken(std::size_t subfield, const Box& window, const std::vector<Box>& boxes,
                                std::optional<int> except, RisingCurves& out) const {
  const Subfield& home = subfields_[subfield];
  append_own(home, window, boxes, except, out);
  for (std::size_t other = 0; other < subfields_.size(); ++other)
    if (other != subfield) append_foreign(subfields_[other], home, window, out);
}

bool WorkedGround::straight_alone(std::size_t subfield, const Box& box, int strip) const {
  if (subfields_.size() > 1) return false;
  const Subfield& own = subfields_[subfield];
  const StripRange near = strips_near(own.grid, own.range, box, own.bulge_m);
  for (int k = near.first; k <= near.last; ++k)
    if (k != strip && meets_any(box, own.strips[static_cast<std::size_t>(k - own.range.first)].reach))
      return false;
  return true;
}

void WorkedGround::append_own(const Subfield& from, const Box& window, const std::vector<Box>& boxes,
                              std::optional<int> except, RisingCurves& out) {
  const StripRange near = strips_near(from.grid, from.range, window, from.bulge_m);
  static const Intervals kNothing;
  const Intervals* left = &kNothing;
  for (int k = near.first; k <= near.last; ++k) {
    if (except && *except == k) continue;
    const Worked& strip = from.strips[static_cast<std::size_t>(k - from.range.first)];
    for (std::size_t i = 0; i < strip.reach.size(); ++i)
      if (meets_any(strip.reach[i], boxes))
        append_band(strip.work.detours[i].path, from.grid.width_m, Layer::kTaken, out);
  }
  for (int k = near.first; k <= near.last + 1; ++k) {
    const bool worked = k <= near.last && !(except && *except == k) && from.grid.line(k + 1) > window.min_x;
    const Intervals* right =
        worked ? &from.strips[static_cast<std::size_t>(k - from.range.first)].work.straight : &kNothing;
    const double x = from.grid.line(k);
    if (x > window.max_x) break;
    append_border(*left, *right, x < window.min_x ? window.min_x - 1 : x, window, out);
    left = right;
  }
}

void WorkedGround::append_foreign(const Subfield& from, const Subfield& to, const Box& window,
                                  RisingCurves& out) {
  const TrackFrame &theirs = from.grid.frame, &ours = to.grid.frame;
  const Box seen = box_in(window, ours, theirs);
  const auto move = [&](Point p) { return ours.to_track(theirs.to_field(p)); };
  const StripRange near = strips_near(from.grid, from.range, seen, from.bulge_m);
  for (int k = near.first; k <= near.last; ++k) {
    const Worked& strip = from.strips[static_cast<std::size_t>(k - from.range.first)];
    for (const Interval& part : strip.work.straight) {
      const Box box = straight_box(from.grid, k, part);
      if (!intersects(box, seen)) continue;
      Ring ring = corners(box);
      for (Point& p : ring) p = move(p);
      append_ring(ring, Layer::kTaken, window, out);
    }
    for (std::size_t i = 0; i < strip.reach.size(); ++i)
      if (intersects(strip.reach[i], seen))
        append_band(moved(strip.work.detours[i].path, move), from.grid.width_m, Layer::kTaken, out);
  }
}

WorkedGround worked_straight(const std::vector<LaidTracks>& tracks) {
  WorkedGround ground;
  for (std::size_t i = 0; i < tracks.size(); ++i) {
    ground.add_subfield(tracks[i].grid, range_of(tracks[i]));
    for (const LaidPiece& piece : tracks[i].pieces) {
      StripWork work = ground.at(i, piece.track);
      for (const Interval& part : parts_on_track(piece)) work.straight.push_back(part);
      ground.set(i, piece.track, std::move(work));
    }
  }
  return ground;
}

WorkedGround worked_by(const std::vector<LaidTracks>& tracks) {
  WorkedGround ground = worked_straight(tracks);
  for (std::size_t i = 0; i < tracks.size(); ++i)
    for (const LaidPiece& piece : tracks[i].pieces) {
      if (piece.detours.empty()) continue;
      StripWork work = ground.at(i, piece.track);
      work.detours.insert(work.detours.end(), piece.detours.begin(), piece.detours.end());
      ground.set(i, piece.track, std::move(work));
    }
  return ground;
}

Box straight_box(const StripGrid& grid, int strip, const Interval& part) {
  return {grid.line(strip), part.from, grid.line(strip + 1), part.to};
}

Box detour_box(const TrackDetour& detour, double width_m) { return reach_of(detour.path, width_m); }

}  // namespace tramline
