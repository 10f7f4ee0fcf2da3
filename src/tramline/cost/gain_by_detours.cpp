#include "tramline/cost/gain_by_detours.h"

#include <algorithm>
#include <utility>

#include "tramline/geometry/box_grid.h"
#include "tramline/geometry/layered_area.h"

namespace tramline {
namespace {

/// Where pieces keep to their tracks, segment by segment.
class Kept {
 public:
  Kept(const std::vector<TrackPiece>& pieces, double width_m) : width_m_(width_m) {
    std::vector<Box> reaches;
    for (std::size_t i = 0; i < pieces.size(); ++i)
      for (const Path& part : parts_on_track(pieces[i])) {
        for (const Box& reach : reaches_of(part, width_m)) reaches.push_back(reach);
        for (const PathSegment& segment : part) segments_.emplace_back(i, segment);
      }
    grid_ = BoxGrid(reaches);
  }

  /// The segments whose swaths reach into the window, those of one piece after those of another.
  std::vector<std::size_t> near_by(const Box& window) const {
    std::vector<std::size_t> out;
    grid_.each_meeting(window, [&out](std::size_t i) { out.push_back(i); });
    std::sort(out.begin(), out.end());
    return out;
  }

  std::size_t piece_of(std::size_t segment) const { return segments_[segment].first; }
  void append(std::size_t segment, RisingCurves& out) const {
    append_band({segments_[segment].second}, width_m_, Layer::kTaken, out);
  }

 private:
  double width_m_;
  std::vector<std::pair<std::size_t, PathSegment>> segments_;
  BoxGrid grid_;
};

/// What one detour of a piece works before all others where nobody keeps to a track, and what of that those
/// lose who come later and do. `curves` has the body, the detour and the detours before it.
void account(const Kept& kept, std::size_t piece, const Box& window, RisingCurves curves,
             std::vector<double>& gains) {
  const std::vector<std::size_t> near_by = kept.near_by(window);
  auto next = near_by.begin();
  for (; next != near_by.end() && kept.piece_of(*next) <= piece; ++next) kept.append(*next, curves);
  double left_m2 = new_area(curves);
  gains[piece] += left_m2;
  while (next != near_by.end()) {
    const std::size_t later = kept.piece_of(*next);
    for (; next != near_by.end() && kept.piece_of(*next) == later; ++next) kept.append(*next, curves);
    const double less_m2 = new_area(curves);
    gains[later] -= left_m2 - less_m2;
    left_m2 = less_m2;
  }
}

}  // namespace

std::vector<double> gain_by_detours_m2(const Region& body, const std::vector<TrackPiece>& pieces,
                                       double width_m) {
  std::vector<double> out(pieces.size(), 0);
  if (std::all_of(pieces.begin(), pieces.end(),
                  [](const TrackPiece& piece) { return piece.detours.empty(); }))
    return out;
  const Kept kept(pieces, width_m);
  const std::vector<Ring> rings = rings_of(body);
  std::vector<std::pair<Box, const Path*>> before;
  for (std::size_t i = 0; i < pieces.size(); ++i)
    for (const Detour& detour : pieces[i].detours) {
      const Box window = reach_of(detour.path, width_m);
      RisingCurves curves;
      for (const Ring& ring : rings) append_ring(ring, Layer::kBody, window, curves);
      append_band(detour.path, width_m, Layer::kNew, curves);
      for (const auto& [reach, path] : before)
        if (intersects(reach, window)) append_band(*path, width_m, Layer::kTaken, curves);
      account(kept, i, window, std::move(curves), out);
      before.emplace_back(window, &detour.path);
    }
  return out;
}

}  // namespace tramline
