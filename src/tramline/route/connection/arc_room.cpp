#include "tramline/route/connection/arc_room.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <functional>
#include <utility>

namespace tramline {
namespace {

std::size_t side_of(double left) { return left > 0 ? 1 : 0; }

/// Whether a turn of a word is as long as one that lacks room; a line is not.
template <class Known>
bool is_too_long(double turn_m, const std::array<Known, 2>& known) {
  return turn_m != 0 && std::abs(turn_m) >= known[side_of(turn_m)].lacks_m;
}

}  // namespace

ArcRoom::AtPose& ArcRoom::at(const Pose& pose) { return known_[key_of(pose)]; }

bool ArcRoom::has_room(const SteeredStretch& turn, std::array<Known, 2>& known) const {
  Known& side = known[side_of(turn.curvature_at_start)];
  if (turn.length_m <= side.has_m) return true;
  if (turn.length_m >= side.lacks_m) return false;
  const bool has = ground_.turning().never_leaves(turn, ground_.outline());
  (has ? side.has_m : side.lacks_m) = turn.length_m;
  return has;
}

bool ArcRoom::has_room(const SteeredPath& path, AtPose& from, AtPose& to) const {
  const auto is_turn = [](const SteeredStretch& stretch) { return stretch.curvature_at_start != 0; };
  auto first = path.begin(), last = path.end();
  if (first != last && is_turn(*first) && !has_room(*first++, from.leaving)) return false;
  if (first != last && is_turn(*(last - 1)) && !has_room(*--last, to.entering)) return false;
  return std::all_of(first, last, [&](const SteeredStretch& stretch) {
    return ground_.turning().never_leaves(stretch, ground_.outline());
  });
}

std::optional<SteeredPath> ArcRoom::first_with_room(const Pose& from, const Pose& to,
                                                    const DubinsWords& words, std::size_t few) {
  assert(ground_.steers_at_once() && !ground_.outline().tows());
  AtPose &leaving = at(from), &entering = at(to);
  for (std::size_t i = 0; i < std::min(few, words.size()); ++i) {
    const DubinsWords::Ends ends = words.ends(i);
    if (is_too_long(ends.first_m, leaving.leaving) || is_too_long(ends.last_m, entering.entering)) continue;
    SteeredPath path = words.built(i).path;
    if (path.empty()) return path;
    if (!leaving.on_land) leaving.on_land = ground_.turning().holds(from, ground_.outline());
    if (!*leaving.on_land) return std::nullopt;
    if (has_room(path, leaving, entering)) return path;
  }
  return std::nullopt;
}

}  // namespace tramline
