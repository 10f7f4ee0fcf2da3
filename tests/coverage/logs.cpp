#include "coverage/logs.h"

#include <cstring>
#include <utility>

namespace tramline::testing_logs {

Region square(double side_m) { return {{{{0, 0}, {side_m, 0}, {side_m, side_m}, {0, side_m}}, {}}}; }

Boom boom(int sections, double width_m) {
  Boom out;
  for (int i = 0; i < sections; ++i)
    out.push_back({width_m / 2 - i * width_m / sections, width_m / 2 - (i + 1) * width_m / sections});
  return out;
}

Fix fix(double time_s, Point at) {
  Fix out;
  out.time_s = time_s;
  out.position = at;
  out.boom = 0;
  out.work = WorkState::kOn;
  return out;
}

Fix fix(double time_s, Point at, double heading_deg) {
  Fix out = fix(time_s, at);
  out.heading = Heading::clockwise_from_north(Angle::degrees(heading_deg));
  return out;
}

Fix idle(Fix fix) {
  fix.work = WorkState::kOff;
  return fix;
}

Fix with_sections(Fix fix, const char* states) {
  fix.has_sections = true;
  for (std::size_t i = 0; i < std::strlen(states); ++i) fix.sections[i] = states[i] == '1';
  return fix;
}

WorkLog log(std::vector<Fix> fixes, double width_m) {
  WorkLog out;
  out.name = "drive.csv";
  out.positions = Positions::kLocal;
  out.clock = Clock::kOther;
  out.booms = {boom(1, width_m)};
  out.fixes = std::move(fixes);
  return out;
}

}  // namespace tramline::testing_logs
