#include "tramline/cost/worked/doubled_ground.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "tramline/cost/worked/worked_regions.h"
#include "tramline/geometry/index/box_grid.h"
#include "tramline/geometry/path/band_on_circles.h"
#include "tramline/geometry/path/kinked_line.h"
#include "tramline/geometry/polygon/boolean.h"
#include "tramline/geometry/tolerances.h"

namespace tramline {
namespace {

/// The parts in which curved pieces keep to their tracks, segment by segment.
class CurvedSwaths {
 public:
  explicit CurvedSwaths(const Plan& plan) : width_m_(plan.machine.width_m) {
    std::vector<Box> reaches;
    for (const TrackPiece& piece : plan.pieces) {
      if (piece.curve.empty()) continue;
      for (const Path& part : parts_on_track(piece)) {
        for (const Box& reach : reaches_of(part, width_m_)) reaches.push_back(reach);
        for (const PathSegment& segment : part) swaths_.push_back({segment, part_, piece.subfield});
        ++part_;
      }
    }
    grid_ = BoxGrid(reaches);
  }

  struct Swath {
    PathSegment line;
    std::size_t part = 0;  ///< index in its piece, whose swaths follow one another
    std::size_t subfield = 0;
  };
  const std::vector<Swath>& all() const { return swaths_; }

  /// Adds what the swath has in common with those of subfields from the given one on.
  void append_common_with(const Region& swath, const Box& window, std::size_t from_subfield,
                          Region& out) const {
    std::vector<std::size_t> near_by;
    grid_.each_meeting(window, [&](std::size_t i) {
      if (swaths_[i].subfield >= from_subfield) near_by.push_back(i);
    });
    std::sort(near_by.begin(), near_by.end());
    for (auto next = near_by.begin(); next != near_by.end();) {
      Path run;
      const std::size_t part = swaths_[*next].part;
      for (std::size_t i = *next; next != near_by.end() && *next == i && swaths_[i].part == part; ++next, ++i)
        run.push_back(swaths_[i].line);
      Region other;
      append_swath(run, width_m_, other);
      append_common(swath, other, out);
    }
  }

  static void append_common(const Region& a, const Region& b, Region& out) {
    for (const Polygon& one : a)
      for (const Polygon& other : b) {
        if (!intersects(bounds(one), bounds(other))) continue;
        for (Polygon& both : intersection({one}, {other}))
          if (!is_sliver(both)) out.push_back(std::move(both));
      }
  }

 private:
  double width_m_;
  std::vector<Swath> swaths_;  ///< piece by piece, along it
  std::size_t part_ = 0;
  BoxGrid grid_;
};

/// The swaths of straight pieces, in parts.
Region straight_swaths(const Plan& plan) {
  Region out;
  for (const TrackPiece& piece : plan.pieces) {
    if (!piece.curve.empty()) continue;
    for (Ring& part : swath_parts(piece, plan.machine.width_m, kLayerSagitta))
      out.push_back({std::move(part), {}});
  }
  return out;
}

bool has_several_curves(const Plan& plan) {
  return std::any_of(plan.pieces.begin(), plan.pieces.end(), [&plan](const TrackPiece& piece) {
    return !piece.curve.empty() && piece.subfield != plan.pieces.front().subfield;
  });
}

}  // namespace

bool is_sliver(const Polygon& part) { return area(part) < 0.5 * kLayerSagitta * perimeter(part.outer); }

void append_swath(const Path& path, double width_m, Region& out) {
  Polygon swath{band_on_circles(path, width_m, kLayerSagitta), {}};
  if (!find_invalidity(swath))
    out.push_back(std::move(swath));
  else
    for (Polygon& part : made_valid(swath)) out.push_back(std::move(part));
}

Region doubled_ground(const Plan& plan) {
  assert(std::none_of(plan.pieces.begin(), plan.pieces.end(),
                      [](const TrackPiece& piece) { return has_kinks(piece.curve); }));
  const double width_m = plan.machine.width_m;
  const Region straight = straight_swaths(plan);
  Region out = common_to_two(straight), before;
  const CurvedSwaths curved(plan);
  if (curved.all().empty()) return out;
  constexpr int kAll = 0;
  for (const TrackPiece& piece : plan.pieces) {
    if (piece.curve.empty()) continue;
    for (const Detour& detour : piece.detours) {
      Region swath;
      append_swath(detour.path, width_m, swath);
      CurvedSwaths::append_common(swath, before, out);
      CurvedSwaths::append_common(swath, straight, out);
      curved.append_common_with(swath, reach_of(detour.path, width_m), kAll, out);
      before.insert(before.end(), swath.begin(), swath.end());
    }
  }
  for (const Polygon& swath : straight) curved.append_common_with({swath}, bounds(swath), kAll, out);
  if (!has_several_curves(plan)) return out;
  for (const CurvedSwaths::Swath& swath : curved.all()) {
    Region ground;
    append_swath({swath.line}, width_m, ground);
    curved.append_common_with(ground, reach_of({swath.line}, width_m), swath.subfield + 1, out);
  }
  return out;
}

}  // namespace tramline
