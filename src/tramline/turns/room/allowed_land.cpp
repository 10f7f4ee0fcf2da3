#include "tramline/turns/room/allowed_land.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "tramline/turns/outline/tolerances.h"
#include "tramline/turns/outline/towed_motion.h"
#include "tramline/turns/room/missing_room.h"
#include "tramline/turns/room/part_sweep.h"

namespace tramline {
namespace {

/// Pieces are not halved any more when they deviate by no more than this, m: land moved by the whole
/// tolerance then contains each outline that is grown by its bound and is within the bound of the land.
constexpr double kFinest_m = 0.5 * kBoundedMotion_m;

Region all_oriented(const Region& region) {
  Region out;
  for (const Polygon& polygon : region) out.push_back(oriented(polygon));
  return out;
}

double greatest_margin(const std::vector<Box>& parts, const MotionPiece& piece) {
  double out = 0;
  for (const Box& part : parts) out = std::max(out, piece.margin_m(part));
  return out;
}

bool sweep_stays(const LandEdges& land, const Box& part, const EvenMotion& motion) {
  const Box window = swept_box(part, motion);
  const PartSweep sweep(part, motion);
  bool stays = true;
  land.grid().each_meeting(window, [&](std::size_t i) {
    if (!stays) return;
    const EdgeIndex::Edge& edge = land.edges()[i];
    stays = !sweep.meets(to_part(motion.start, edge.from), to_part(motion.start, edge.to));
  });
  return stays;
}

bool piece_stays(const LandEdges& land, const std::vector<Box>& parts, const MotionPiece& piece) {
  return std::all_of(parts.begin(), parts.end(), [&](const Box& part) {
    const double margin = piece.margin_m(part);
    return sweep_stays(land, margin > 0 ? part.grown(margin) : part, piece.even);
  });
}

/// `piece_of(from, to)`: the motion between two places. Pieces that have no room with their margins are
/// halved until the margins are fine enough to decide.
template <class PieceOf>
bool motion_stays(const LandEdges& land, const std::vector<Box>& parts, double from_m, double to_m,
                  const PieceOf& piece_of) {
  const MotionPiece piece = piece_of(from_m, to_m);
  if (piece_stays(land, parts, piece)) return true;
  if (greatest_margin(parts, piece) <= kFinest_m) return false;
  const double middle = 0.5 * (from_m + to_m);
  return motion_stays(land, parts, from_m, middle, piece_of) &&
         motion_stays(land, parts, middle, to_m, piece_of);
}

/// One point of a part that no edge meets tells whether all of it is on the land.
bool starts_on(const LandEdges& land, const std::vector<Box>& parts, const Placement& start) {
  return std::all_of(parts.begin(), parts.end(),
                     [&](const Box& part) { return land.contains(to_ground(start, part.centre())); });
}

bool stretch_stays(const LandEdges& land, const SteeredStretch& stretch, const std::vector<Box>& parts) {
  return motion_stays(land, parts, 0, stretch.length_m,
                      [&](double from_m, double to_m) { return machine_motion(stretch, from_m, to_m); });
}

bool machine_stays(const LandEdges& land, const SteeredPath& path, const std::vector<Box>& parts) {
  if (!starts_on(land, parts, placed(path.front().start))) return false;
  return std::all_of(path.begin(), path.end(),
                     [&](const SteeredStretch& stretch) { return stretch_stays(land, stretch, parts); });
}

/// The drawbar reaches to the hitch, which moves with the machine: where that has no room the motion of the
/// implement need not be known.
bool hitch_stays(const LandEdges& land, const SteeredPath& path, const Outline& outline) {
  return machine_stays(land, path, {{-outline.hitch_m, 0, -outline.hitch_m, 0}});
}

bool implement_stays(const LandEdges& land, const SteeredPath& path, const Outline& outline) {
  if (!hitch_stays(land, path, outline)) return false;
  const TowedMotion towed(path, outline);
  if (!starts_on(land, outline.on_implement, towed.implement(0, 0))) return false;
  for (std::size_t i = 0; i < path.size(); ++i) {
    const auto piece_of = [&](double from_m, double to_m) { return towed.motion(i, from_m, to_m); };
    const double pieces = towed.pieces(i);
    for (double k = 0; k < pieces; ++k)
      if (!motion_stays(land, outline.on_implement, k / pieces * path[i].length_m,
                        (k + 1) / pieces * path[i].length_m, piece_of))
        return false;
  }
  return true;
}

}  // namespace

AllowedLand::AllowedLand(const Region& land)
    : land_(all_oriented(land)),
      exact_(slightly_grown(land_, kTouchesEdge_m)),
      bounded_(slightly_grown(land_, kBoundedMotion_m)) {}

bool AllowedLand::fits(const SteeredPath& path, const Outline& outline) const {
  if (path.empty()) return true;
  const bool clothoids =
      std::any_of(path.begin(), path.end(), [](const SteeredStretch& stretch) { return stretch.clothoid(); });
  if (!machine_stays(clothoids ? bounded_ : exact_, path, outline.on_machine)) return false;
  return !outline.tows() || implement_stays(bounded_, path, outline);
}

bool AllowedLand::nearly_fits(const SteeredPath& path, const Outline& outline) const {
  if (path.empty()) return true;
  return machine_stays(bounded_, path, outline.on_machine) &&
         (!outline.tows() || implement_stays(bounded_, path, outline));
}

bool AllowedLand::holds(const Pose& pose, const Outline& outline) const {
  assert(!outline.tows());
  return starts_on(exact_, outline.on_machine, placed(pose));
}

bool AllowedLand::never_leaves(const SteeredStretch& stretch, const Outline& outline) const {
  assert(!outline.tows() && !stretch.clothoid());
  return stretch_stays(exact_, stretch, outline.on_machine);
}

double AllowedLand::missing_m(const SteeredPath& path, const Outline& outline, double enough_m,
                              double roughly) const {
  return fits(path, outline) ? 0 : missing_room_m(land_, path, outline, enough_m, roughly);
}

}  // namespace tramline
