#include "tramline/cost/bound/detour_zones.h"

#include <algorithm>
#include <cmath>

#include "tramline/cost/tolerances.h"

namespace tramline {
namespace {

/// Rounding, tips of obstacles and the slack that detours are granted, m.
constexpr double kSlack_m = 0.03;

double gap_across(const Box& a, const Box& b) { return std::max(a.min_x - b.max_x, b.min_x - a.max_x); }
double gap_along(const Box& a, const Box& b) { return std::max(a.min_y - b.max_y, b.min_y - a.max_y); }

class Zones {
 public:
  Zones(const TurnedSubfield& subfield, const DetourTerms& terms) : subfield_(subfield), terms_(terms) {}

  std::vector<DetourZone> grouped() const {
    std::vector<DetourZone> out;
    const Box near = subfield_.reach.grown(2 * (terms_.width_m + terms_.slack_m));
    Region all = subfield_.ground.hard;
    all.insert(all.end(), subfield_.ground.passable.begin(), subfield_.ground.passable.end());
    all.insert(all.end(), subfield_.ground.beyond.begin(), subfield_.ground.beyond.end());
    for (const Polygon& obstacle : all) {
      const Box box = bounds(obstacle);
      if (!intersects(box, near)) continue;
      DetourZone one = zone_of(box, 1);
      for (std::size_t i = 0; i < out.size();) {
        if (!are_one(one, out[i])) {
          ++i;
          continue;
        }
        Box both = one.obstacles;
        both.extend(out[i].obstacles);
        one = zone_of(both, one.count + out[i].count);
        out.erase(out.begin() + static_cast<std::ptrdiff_t>(i));
        i = 0;
      }
      out.push_back(one);
    }
    return out;
  }

 private:
  DetourZone zone_of(const Box& obstacles, int count) const {
    const double width_m = terms_.width_m, size_m = std::hypot(obstacles.width(), obstacles.height());
    const double turn = std::tan(terms_.half_angle);
    double across = width_m + kDetourRound_share * size_m + kSlack_m;
    // The swath of an arc that leaves the track begins where the arc does; a line leads to it only where the
    // track is displaced by more than two arcs are.
    double along = 2 * terms_.arc_m + kDetourRound_share * size_m + kSlack_m;
    const double widest_m = terms_.of == DetoursOf::kAnyGrid ? size_m : obstacles.width() + turn * size_m;
    if (const double aside_m = widest_m + across; aside_m + kSlack_m > 2 * terms_.arc_m)
      along += kDetourFoot * aside_m;
    const double turned = turn * (size_m + across + along);
    across += turned;
    along += turned;
    if (terms_.of == DetoursOf::kAnyGrid) across = along = std::hypot(across, along);
    return {count,
            obstacles,
            {obstacles.min_x - across, obstacles.min_y - along, obstacles.max_x + across,
             obstacles.max_y + along}};
  }

  /// Whether one detour may go round obstacles of both.
  bool are_one(const DetourZone& a, const DetourZone& b) const {
    const double reach = std::max(a.obstacles.min_x - a.land.min_x, b.obstacles.min_x - b.land.min_x);
    if (gap_across(a.obstacles, b.obstacles) > reach + 2 * terms_.slack_m) return false;
    if (gap_along(a.land, b.land) <= 2 * terms_.slack_m) return true;
    // No track is driven from one to the other where it leaves the land in between: both lie in one gap.
    const DetourZone& low = a.land.min_y < b.land.min_y ? a : b;
    const DetourZone& high = &low == &a ? b : a;
    const Box between{std::min(a.land.min_x, b.land.min_x) - terms_.slack_m, low.obstacles.max_y,
                      std::max(a.land.max_x, b.land.max_x) + terms_.slack_m, high.obstacles.min_y};
    const Ring& ring = subfield_.outline.front();
    Point from = ring.back();
    for (const Point to : ring) {
      if (intersects(bounds(from, to), between)) return true;
      from = to;
    }
    return false;
  }

  const TurnedSubfield& subfield_;
  const DetourTerms& terms_;
};

}  // namespace

std::vector<DetourZone> detour_zones(const TurnedSubfield& subfield, const DetourTerms& terms) {
  return Zones(subfield, terms).grouped();
}

}  // namespace tramline
