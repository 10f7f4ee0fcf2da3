#include <fmt/format.h>

#include <algorithm>

#include "tramline/check/rules/route/route_facts.h"
#include "tramline/check/rules/rules.h"
#include "tramline/check/tolerances.h"
#include "tramline/check/turning/turning_ground.h"

namespace tramline::check {
namespace {

/// The room that a leg is said to lack is found to this, m.
constexpr double kMissing_m = 0.05;

class RoomCheck {
 public:
  RoomCheck(const Case& c, Violations& out, Violations& findings)
      : plan_(c.plan),
        swaths_may_leave_(plan_.settings.boundary == EdgeKind::kSoft && plan_.settings.headlands == 0),
        turned_on_(plan_),
        driven_over_(plan_, Passables::kAreLand),
        obstacles_(plan_, Passables::kAreLand, Beyond::kIsLand),
        out_(out),
        findings_(findings) {}

  void run() {
    // A manoeuvre that lacks room says so on all its legs.
    const std::vector<RouteLeg>& legs = plan_.route.legs;
    for (std::size_t first = 0, next = 0; first < legs.size(); first = next) {
      for (next = first + 1; next < legs.size() && one_manoeuvre(legs[first], legs[next]);) ++next;
      check(first, next);
    }
  }

 private:
  static bool one_manoeuvre(const RouteLeg& a, const RouteLeg& b) {
    return !a.work && !b.work && a.missing_m > 0 && a.missing_m == b.missing_m;
  }

  void check(std::size_t first, std::size_t next) {
    Excursion deepest;
    std::size_t of = first;
    for (std::size_t i = first; i < next; ++i) {
      const Excursion off = off_land(i);
      if (off.depth_m > deepest.depth_m) {
        deepest = off;
        of = i;
      }
    }
    judge(of, deepest);
  }

  Excursion off_land(std::size_t i) const {
    const RouteLeg& leg = plan_.route.legs[i];
    const bool turns = leg.kind == LegKind::kTurn || leg.kind == LegKind::kBackOut;
    // Where no way has room, the missing room is that of turning.
    const TurningGround& ground = turns || leg.missing_m > 0 ? turned_on_ : driven_over_;
    return ground.deepest(leg.path, plan_.machine, kPoses_m);
  }

  void judge(std::size_t i, const Excursion& off) {
    const RouteLeg& leg = plan_.route.legs[i];
    const std::string what = fmt::format("{} leaves the land by {:.2f} m", leg_name(plan_, i), off.depth_m);
    const Violation found{Rule::kRouteRoom, what, off.at, off.depth_m};
    if (leg.missing_m > 0) {
      if (leg.missing_m < off.depth_m - kMissing_m)
        out_.push_back({Rule::kRouteRoom, fmt::format("{}, not by {:.2f} m", what, leg.missing_m), off.at,
                        off.depth_m - leg.missing_m});
      findings_.push_back(found);
      return;
    }
    if (off.depth_m <= kOutside_m) return;
    const bool beyond_soft_edge = leg.work && swaths_may_leave_ &&
                                  obstacles_.deepest(leg.path, plan_.machine, kPoses_m).depth_m <= kOutside_m;
    (beyond_soft_edge ? findings_ : out_).push_back(found);
  }

  const Plan& plan_;
  bool swaths_may_leave_;  ///< the field; rules of tracks say by how much
  TurningGround turned_on_;
  TurningGround driven_over_;
  TurningGround obstacles_;
  Violations& out_;
  Violations& findings_;
};

}  // namespace

void check_route_room(const Case& c, Violations& out, Violations& findings) {
  if (c.plan.route.planned()) RoomCheck(c, out, findings).run();
}

}  // namespace tramline::check
