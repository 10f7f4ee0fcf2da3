#include "tramline/model/speeds.h"

namespace tramline {

double speed_with_work_off(Gear gear, const Turning& turning) {
  return gear == Gear::kForward ? turning.turning_speed_mps : turning.reverse_speed_mps;
}

double speed_of(const RouteLeg& leg, const Turning& turning) {
  return leg.work ? turning.working_speed_mps : speed_with_work_off(leg.gear, turning);
}

}  // namespace tramline
