#include "tramline/route/connection/way.h"

#include <algorithm>
#include <iterator>

#include "tramline/geometry/tolerances.h"
#include "tramline/model/speeds.h"
#include "tramline/route/axle/axle_path.h"

namespace tramline {
namespace {

/// More of what was driven before is not kept.
constexpr double kBackedAlong_m = 1000;

/// What is left of a path behind the machine when it has backed so far along it.
SteeredPath backed_from(const SteeredPath& path, double back_m) {
  return length(path) > back_m ? part_of(path, 0, length(path) - back_m) : SteeredPath{};
}

}  // namespace

double idle_seconds(const SteeredPath& path, const Turning& turning) {
  double out = 0;
  Gear gear = Gear::kForward;
  for (const SteeredStretch& stretch : path) {
    if (stretch.gear != gear) out += turning.gear_change_s;
    gear = stretch.gear;
    out += stretch.length_m / speed_with_work_off(gear, turning);
  }
  return gear == Gear::kReverse ? out + turning.gear_change_s : out;
}

SteeredPath driven_forward(const SteeredPath& before, const Way& way, const SteeredPath& work) {
  if (!way.has_room()) return work;
  auto begin = way.path.begin(), end = way.path.end();
  double out_m = 0, in_m = 0;
  if (way.backs_out)
    for (; begin != end && begin->gear == Gear::kReverse; ++begin) out_m += begin->length_m;
  if (way.backs_in)
    for (; end != begin && (end - 1)->gear == Gear::kReverse; --end) in_m += (end - 1)->length_m;
  const auto broken =
      std::find_if(std::reverse_iterator(end), std::reverse_iterator(begin), [](const SteeredStretch& s) {
        return s.gear == Gear::kReverse;
      }).base();
  SteeredPath out;
  if (broken == begin) out = backed_from(before, out_m);
  // It may have backed along land of the work that it had not come over forward.
  const Pose goes_on = broken != end ? broken->start : pose_on(work, std::min(in_m, length(work)));
  if (!out.empty() && distance(end_of(out).at, goes_on.at) > kSamePlace_m) out.clear();
  out.insert(out.end(), broken, end);
  if (length(work) > in_m) {
    const SteeredPath rest = part_of(work, in_m, length(work));
    out.insert(out.end(), rest.begin(), rest.end());
  }
  if (out.empty()) return work;
  const double all_m = length(out);
  return all_m > kBackedAlong_m ? part_of(out, all_m - kBackedAlong_m, all_m) : out;
}

std::vector<RouteLeg> legs_of(const Way& way) {
  std::vector<RouteLeg> out;
  for (const SteeredStretch& stretch : way.path) {
    if (out.empty() || stretch.gear != out.back().gear) {
      RouteLeg leg;
      leg.kind = way.kind;
      leg.gear = stretch.gear;
      leg.missing_m = way.backs_on_land && stretch.gear == Gear::kReverse ? 0 : way.missing_m;
      out.push_back(std::move(leg));
    }
    out.back().path.push_back(stretch);
  }
  if (out.empty()) return out;
  if (way.backs_out && out.front().gear == Gear::kReverse) out.front().kind = LegKind::kBackOut;
  if (way.backs_in && out.back().gear == Gear::kReverse) out.back().kind = LegKind::kBackOut;
  out.back().lateral_error_m = way.lateral_error_m;
  return out;
}

}  // namespace tramline
