#include "tramline/route/connection/way.h"

#include "tramline/model/speeds.h"

namespace tramline {

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

std::vector<RouteLeg> legs_of(const Way& way) {
  std::vector<RouteLeg> out;
  for (const SteeredStretch& stretch : way.path) {
    if (out.empty() || stretch.gear != out.back().gear) {
      RouteLeg leg;
      leg.kind = way.kind;
      leg.gear = stretch.gear;
      leg.missing_m = way.missing_m;
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
