#include "tramline/route/build/passes_among_tracks.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "tramline/route/build/tour_as_driven.h"
#include "tramline/route/passes/passes_round_obstacles.h"

namespace tramline {
namespace {

/// Drives the passes that come behind a track; false where none do. `next`: where the route goes on.
bool drive_passes_behind(std::size_t track, const std::vector<PassesAmongTracks>& among, Point next,
                         RouteDriver& driver) {
  PassGroup group;
  for (const PassesAmongTracks& one : among)
    if (one.behind == track) std::ranges::copy(one.passes, std::back_inserter(group.passes));
  if (group.passes.empty()) return false;
  group.ahead = next;
  driver.drive_passes(group);
  return true;
}

/// The way to a track behind another one, or to the first. `as_before`: the same works were driven up to here
/// as when it was driven last.
Way way_to_track(std::size_t i, OrderedTracks& tracks, bool as_before, RouteDriver& driver) {
  const bool known = i < tracks.as_driven.size();
  if (known && (as_before || !tracks.as_driven[i].backs_out)) return tracks.as_driven[i];
  const SteeredPath& work = driver.sense_of(tracks.tour[i]).first;
  Way way = tracks.found[i];
  if (i > 0) way = way_on(way, driver.so_far().left, work, driver.context().connector);
  way = driver.as_driven(std::move(way), work);
  if (!known) tracks.as_driven.push_back(way);
  return way;
}

std::vector<DrivenTrack> as_driven(const order::Tour& tour, const RouteDriver& driver) {
  std::vector<DrivenTrack> out;
  for (const order::End entered : tour) {
    const DrivenSense& sense = driver.sense_of(entered);
    out.push_back(
        {&driver.context().lines[order::line_of(entered)], sense.first.front().start, end_of(sense.last)});
  }
  return out;
}

std::vector<Point> places_on(const std::vector<std::size_t>& passes, const EntriesByPass& entries) {
  std::vector<Point> out;
  for (const std::size_t pass : passes)
    for (const PassEntry& entry : entries[pass]) out.push_back(entry.entered.at);
  return out;
}

}  // namespace

void drive_tracks(RouteDriver& driver, OrderedTracks& tracks, const std::vector<PassesAmongTracks>& among) {
  bool as_before = true;
  for (std::size_t i = 0; i < tracks.tour.size(); ++i) {
    const SteeredPath& work = driver.sense_of(tracks.tour[i]).first;
    const bool behind_passes = i > 0 && drive_passes_behind(i - 1, among, work.front().start.at, driver);
    as_before = as_before && !behind_passes;
    driver.drive_line(behind_passes ? driver.as_driven(driver.way_to(work), work)
                                    : way_to_track(i, tracks, as_before, driver),
                      tracks.tour[i]);
  }
}

void drive_with_passes_among_tracks(RouteDriver& driver, const order::Tour& tour,
                                    const std::vector<std::size_t>& closed, std::optional<Point> ahead,
                                    const DrivePart& drive_part) {
  const RouteTask& task = driver.task();
  const LeastSeconds& least = driver.context().least;
  const std::vector<DrivenTrack> tracks = as_driven(tour, driver);
  std::vector<PassesAmongTracks> among;
  drive_part(among);
  for (std::vector<std::size_t>& passes : passes_round_obstacles(task.headland, closed)) {
    const auto behind =
        track_before(tracks, places_on(passes, driver.context().entries), task.machine.width_m);
    if (!behind) continue;
    const RouteSoFar without = driver.so_far();
    among.push_back({*behind, std::move(passes)});
    drive_part(among);
    if (effort(driver.so_far(), ahead, least) < effort(without, ahead, least)) continue;
    driver.go_back_to(without);
    among.pop_back();
  }
}

}  // namespace tramline
