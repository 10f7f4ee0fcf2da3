#include "tramline/route/passes/pass_entries.h"

#include <algorithm>
#include <cmath>

#include "tramline/geometry/path/path_between.h"
#include "tramline/turns/track_ends.h"

namespace tramline {
namespace {

Path in_sense(const HeadlandPass& pass, Sense sense) {
  return sense == Sense::kAlong ? pass.path : reversed(pass.path);
}

void add_open(const HeadlandPass& pass, Sense sense, const Turning& turning, std::vector<PassEntry>& out) {
  const SteeredPath axle = axle_path(in_sense(pass, sense), turning);
  out.push_back({0, sense, axle.front().start, end_of(axle)});
}

void add_closed(const HeadlandPass& pass, Sense sense, double spacing_m, const Turning& turning,
                std::vector<PassEntry>& out) {
  const SteeredPath axle = steered(in_sense(pass, sense));
  const double length_m = length(axle), back_m = reach_back_m(turning);
  const double places = std::max(1.0, std::ceil(length_m / spacing_m));
  for (double i = 0; i < places; ++i) {
    const double entered_m = i / places * length_m;
    double at_m = std::fmod(entered_m + back_m, length_m);
    if (at_m < 0) at_m += length_m;
    const Pose pose = pose_on(axle, at_m);
    out.push_back({entered_m, sense, pose, pose});
  }
}

constexpr double kEntrySpacing_radii = 0.5;
constexpr double kLeastEntrySpacing_m = 2;

}  // namespace

std::vector<PassEntry> entries_of(const HeadlandPass& pass, double spacing_m, const Turning& turning) {
  std::vector<PassEntry> out;
  for (const Sense sense : {Sense::kAlong, Sense::kAgainst})
    if (is_closed(pass))
      add_closed(pass, sense, spacing_m, turning, out);
    else
      add_open(pass, sense, turning, out);
  return out;
}

EntriesByPass entries_by_pass(const Headland& headland, const Machine& machine) {
  const double spacing_m = std::max(kLeastEntrySpacing_m, kEntrySpacing_radii * machine.radius_m);
  EntriesByPass out;
  for (const HeadlandPass& pass : headland.passes)
    out.push_back(entries_of(pass, spacing_m, machine.turning));
  return out;
}

Path worked_path(const HeadlandPass& pass, const PassEntry& entry) {
  Path path = in_sense(pass, entry.sense);
  if (!is_closed(pass) || !(entry.entered_m > 0)) return path;
  Path out = path_between(path, entry.entered_m, length(path));
  const Path first = path_between(path, 0, entry.entered_m);
  out.insert(out.end(), first.begin(), first.end());
  return out;
}

SteeredPath axle_path(const HeadlandPass& pass, const PassEntry& entry, const Turning& turning) {
  const Path path = in_sense(pass, entry.sense);
  return is_closed(pass) ? closed_axle_path(path, entry.entered_m, turning) : axle_path(path, turning);
}

}  // namespace tramline
