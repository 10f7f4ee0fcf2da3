#include "tramline/cost/worked/piece_overlap.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <iterator>
#include <utility>

#include "tramline/cost/tolerances.h"
#include "tramline/geometry/path/kinked_line.h"
#include "tramline/geometry/path/newly_covered_area.h"
#include "tramline/geometry/strip/track_frame.h"
#include "tramline/geometry/tolerances.h"

namespace tramline {
namespace {

/// The body in the frame of a subfield's tracks, so that the window of a swath holds few of its edges.
struct TurnedBody {
  TrackFrame frame;
  std::vector<Ring> rings;
};

std::vector<TurnedBody> turned_bodies(const Region& body, const std::vector<Subfield>& subfields) {
  std::vector<TurnedBody> out;
  for (const Subfield& subfield : subfields) {
    const TrackFrame frame(subfield.direction);
    out.push_back({frame, rings_of(frame.to_track(body))});
  }
  return out;
}

/// Straight swaths of one grid lie beside or behind one another; lines over gaps may lie half over each
/// other. Swaths along curves of one family have no area in common where they keep to their tracks.
bool may_meet(const TrackPiece& a, const TrackPiece& b, double width_m) {
  if (a.subfield != b.subfield || !a.detours.empty() || !b.detours.empty()) return true;
  if (!a.curve.empty() || !b.curve.empty()) return false;
  const double length_m = distance(b.start, b.end);
  const Point along = (1 / length_m) * (b.end - b.start);
  if (std::abs(cross(along, a.start - b.start)) > width_m - kSamePlace_m) return false;
  const double one = dot(along, a.start - b.start), other = dot(along, a.end - b.start);
  return std::max(one, other) > kSamePlace_m && std::min(one, other) < length_m - kSamePlace_m;
}

/// A piece with its path.
struct DrivenLine {
  const TrackPiece& piece;
  Path line;
  std::vector<Box> reaches;  ///< by segment
  Box reach;
};

DrivenLine driven_line(const TrackPiece& piece, double width_m) {
  DrivenLine out{piece, centre_line(piece), {}, {}};
  out.reaches = reaches_of(out.line, width_m);
  for (const Box& box : out.reaches) out.reach.extend(box);
  return out;
}

/// Adds the area of a later piece that an earlier one may have worked, in the field's frame: parts may be
/// added twice.
void append_covered(const DrivenLine& before, const DrivenLine& now, double width_m, std::vector<Path>& out) {
  if (!may_meet(before.piece, now.piece, width_m) || !intersects(before.reach, now.reach)) return;
  const auto append = [&out](std::vector<Path> runs) {
    std::move(runs.begin(), runs.end(), std::back_inserter(out));
  };
  if (before.piece.curve.empty() && now.piece.curve.empty()) {
    out.push_back(before.line);
  } else if (before.piece.subfield != now.piece.subfield) {
    append(runs_near(before.line, before.reaches, now.reaches));
  } else {
    // Except for detours they have no area in common.
    for (const Detour& detour : before.piece.detours)
      append(runs_near(detour.path, reaches_of(detour.path, width_m), now.reaches));
    for (const Detour& detour : now.piece.detours)
      append(runs_near(before.line, before.reaches, reaches_of(detour.path, width_m)));
  }
}

/// A curved piece without detours states the area of its swath outside its own subfield. That is its overlap
/// where there is no other subfield to work in.
bool has_its_own_overlap(const TrackPiece& piece, const std::vector<Subfield>& subfields) {
  return !piece.curve.empty() && piece.detours.empty() &&
         (subfields.size() == 1 || *piece.overlap_m2 < kNoOverlap_m2);
}

}  // namespace

std::vector<double> overlap_by_piece(const Region& body, const std::vector<Subfield>& subfields,
                                     const std::vector<TrackPiece>& pieces, double width_m) {
  assert(std::all_of(pieces.begin(), pieces.end(), [&subfields](const TrackPiece& piece) {
    return (piece.curve.empty() || (piece.overlap_m2 && !has_kinks(piece.curve))) &&
           piece.subfield < subfields.size();
  }));
  const std::vector<TurnedBody> bodies = turned_bodies(body, subfields);
  std::vector<DrivenLine> driven;
  std::vector<double> out;
  for (const TrackPiece& piece : pieces) {
    driven.push_back(driven_line(piece, width_m));
    std::vector<Path> taken;
    for (std::size_t i = 0; i + 1 < driven.size(); ++i)
      append_covered(driven[i], driven.back(), width_m, taken);
    if (has_its_own_overlap(piece, subfields) && taken.empty()) {
      out.push_back(*piece.overlap_m2);
      continue;
    }
    const TurnedBody& turned = bodies[piece.subfield];
    const auto in_frame = [&turned](const Path& line) {
      return moved(line, [&turned](Point p) { return turned.frame.to_track(p); });
    };
    const Path own = in_frame(driven.back().line);
    const Box window = reach_of(own, width_m);
    RisingCurves curves;
    for (const Ring& ring : turned.rings) append_ring(ring, Layer::kBody, window, curves);
    for (const Path& line : taken) append_band(in_frame(line), width_m, Layer::kCovered, curves);
    append_band(own, width_m, Layer::kNew, curves);
    out.push_back(std::max(0.0, width_m * length(own) - newly_covered_area(curves)));
  }
  return out;
}

}  // namespace tramline
