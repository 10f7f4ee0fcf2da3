#include "tramline/check/lines/track_line.h"

#include <utility>

namespace tramline::check {

std::optional<TrackPosition> TrackLine::position_of(Point p) const {
  return std::visit([p](const auto& line) { return line.position_of(p); }, line_);
}

Walk TrackLine::walk(const TrackPosition& from, const TrackPosition& to) const {
  return std::visit([&](const auto& line) { return line.walk(from, to); }, line_);
}

std::optional<Path> TrackLine::between(Point from, Point heading, Point to) const {
  const std::optional<TrackPosition> first = position_of(from), last = position_of(to);
  if (!first || !last) return std::nullopt;
  // On a straight line there is one way between two positions, whatever the heading at the first.
  const bool back =
      std::holds_alternative<StraightLine>(line_) ? before(*last, *first) : dot(heading, first->heading) < 0;
  Walk way = back ? walk(*last, *first) : walk(*first, *last);
  if (way.end != WalkEnd::kReached || way.path.empty()) return std::nullopt;
  return back ? reversed(way.path) : std::move(way.path);
}

bool TrackLine::may_close() const {
  const auto* parallel = std::get_if<ParallelLine>(&line_);
  return parallel != nullptr && parallel->may_close();
}

}  // namespace tramline::check
