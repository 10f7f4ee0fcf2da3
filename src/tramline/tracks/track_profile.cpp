#include "tramline/tracks/track_profile.h"

#include <cassert>

namespace tramline {
namespace {

bool is_empty(const StripProfile& profile) { return profile.empty(); }
bool is_empty(const PathProfile& profile) { return profile.segments.empty(); }

const Intervals& on_centre_line(const StripProfile& profile) { return profile.centre_line; }
Intervals on_centre_line(const PathProfile& profile) { return tramline::centre_inside(profile); }

}  // namespace

bool TrackProfile::empty() const {
  return std::visit([](const auto& profile) { return is_empty(profile); }, profile_);
}

const StripProfile& TrackProfile::straight() const {
  assert(std::holds_alternative<StripProfile>(profile_));
  return *std::get_if<StripProfile>(&profile_);
}

Intervals TrackProfile::where_at_least(double least_m) const {
  return std::visit([least_m](const auto& profile) { return tramline::where_at_least(profile, least_m); },
                    profile_);
}

Intervals TrackProfile::centre_inside() const {
  return std::visit([](const auto& profile) -> Intervals { return on_centre_line(profile); }, profile_);
}

double TrackProfile::area_between(double from, double to) const {
  return std::visit([from, to](const auto& profile) { return tramline::area_between(profile, from, to); },
                    profile_);
}

}  // namespace tramline
