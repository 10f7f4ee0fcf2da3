#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "tramline/check/rules/route/worked_ground.h"
#include "tramline/check/rules/rules.h"
#include "tramline/check/tolerances.h"
#include "tramline/geometry/index/box_grid.h"

namespace tramline::check {
namespace {

/// Every stretch is looked at in the middle of equal steps no longer than this, m: metres are counted so
/// (docs/route.md).
constexpr double kStep_m = 1;

/// A length, and how much of it the margin of worked land decides.
struct Over {
  double length_m = 0;
  double unsure_m = 0;
};

class DrivenOver {
 public:
  explicit DrivenOver(const Case& c) : c_(c), ground_(c.plan) {
    std::vector<Box> boxes;
    for (const Ring& ring : rings_of(c.plan.body))
      for (std::size_t i = 0; i < ring.size(); ++i) {
        boxes.push_back(bounds(ring[i], ring[i + 1 < ring.size() ? i + 1 : 0]).grown(kWorkedMargin_m));
      }
    border_ = BoxGrid(boxes);
  }

  void add(std::size_t leg) {
    for (const SteeredStretch& stretch : c_.plan.route.legs[leg].path) {
      const double steps = std::ceil(stretch.length_m / kStep_m);
      for (double step = 0; step < steps; ++step)
        add(leg, pose_after(stretch, (step + 0.5) / steps * stretch.length_m).at, stretch.length_m / steps);
    }
  }

  Over worked, unworked, tracks;

 private:
  static void count(Over& over, bool surely, bool perhaps, double length_m) {
    if (surely) over.length_m += length_m;
    if (surely != perhaps) over.unsure_m += length_m;
  }

  void add(std::size_t leg, Point at, double length_m) {
    const auto [surely, perhaps] = first_at(at);
    count(worked, surely < leg, perhaps < leg, length_m);
    const auto later = [leg](std::size_t first) { return first != WorkedGround::kNever && first >= leg; };
    const bool decided = surely == perhaps;
    count(unworked, later(surely), decided ? later(surely) : !later(surely), length_m);
    const bool on_tracks = surely != WorkedGround::kNever && contains(c_.plan.body, at);
    count(tracks, on_tracks, decided && !at_border(at) ? on_tracks : !on_tracks, length_m);
  }

  /// On passable obstacles nothing is worked; beside them work begins and ends by the line of a pass, and
  /// nothing is for certain.
  WorkedGround::First first_at(Point at) const {
    WorkedGround::First out = ground_.first_at(at);
    const double width_m = c_.plan.machine.width_m;
    for (const BoundedPolygon& passable : c_.passables) {
      if (!intersects(passable.box.grown(width_m), {at.x, at.y, at.x, at.y})) continue;
      if (contains(*passable.shape, at)) out.surely = WorkedGround::kNever;
      for (const Ring& ring : rings_of({*passable.shape}))
        for (std::size_t i = 0; i < ring.size(); ++i)
          if (distance_to_segment(at, ring[i], ring[i + 1 < ring.size() ? i + 1 : 0]) < width_m)
            out.surely = WorkedGround::kNever;
    }
    return out;
  }

  bool at_border(Point at) const {
    bool out = false;
    border_.each_meeting({at.x, at.y, at.x, at.y}, [&out](std::size_t) { out = true; });
    return out;
  }

  const Case& c_;
  WorkedGround ground_;
  BoxGrid border_;
};

}  // namespace

void check_route_driven_over(const Case& c, Violations& out) {
  const Route& route = c.plan.route;
  if (!route.planned()) return;
  DrivenOver found(c);
  for (std::size_t i = 0; i < route.legs.size(); ++i)
    if (!route.legs[i].work) found.add(i);
  const auto compare = [&](const char* what, double stored_m, const Over& over) {
    // Written so that NaN is a violation.
    if (!(std::abs(stored_m - over.length_m) <= over.unsure_m + kLengthTolerance_m))
      out.push_back(
          {Rule::kRouteDrivenOver,
           fmt::format("the route leads over {:.1f} m of {}, not {:.1f} m", over.length_m, what, stored_m),
           route.legs.front().path.front().start.at, stored_m - over.length_m});
  };
  compare("worked land", route.over_worked_m, found.worked);
  compare("land to be worked", route.over_unworked_m, found.unworked);
  compare("land of tracks", route.over_tracks_m, found.tracks);
}

}  // namespace tramline::check
