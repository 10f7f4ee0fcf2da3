#include "server/work/ready_drive.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "tramline/geometry/error.h"

namespace tramline::server {

std::size_t ReadyDrive::bytes() const {
  return ready.log.fixes.size() * (sizeof(Fix) + sizeof(double)) + sizeof(ReadyDrive);
}

std::vector<double> release_clock(const std::vector<Fix>& fixes) {
  const auto timed = [](const Fix& fix) { return std::isfinite(fix.time_s); };
  const auto first = std::find_if(fixes.begin(), fixes.end(), timed);
  std::vector<double> out;
  out.reserve(fixes.size());
  if (first == fixes.end()) {
    for (std::size_t i = 0; i < fixes.size(); ++i) out.push_back(static_cast<double>(i));
    return out;
  }
  double latest_s = first->time_s;
  for (const Fix& fix : fixes) {
    if (timed(fix)) latest_s = std::max(latest_s, fix.time_s);
    out.push_back(latest_s);
  }
  return out;
}

ReadyDrive ready_drive(WorkLog read, app::WorkGround ground, const coverage::EvaluateSettings& settings) {
  ReadyDrive out;
  out.ground = std::move(ground);
  out.settings = settings;
  out.settings.shapes = out.settings.covered = false;
  if (!read.shapes.empty())
    throw bad_input(fmt::format(
        "{} has polygons, which do not show how they were driven: evaluate it with tramline evaluate",
        read.name));
  WorkLog placed = app::placed_on(std::move(read), out.ground);
  if (placed.fixes.size() < 2)
    throw bad_input(fmt::format("{} has {} with a position; at least two are needed", placed.name,
                                placed.fixes.empty() ? "no fix" : "one fix"));
  out.ready = coverage::prepared(std::move(placed), settings.drive);
  coverage::working_width_m(out.ready.log, settings.drive);
  out.clock_s = release_clock(out.ready.log.fixes);
  return out;
}

}  // namespace tramline::server
