#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "tramline/check/bands.h"
#include "tramline/check/rule_names.h"
#include "tramline/check/rules.h"
#include "tramline/check/tolerances.h"

namespace tramline::check {
namespace {

/// From land to a line; 0 where they meet or it lies within.
double distance_between(const Path& line, const Polygon& land) {
  if (contains(land, line.front().from)) return 0;
  double out = std::numeric_limits<double>::infinity();
  for (const Ring& ring : rings_of({land}))
    for (std::size_t i = 0; i < ring.size(); ++i)
      for (const PathSegment& segment : line)
        out = std::min(out, distance_to_edge(segment, ring[i], ring[i + 1 < ring.size() ? i + 1 : 0]));
  return out;
}

/// Twice the ground between a detour and the line it left, positive where it is driven round anticlockwise.
bool goes_left(const Path& detour, const Path& line) {
  constexpr double kSagitta_m = 1e-4;
  Ring round = chords(detour, kSagitta_m);
  std::vector<Point> back = chords(line, kSagitta_m);
  if (distance(back.front(), round.back()) > distance(back.back(), round.back()))
    std::reverse(back.begin(), back.end());
  round.insert(round.end(), back.begin(), back.end());
  return signed_area(round) < 0;
}

class CurvedDetour {
 public:
  CurvedDetour(const Case& c, std::size_t index, std::size_t number)
      : c_(c),
        piece_(c.plan.pieces[index]),
        detour_(piece_.detours[number]),
        name_(detour_name(index, number)),
        reach_m_(0.5 * c.plan.machine.width_m + c.plan.settings.clearance_m) {}

  void run(Violations& out) const {
    const std::optional<Path> left = line_left(c_, piece_, detour_);
    const auto report = [&](const std::string& what) {
      out.push_back({rule::kEncounters, name_ + what, detour_.path.front().from, 1});
    };
    if (!left) {
      report(" does not lead from the line of its track back to it");
      return;
    }
    const Path& line = *left;
    if (goes_left(detour_.path, line) != (detour_.side == Passing::kLeft))
      report(fmt::format(" does not pass {}", tramline::name(detour_.side)));
    const std::vector<const Encounter*> encounters = encounters_at(c_, piece_, detour_);
    if (encounters.empty()) report(" is where the plan has no encounter");
    const Box near = reach_of(line, 2 * reach_m_ + 1);
    const auto& obstacles = c_.plan.field.obstacles;
    for (std::size_t k = 0; k < obstacles.size(); ++k) {
      const bool named = std::find(detour_.obstacles.begin(), detour_.obstacles.end(), static_cast<int>(k)) !=
                         detour_.obstacles.end();
      if (!named && (obstacles[k].kind == ObstacleKind::kPassable || !intersects(c_.obstacle_boxes[k], near)))
        continue;
      const double off_m = distance_between(line, obstacles[k].shape);
      const char* fault = "";
      if (named && off_m > reach_m_ + kLengthTolerance_m)
        fault = "is named, and not in its way";
      else if (!named && off_m < reach_m_ - kLengthTolerance_m)
        fault = "is in its way and not named";
      if (*fault != 0) report(fmt::format(": obstacle {} {}", k + 1, fault));
    }
  }

 private:
  const Case& c_;
  const TrackPiece& piece_;
  const Detour& detour_;
  std::string name_;
  double reach_m_;
};

}  // namespace

std::optional<Path> line_left(const Case& c, const TrackPiece& piece, const Detour& detour) {
  return c.lines.of(piece.subfield)
      .between(piece.track, detour.path.front().from, direction_at_start(detour.path.front()),
               detour.path.back().to);
}

void check_curved_detours(const Case& c, Violations& out) {
  for (std::size_t i = 0; i < c.plan.pieces.size(); ++i)
    if (!c.plan.pieces[i].curve.empty())
      for (std::size_t k = 0; k < c.plan.pieces[i].detours.size(); ++k) CurvedDetour(c, i, k).run(out);
}

}  // namespace tramline::check
