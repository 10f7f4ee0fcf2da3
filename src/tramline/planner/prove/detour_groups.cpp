#include "tramline/planner/prove/detour_groups.h"

#include <algorithm>

namespace tramline {
namespace {

/// Corners of a ring where it turns to the outside. A strip meets a polygon in at most one part more.
int reflex_corners(const Ring& ring) {
  int sum = 0;
  const std::size_t n = ring.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Point a = ring[(i + n - 1) % n], b = ring[i], c = ring[(i + 1) % n];
    sum += cross(b - a, c - b) < 0 ? 1 : 0;
  }
  return signed_area(ring) < 0 ? static_cast<int>(n) - sum : sum;
}

/// The largest distance of a detour from its track round what is so wide across it. What passes as a circle
/// reaches 1 % beyond its corners.
double rise_m(double across_m, const Detouring& terms) { return 1.02 * across_m + terms.width_m; }

/// No detour begins farther along its track from what it goes round: it leaves the track along an arc, or
/// along a line that is inclined by 75 degrees between two arcs.
double reach_m(double across_m, const Detouring& terms) {
  constexpr double kFoot = 0.27;  // more than the cotangent of 75 degrees
  return terms.width_m + 2 * terms.arc_m + kFoot * rise_m(across_m, terms);
}

/// By how much the detour is longer than its rows, at most. Where it has risen by f of h and turned by φ, f
/// and h − f are at least r(1 − cos φ): φ is at most acos(1 − h/2r). It is longer by ∫ tan(φ/2) df, there and
/// back.
double longer_m(double rise_m, const Detouring& terms) {
  const double steepest =
      terms.drivable && rise_m < 2 * terms.arc_m ? std::sqrt(rise_m / (4 * terms.arc_m - rise_m)) : 1;
  return 2 * rise_m * steepest;
}

double distance_of(const Box& a, const Box& b) {
  return std::hypot(std::max({0.0, a.min_x - b.max_x, b.min_x - a.max_x}),
                    std::max({0.0, a.min_y - b.max_y, b.min_y - a.max_y}));
}

/// Whether the border of the ground comes between two boxes, so that a track from one to the other may be
/// interrupted there and one detour go round both.
bool are_parted(const Box& a, const Box& b, double reach, const Region& ground) {
  Box both = a;
  both.extend(b);
  both = both.grown(reach);
  for (const Polygon& part : ground) {
    Point from = part.outer.back();
    for (const Point to : part.outer) {
      if (intersects(bounds(from, to), both)) return true;
      from = to;
    }
  }
  return false;
}

}  // namespace

std::vector<DetourGroup> detour_groups(const std::vector<Hazard>& hazards, const Region& ground,
                                       const Detouring& terms) {
  std::vector<DetourGroup> out;
  for (const Hazard& hazard : hazards) {
    DetourGroup one{bounds(hazard.shape), hazard.shape.outer, 1 + reflex_corners(hazard.shape.outer)};
    for (std::size_t i = 0; i < out.size();) {
      const double reach = reach_m(one.diameter_m(), terms) + reach_m(out[i].diameter_m(), terms);
      if (distance_of(one.box, out[i].box) > reach + 2 * terms.width_m &&
          !are_parted(one.box, out[i].box, terms.width_m, ground)) {
        ++i;
        continue;
      }
      one.box.extend(out[i].box);
      one.corners.insert(one.corners.end(), out[i].corners.begin(), out[i].corners.end());
      one.most_detours += out[i].most_detours;
      out.erase(out.begin() + static_cast<std::ptrdiff_t>(i));
      i = 0;
    }
    out.push_back(std::move(one));
  }
  return out;
}

GroupZone detour_zone(const DetourGroup& group, const Box& turned, const Detouring& terms, double stray_m) {
  GroupZone out;
  out.box = turned.grown(stray_m);
  const double rise = rise_m(out.box.width(), terms), along = reach_m(out.box.width(), terms) + stray_m;
  const double across = terms.width_m + 0.02 * group.diameter_m() + 2 * stray_m;
  out.land = {out.box.min_x - across, out.box.min_y - along, out.box.max_x + across, out.box.max_y + along};
  // None of its detours is steeper than 75 degrees all the way up, and they do not overlap along the track.
  constexpr double kSteepest = 4;
  out.longer_m = std::min(group.most_detours * longer_m(rise, terms), kSteepest * out.land.height());
  return out;
}

void reach_for_others(std::vector<GroupZone>& zones) {
  for (GroupZone& a : zones)
    for (const GroupZone& b : zones) {
      if (a.land.min_x > b.land.max_x || b.land.min_x > a.land.max_x) continue;
      a.land.min_y = std::min(a.land.min_y, b.box.min_y);
      a.land.max_y = std::max(a.land.max_y, b.box.max_y);
    }
}

}  // namespace tramline
