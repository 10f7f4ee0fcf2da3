#include "tramline/cost/worked/worked_rows.h"

#include <map>

namespace tramline {
namespace {

/// The worked parts of each strip.
std::map<int, Intervals> worked_by_strip(const LaidTracks& tracks) {
  std::map<int, Intervals> out;
  for (const LaidPiece& piece : tracks.pieces)
    for (const Interval& part : parts_on_track(piece)) append_joining(out[piece.track], part);
  return out;
}

const Intervals& in_strip(const std::map<int, Intervals>& worked, int strip) {
  static const Intervals nothing;
  const auto found = worked.find(strip);
  return found == worked.end() ? nothing : found->second;
}

}  // namespace

void append_edges_along(double line, const Intervals& left, const Intervals& right,
                        std::vector<DirectedEdge>& out) {
  for (const Interval& bare : without(left, right)) out.push_back({{line, bare.from}, {line, bare.to}});
  for (const Interval& bare : without(right, left)) out.push_back({{line, bare.to}, {line, bare.from}});
}

Region worked_rows(const LaidTracks& tracks) {
  const std::map<int, Intervals> worked = worked_by_strip(tracks);
  const StripGrid& grid = tracks.grid;
  std::vector<DirectedEdge> edges;
  for (const auto& [strip, parts] : worked) {
    const double left = grid.line(strip), right = grid.line(strip + 1);
    append_edges_along(left, in_strip(worked, strip - 1), parts, edges);
    if (!worked.contains(strip + 1)) append_edges_along(right, parts, {}, edges);
    for (const Interval& part : parts) {
      edges.push_back({{left, part.from}, {right, part.from}});
      edges.push_back({{right, part.to}, {left, part.to}});
    }
  }
  return grid.frame.to_field(faces_of(std::move(edges)));
}

}  // namespace tramline
