#include "tramline/check/rules/route/route_facts.h"

#include <fmt/format.h>

#include <cassert>
#include <cmath>
#include <set>

namespace tramline::check {
namespace {

/// The places of corners on the outer side of a turn, from the axle: ahead in x, beside it in y, m.
std::vector<Point> outer_corners(const Machine& machine) {
  const Turning& turning = machine.turning;
  std::vector<Point> out{{turning.front_overhang_m, turning.vehicle_width_m / 2}};
  if (turning.implement == Coupling::kMounted)
    for (const double behind_m :
         {turning.implement_offset_m, turning.implement_offset_m + turning.rear_overhang_m})
      out.push_back({-behind_m, machine.width_m / 2});
  return out;
}

/// How far a corner swings is known to this, m.
constexpr double kSwing_m = 0.01;

}  // namespace

bool cannot_be_driven(const Plan& plan, const RouteLeg& leg) {
  if (!(leg.missing_m > 0)) return false;
  if (leg.kind != LegKind::kHeadland) return true;
  const Point middle{0, -plan.machine.radius_m};
  const double band_m = distance(middle, {0, plan.machine.width_m / 2});
  for (const Point corner : outer_corners(plan.machine)) {
    const double swung_m = distance(middle, corner) - band_m;
    if (swung_m > 0 && leg.missing_m <= swung_m + kSwing_m) return false;
  }
  return true;
}

std::string leg_name(const Plan& plan, std::size_t leg) {
  return fmt::format("leg {} ({})", leg + 1, name(plan.route.legs[leg].kind));
}

std::vector<std::size_t> legs_of_pass(const Plan& plan, std::size_t pass) {
  std::vector<std::size_t> out;
  for (std::size_t i = 0; i < plan.route.legs.size(); ++i)
    if (plan.route.legs[i].pass == pass) out.push_back(i);
  return out;
}

std::vector<std::size_t> work_legs(const Plan& plan) {
  std::vector<std::size_t> out;
  for (std::size_t i = 0; i < plan.route.legs.size(); ++i)
    if (plan.route.legs[i].kind == LegKind::kWork) out.push_back(i);
  return out;
}

WorkedCourse course_of_piece(const Plan& plan, std::size_t piece) {
  return {centre_line(plan.pieces[piece]), PathEnds::kApart, plan.machine};
}

WorkedCourse course_of_pass(const Plan& plan, std::size_t pass, PassSense sense) {
  const HeadlandPass& of = plan.headland.passes[pass];
  return {sense == PassSense::kAgainst ? reversed(of.path) : of.path,
          is_closed(of) ? PathEnds::kMeet : PathEnds::kApart, plan.machine};
}

std::size_t part_of(const RouteLeg& leg, const Plan& plan, const LandParts& parts) {
  assert(leg.piece || leg.pass);
  if (parts.count() < 2 || plan.headland.construction != HeadlandConstruction::kDrivable) return 0;
  const auto at_middle = [&](const WorkedCourse& course) {
    return parts.part_of(course.axle(0.5 * course.length_m()).at);
  };
  if (leg.pass) return at_middle(course_of_pass(plan, *leg.pass, PassSense::kAlong));
  std::size_t piece = *leg.piece;
  while (piece > 0 && plan.pieces[piece].after_crossing) --piece;
  return at_middle(course_of_piece(plan, piece));
}

std::size_t parts_with_work(const Plan& plan, const LandParts& parts) {
  std::set<std::size_t> out;
  for (const RouteLeg& leg : plan.route.legs) {
    const bool exists = leg.pass    ? *leg.pass < plan.headland.passes.size()
                        : leg.piece ? *leg.piece < plan.pieces.size()
                                    : false;
    if (exists) out.insert(part_of(leg, plan, parts));
  }
  return out.size();
}

double turned_deg(Point ahead, Point other) {
  return Angle::radians(std::abs(std::atan2(cross(ahead, other), dot(ahead, other)))).degrees();
}

}  // namespace tramline::check
