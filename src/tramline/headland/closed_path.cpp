#include "tramline/headland/closed_path.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tramline/headland/tolerances.h"

namespace tramline {
namespace {

/// Appends an arc about `centre` from the unit vector `out`, in parts short enough to determine their centre
/// well.
void append_arc(Point centre, double radius_m, Point out, double angle, Path& path) {
  constexpr double kMost = 2;
  const int parts = std::max(1, static_cast<int>(std::ceil(std::abs(angle) / kMost)));
  const auto at = [&](int i) { return centre + radius_m * turned(out, angle * i / parts); };
  for (int i = 0; i < parts; ++i) path.push_back({at(i), at(i + 1), std::copysign(1 / radius_m, angle)});
}

void append_piece(const OffsetPiece& piece, double radius_m, Path& path) {
  const Point out = right_of(piece.from_heading);
  if (piece.segment.straight()) {
    path.push_back(
        {piece.segment.from + radius_m * out, piece.segment.to + radius_m * right_of(piece.to_heading), 0});
    return;
  }
  const double angle =
      std::atan2(cross(piece.from_heading, piece.to_heading), dot(piece.from_heading, piece.to_heading));
  append_arc(piece.centre, radius(piece.segment) - radius_m, -1.0 * out, angle, path);
}

/// Leaves out segments without length and lets each one begin where the one before ended.
Path linked(Path path) {
  std::erase_if(path, [](const PathSegment& s) { return distance(s.from, s.to) < kShortestPiece_m; });
  for (std::size_t i = 1; i < path.size(); ++i) path[i].from = path[i - 1].to;
  return path;
}

/// Appends a piece and the turn to the next one.
void append_piece_and_turn(const OffsetPiece& piece, const OffsetPiece& next, double radius_m, Path& path) {
  append_piece(piece, radius_m, path);
  const Path turn = turn_about(piece.segment.to, radius_m, piece.to_heading, next.from_heading);
  path.insert(path.end(), turn.begin(), turn.end());
}

}  // namespace

Path turn_about(Point centre, double radius_m, Point heading_before, Point heading_after) {
  double angle = std::atan2(cross(heading_before, heading_after), dot(heading_before, heading_after));
  if (angle < -0.5 * std::numbers::pi) angle += 2 * std::numbers::pi;  // straight back
  Path out;
  if (angle > kStraightOn_rad) append_arc(centre, radius_m, right_of(heading_before), angle, out);
  return out;
}

Path closed_path(const OffsetRing& ring, double radius_m) {
  Path path;
  for (std::size_t i = 0; i < ring.size(); ++i)
    append_piece_and_turn(ring[i], ring[(i + 1) % ring.size()], radius_m, path);
  path = linked(std::move(path));
  if (!path.empty()) path.front().from = path.back().to;
  return path;
}

Path open_path(const OffsetRing& way, double radius_m) {
  Path path;
  for (std::size_t i = 0; i + 1 < way.size(); ++i) append_piece_and_turn(way[i], way[i + 1], radius_m, path);
  if (!way.empty()) append_piece(way.back(), radius_m, path);
  return linked(std::move(path));
}

}  // namespace tramline
