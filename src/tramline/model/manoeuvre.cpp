#include "tramline/model/manoeuvre.h"

namespace tramline {

const char* name(ManoeuvreKind kind) {
  switch (kind) {
    case ManoeuvreKind::kU:
      return "u";
    case ManoeuvreKind::kOmega:
      return "omega";
    case ManoeuvreKind::kUnequalArcs:
      return "unequal_arcs";
    case ManoeuvreKind::kFishtail:
      return "fishtail";
    case ManoeuvreKind::kDubins:
      return "dubins";
    case ManoeuvreKind::kReedsShepp:
      return "reeds_shepp";
    case ManoeuvreKind::kBackOut:
      return "back_out";
  }
  return "";
}

int gear_changes(const Manoeuvre& manoeuvre) {
  const SteeredPath& path = manoeuvre.path;
  if (path.empty()) return 0;
  const auto reverse = [](const SteeredStretch& stretch) { return stretch.gear == Gear::kReverse ? 1 : 0; };
  return reverse(path.front()) + gear_changes(path) + reverse(path.back());
}

double seconds(const Manoeuvre& manoeuvre, const Machine& machine) {
  const Turning& turning = machine.turning;
  double sum = turning.gear_change_s * gear_changes(manoeuvre);
  for (const SteeredStretch& stretch : manoeuvre.path)
    sum += stretch.length_m /
           (stretch.gear == Gear::kForward ? turning.turning_speed_mps : turning.reverse_speed_mps);
  return sum;
}

}  // namespace tramline
