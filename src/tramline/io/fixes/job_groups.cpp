#include "tramline/io/fixes/job_groups.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include "tramline/geometry/error.h"
#include "tramline/io/fixes/civil_time.h"

namespace tramline::io {
namespace {

constexpr double kNear_m = 200, kNearOnOneField_m = 2000;

/// The middle 98 in a hundred.
void extend_by_most(std::vector<double> values, double& least, double& most) {
  if (values.empty()) return;
  std::sort(values.begin(), values.end());
  const std::size_t cut = values.size() / 100;
  least = values[cut];
  most = values[values.size() - 1 - cut];
}

/// Good to half a percent, which is all that is needed here.
double apart_m(const Box& a, const Box& b) {
  constexpr double kDegree_m = 6371008.8 * std::numbers::pi / 180;
  // Across the 180th meridian the way round the other side is shorter.
  const double turn = std::remainder(b.centre().x - a.centre().x, 360.0) - (b.centre().x - a.centre().x);
  const double east = std::max({0.0, a.min_x - (b.max_x + turn), b.min_x + turn - a.max_x});
  const double north = std::max({0.0, a.min_y - b.max_y, b.min_y - a.max_y});
  return kDegree_m * std::hypot(east * std::cos(a.centre().y * std::numbers::pi / 180), north);
}

bool share_a_device(const JobFacts& a, const JobFacts& b) {
  if (a.devices.empty() || b.devices.empty()) return true;
  return std::any_of(a.devices.begin(), a.devices.end(), [&](const std::string& device) {
    return std::find(b.devices.begin(), b.devices.end(), device) != b.devices.end();
  });
}

bool follow_in_days(const JobFacts& a, const JobFacts& b) {
  const auto day = [](double time_s) { return std::floor(time_s / kDay_s); };
  // False where times are not known.
  return !(day(b.from_s) - day(a.to_s) > 1) && !(day(a.from_s) - day(b.to_s) > 1);
}

}  // namespace

void require_room_for_log(std::size_t already, const char* what, const std::string& place, std::size_t most) {
  if (already < most) return;
  throw bad_input(fmt::format("{} holds more than {} {}; split it", place, most, what));
}

JobFacts facts_of(const WorkLog& log) {
  assert(log.positions == Positions::kLonLat);
  JobFacts out;
  out.from_s = out.to_s = std::numeric_limits<double>::quiet_NaN();
  std::vector<double> lon, lat;
  for (const Fix& fix : log.fixes) {
    out.from_s = std::fmin(out.from_s, fix.time_s);
    out.to_s = std::fmax(out.to_s, fix.time_s);
    lon.push_back(fix.position.x);
    lat.push_back(fix.position.y);
  }
  extend_by_most(std::move(lon), out.lonlat.min_x, out.lonlat.max_x);
  extend_by_most(std::move(lat), out.lonlat.min_y, out.lonlat.max_y);
  return out;
}

bool belong_together(const JobFacts& a, const JobFacts& b) {
  const bool both_named = !a.field_id.empty() && !b.field_id.empty();
  if (both_named && a.field_id != b.field_id) return false;
  if (a.lonlat.empty() || b.lonlat.empty()) return false;
  return share_a_device(a, b) && follow_in_days(a, b) &&
         apart_m(a.lonlat, b.lonlat) <= (both_named ? kNearOnOneField_m : kNear_m);
}

std::vector<std::vector<std::size_t>> job_groups(const std::vector<JobFacts>& logs) {
  std::vector<std::size_t> first(logs.size());  // of the job of each log
  std::iota(first.begin(), first.end(), std::size_t{0});
  for (std::size_t i = 0; i < logs.size(); ++i)
    for (std::size_t k = 0; k < i; ++k) {
      if (first[i] == first[k] || !belong_together(logs[k], logs[i])) continue;
      const std::size_t least = std::min(first[i], first[k]), other = std::max(first[i], first[k]);
      std::replace(first.begin(), first.end(), other, least);
    }
  std::vector<std::vector<std::size_t>> out;
  for (std::size_t i = 0; i < logs.size(); ++i) {
    if (first[i] != i) continue;
    out.emplace_back();
    for (std::size_t k = i; k < logs.size(); ++k)
      if (first[k] == i) out.back().push_back(k);
  }
  return out;
}

}  // namespace tramline::io
