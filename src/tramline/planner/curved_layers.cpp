#include "tramline/planner/curved_layers.h"

#include <utility>

#include "tramline/cost/recursive_tally.h"
#include "tramline/cost/worked_bands.h"
#include "tramline/cost/worked_regions.h"
#include "tramline/geometry/boolean.h"
#include "tramline/planner/worked_layers.h"

namespace tramline {
namespace {

void append_swath(const Path& path, double width_m, Region& out) {
  Polygon swath{band(path, width_m, kLayerSagitta), {}};
  // Round arcs of half the width the inner edge shrinks to a point, and chords may fold there.
  if (!find_invalidity(swath))
    out.push_back(std::move(swath));
  else
    for (Polygon& part : made_valid(swath)) out.push_back(std::move(part));
}

/// What the tracks work, and what the detours do. No part folds over itself.
std::vector<Region> worked_grounds(const Plan& plan) {
  const double width_m = plan.machine.width_m;
  std::vector<TrackPiece> on_track;
  Region by_detours;
  for (const TrackPiece& piece : plan.pieces) {
    for (Path& part : parts_on_track(piece)) {
      TrackPiece alone{part.front().from, part.back().to};
      alone.track = piece.track;
      alone.curve = std::move(part);
      on_track.push_back(std::move(alone));
    }
    for (const Detour& detour : piece.detours) append_swath(detour.path, width_m, by_detours);
  }
  if (plan.pieces.empty()) return {};
  std::vector<Region> out = worked_bands(plan.subfields.front().reference, on_track, width_m, kLayerSagitta);
  if (!by_detours.empty()) out.push_back(unite(by_detours));
  return out;
}

/// The parts of a path whose swaths reach into a box.
std::vector<Path> runs_near(const Path& path, double width_m, const Box& window) {
  const std::vector<Box> reaches = reaches_of(path, width_m);
  std::vector<Path> out;
  bool goes_on = false;
  for (std::size_t i = 0; i < path.size(); ++i) {
    const bool is_near = intersects(reaches[i], window);
    if (is_near && !goes_on) out.emplace_back();
    if (is_near) out.back().push_back(path[i]);
    goes_on = is_near;
  }
  return out;
}

void append_common(const Region& a, const Region& b, Region& out) {
  for (const Polygon& one : a)
    for (const Polygon& other : b) {
      if (!intersects(bounds(one), bounds(other))) continue;
      for (Polygon& both : intersection({one}, {other}))
        if (!is_sliver(both)) out.push_back(std::move(both));
    }
}

/// What detours work that other swaths do, too. Tracks are long, and a detour meets little of them.
Region doubled_by_detours(const Plan& plan) {
  const double width_m = plan.machine.width_m;
  Region out, before;
  for (const TrackPiece& with : plan.pieces)
    for (const Detour& detour : with.detours) {
      Region swath;
      append_swath(detour.path, width_m, swath);
      append_common(swath, before, out);
      const Box window = reach_of(detour.path, width_m);
      for (const TrackPiece& piece : plan.pieces)
        for (const Path& part : parts_on_track(piece))
          for (const Path& run : runs_near(part, width_m, window)) {
            Region other;
            append_swath(run, width_m, other);
            append_common(swath, other, out);
          }
      before.insert(before.end(), swath.begin(), swath.end());
    }
  return out;
}

}  // namespace

void add_curved_layers(Plan& plan) { add_layers(plan, {worked_grounds(plan), doubled_by_detours(plan)}); }

void add_kinked_layers(Plan& plan, const CurvedCandidate& candidate) {
  add_layers(plan, {{candidate.worked},
                    common_to_two(kinked_swaths(candidate.tracks.pieces, plan.machine.width_m))});
}

}  // namespace tramline
