#include "tramline/turns/track_ends.h"

namespace tramline {

double reach_back_m(const Turning& turning) {
  return turning.implement_offset_m + (turning.implement == Coupling::kTowed ? turning.drawbar_m : 0);
}

Pose pose_after_work(Point end, Heading heading, const Turning& turning) {
  return {end + (reach_back_m(turning) + turning.lift_m) * heading.unit(), heading};
}

Pose pose_before_work(Point start, Heading heading, const Turning& turning) {
  return {start + (reach_back_m(turning) - turning.lower_m) * heading.unit(), heading};
}

}  // namespace tramline
