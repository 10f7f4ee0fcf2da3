#include "tramline/headland/rolling_circle_path.h"

#include <algorithm>
#include <cmath>

#include "tramline/headland/tolerances.h"

namespace tramline {
namespace {

CentreLine centre_line_along(const OffsetPiece& piece, double radius_m) {
  const Point from = piece.segment.from + radius_m * left_of(piece.from_heading);
  const Point to = piece.segment.to + radius_m * left_of(piece.to_heading);
  if (piece.segment.straight()) return {offset_line(from, to), piece.offset_boundary, 0, false};
  return {offset_arc(piece.centre, radius(piece.segment) + radius_m, from, to), piece.offset_boundary, 0,
          false};
}

double slack_on(const OffsetCurve& curve) {
  return curve.straight() ? kBeyondCentreLine_m : kBeyondCentreLine_m / curve.radius;
}

/// The part of a centre line that belongs to the way.
struct Stage {
  const CentreLine* centre_line = nullptr;
  double first = 0;
  double last = 0;

  bool has(double position) const {
    const double slack = slack_on(centre_line->curve);
    return position >= first - slack && position <= last + slack;
  }
};

std::vector<Stage> stages(const std::vector<CentreLine>& centre_lines, CentrePosition from,
                          CentrePosition to) {
  std::vector<Stage> out;
  const auto extent = [&](std::size_t centre_line) { return centre_lines[centre_line].curve.extent; };
  if (from.centre_line == to.centre_line && from.at <= to.at)
    return {{&centre_lines[from.centre_line], from.at, to.at}};
  out.push_back({&centre_lines[from.centre_line], from.at, extent(from.centre_line)});
  for (std::size_t centre_line = centre_lines[from.centre_line].next; centre_line != to.centre_line;
       centre_line = centre_lines[centre_line].next)
    out.push_back({&centre_lines[centre_line], 0, extent(centre_line)});
  out.push_back({&centre_lines[to.centre_line], 0, to.at});
  return out;
}

/// The point where the circle, rolling along one centre line, comes to touch the piece of another.
struct Touch {
  double here = 0;
  std::size_t stage = 0;
  double there = 0;
  Point centre;
  Point heading_before, heading_after;
};

/// Touches of stages before `end`, in the order in which the circle reaches them.
std::vector<Touch> touches(const std::vector<Stage>& stages, std::size_t on, double at, std::size_t end) {
  // A circle that leaves what it touched turns right.
  std::vector<Touch> out;
  const OffsetCurve& here = stages[on].centre_line->curve;
  for (std::size_t k = on + 1; k < end; ++k) {
    const OffsetCurve& there = stages[k].centre_line->curve;
    if (!intersects(here.box, there.box)) continue;
    for (const Point p : meetings(here, there)) {
      const double a = position_on(here, p), b = position_on(there, p);
      if (!stages[on].has(a) || a < at - slack_on(here) || !stages[k].has(b)) continue;
      const Point before = heading_at(here, p), after = heading_at(there, p);
      if (cross(before, after) < kLeastKink_rad) continue;
      out.push_back({std::max(a, at), k, std::max(b, stages[k].first), p, before, after});
    }
  }
  std::stable_sort(out.begin(), out.end(), [](const Touch& a, const Touch& b) { return a.here < b.here; });
  return out;
}

std::optional<Touch> first_that_fits(const std::vector<Touch>& found, const ArcFits& fits) {
  const auto first = std::find_if(found.begin(), found.end(), [&](const Touch& touch) {
    return fits(touch.centre, touch.heading_before, touch.heading_after);
  });
  return first == found.end() ? std::nullopt : std::optional(*first);
}

double length_m(const CentreLine& centre_line) {
  return centre_line.curve.straight() ? centre_line.curve.extent
                                      : centre_line.curve.extent * centre_line.curve.radius;
}

/// The stages of a ring, repeated three times, and a walk along them.
class Walk {
 public:
  Walk(const std::vector<CentreLine>& centre_lines, std::size_t start, const ArcFits& fits,
       double most_skipped_m)
      : fits_(fits), most_skipped_m_(most_skipped_m) {
    std::size_t centre_line = start;
    do {
      stages_.push_back({&centre_lines[centre_line], 0, centre_lines[centre_line].curve.extent});
      centre_line = centre_lines[centre_line].next;
    } while (centre_line != start);
    round_ = stages_.size();
    for (int i = 0; i < 2; ++i)
      stages_.insert(stages_.end(), stages_.begin(), stages_.begin() + static_cast<std::ptrdiff_t>(round_));
  }

  /// Goes round once from a stage. Returns the stage behind the first kink that ended a way; nullopt where
  /// there was none.
  std::optional<std::size_t> go(std::size_t from, std::vector<OffsetRing>& ways) const {
    std::optional<std::size_t> behind_first;
    OffsetRing now;
    double at = 0;
    for (std::size_t on = from; on < from + round_;) {
      const std::optional<Touch> next = first_that_fits(touches(stages_, on, at, reach_from(on)), fits_);
      const double end = next ? next->here : stages_[on].last;
      if (end > at) now.push_back(piece_between(*stages_[on].centre_line, at, end));
      if (!next && !stages_[on].centre_line->straight_on) {
        if (!behind_first) behind_first = on + 1;
        ways.push_back(std::move(now));
        now.clear();
      }
      at = next ? next->there : 0;
      on = next ? next->stage : on + 1;
    }
    ways.push_back(std::move(now));
    std::erase_if(ways, [](const OffsetRing& way) { return way.empty(); });
    return behind_first;
  }

 private:
  /// The first stage too far ahead to be reached from this one.
  std::size_t reach_from(std::size_t on) const {
    double skipped_m = 0;
    std::size_t k = on + 1;
    while (k + 1 < on + round_ && skipped_m <= most_skipped_m_)
      skipped_m += length_m(*stages_[k++].centre_line);
    return k;
  }

  const ArcFits& fits_;
  double most_skipped_m_;
  std::size_t round_ = 0;
  std::vector<Stage> stages_;
};

}  // namespace

std::vector<CentreLine> centre_lines_along(const std::vector<OffsetRing>& offset_lines, double radius_m) {
  std::vector<CentreLine> out;
  for (const OffsetRing& ring : offset_lines) {
    std::vector<const OffsetPiece*> pieces;
    for (const OffsetPiece& piece : ring)
      if (distance(piece.segment.from, piece.segment.to) > kShortestPiece_m) pieces.push_back(&piece);
    const std::size_t first = out.size(), n = pieces.size();
    for (std::size_t i = 0; i < n; ++i) {
      const Point before = pieces[i]->to_heading, after = pieces[(i + 1) % n]->from_heading;
      out.push_back(centre_line_along(*pieces[i], radius_m));
      out.back().next = first + (i + 1) % n;
      out.back().straight_on =
          std::abs(std::atan2(cross(before, after), dot(before, after))) < kStraightOn_rad;
    }
  }
  return out;
}

OffsetPiece piece_between(const CentreLine& centre_line, double from, double to) {
  const Point a = point_at(centre_line.curve, from), b = point_at(centre_line.curve, to);
  return {{a, b, curvature(centre_line.curve)},
          centre_line.curve.centre,
          heading_at(centre_line.curve, a),
          heading_at(centre_line.curve, b),
          centre_line.offset_boundary};
}

std::optional<OffsetRing> rolling_circle_path(const std::vector<CentreLine>& centre_lines,
                                              CentrePosition from, CentrePosition to, const ArcFits& fits) {
  const std::vector<Stage> way = stages(centre_lines, from, to);
  OffsetRing out;
  double at = from.at;
  for (std::size_t on = 0; on + 1 < way.size();) {
    const std::optional<Touch> first = first_that_fits(touches(way, on, at, way.size()), fits);
    if (!first && !way[on].centre_line->straight_on) return std::nullopt;
    const double end = first ? first->here : way[on].last;
    if (end > at) out.push_back(piece_between(*way[on].centre_line, at, end));
    at = first ? first->there : way[on + 1].first;
    on = first ? first->stage : on + 1;
  }
  if (at > way.back().last + slack_on(way.back().centre_line->curve)) return std::nullopt;
  if (way.back().last > at) out.push_back(piece_between(*way.back().centre_line, at, way.back().last));
  return out;
}

RollingCirclePaths rolling_circle_paths(const std::vector<CentreLine>& centre_lines, std::size_t start,
                                        const ArcFits& fits, double most_skipped_m) {
  const Walk walk(centre_lines, start, fits, most_skipped_m);
  RollingCirclePaths out;
  const std::optional<std::size_t> behind_kink = walk.go(0, out.open);
  if (behind_kink) {
    out.open.clear();
    walk.go(*behind_kink, out.open);
    return out;
  }
  out.open.clear();
  const double extent = centre_lines[start].curve.extent, from = 0.4 * extent, to = 0.6 * extent;
  out.closed = rolling_circle_path(centre_lines, {start, to}, {start, from}, fits);
  if (out.closed) out.closed->push_back(piece_between(centre_lines[start], from, to));
  return out;
}

}  // namespace tramline
