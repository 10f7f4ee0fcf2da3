#include "tramline/cost/piece_overlap.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "tramline/geometry/layered_area.h"
#include "tramline/geometry/track_frame.h"

namespace tramline {
namespace {

/// The body as a subfield's tracks see it: along them, so that the window of a swath holds few of its edges.
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
/// other.
bool may_meet(const TrackPiece& a, const TrackPiece& b, double width_m) {
  constexpr double kTouch_m = 1e-6;
  if (a.subfield != b.subfield || !a.detours.empty() || !b.detours.empty()) return true;
  const double length_m = distance(b.start, b.end);
  const Point along = (1 / length_m) * (b.end - b.start);
  if (std::abs(cross(along, a.start - b.start)) > width_m - kTouch_m) return false;
  const double one = dot(along, a.start - b.start), other = dot(along, a.end - b.start);
  return std::max(one, other) > kTouch_m && std::min(one, other) < length_m - kTouch_m;
}

}  // namespace

std::vector<double> overlap_by_piece(const Region& body, const std::vector<Subfield>& subfields,
                                     const std::vector<TrackPiece>& pieces, double width_m) {
  assert(std::all_of(pieces.begin(), pieces.end(), [&subfields](const TrackPiece& piece) {
    return piece.curve.empty() && piece.subfield >= 0 &&
           static_cast<std::size_t>(piece.subfield) < subfields.size();
  }));
  const std::vector<TurnedBody> bodies = turned_bodies(body, subfields);
  std::vector<Path> lines;
  std::vector<Box> reaches;
  std::vector<double> out;
  for (const TrackPiece& piece : pieces) {
    lines.push_back(centre_line(piece));
    reaches.push_back(reach_of(lines.back(), width_m));
    const TurnedBody& turned = bodies[static_cast<std::size_t>(piece.subfield)];
    const auto in_frame = [&turned](const Path& line) {
      return moved(line, [&turned](Point p) { return turned.frame.to_track(p); });
    };
    const Path own = in_frame(lines.back());
    const Box window = reach_of(own, width_m);
    RisingCurves curves;
    for (const Ring& ring : turned.rings) append_ring(ring, Layer::kBody, window, curves);
    for (std::size_t i = 0; i + 1 < lines.size(); ++i)
      if (may_meet(pieces[i], piece, width_m) && intersects(reaches[i], reaches.back()))
        append_band(in_frame(lines[i]), width_m, Layer::kTaken, curves);
    append_band(own, width_m, Layer::kNew, curves);
    out.push_back(std::max(0.0, width_m * length(own) - new_area(curves)));
  }
  return out;
}

}  // namespace tramline
