#include "tramline/headland/rolling_circle_path.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

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

/// Of a part of a curve that long by its own measure.
double length_m(const OffsetCurve& curve, double extent) {
  return curve.straight() ? extent : extent * curve.radius;
}

double length_m(const CentreLine& centre_line) {
  return length_m(centre_line.curve, centre_line.curve.extent);
}

/// What the circle leaves out of the stages where it comes to touch another one.
double skipped_m(const std::vector<Stage>& stages, std::size_t on, const Touch& touch) {
  const Stage &here = stages[on], &there = stages[touch.stage];
  double out = length_m(here.centre_line->curve, here.last - touch.here) +
               length_m(there.centre_line->curve, touch.there - there.first);
  for (std::size_t k = on + 1; k < touch.stage; ++k) out += length_m(*stages[k].centre_line);
  return out;
}

/// Of the touches of a stage the first at which the circle's arc fits and no more is left out.
std::optional<Touch> first_that_fits(const std::vector<Stage>& stages, std::size_t on,
                                     const std::vector<Touch>& found, const ArcFits& fits,
                                     double most_skipped_m) {
  const auto first = std::find_if(found.begin(), found.end(), [&](const Touch& touch) {
    return skipped_m(stages, on, touch) <= most_skipped_m &&
           fits(touch.centre, touch.heading_before, touch.heading_after);
  });
  return first == found.end() ? std::nullopt : std::optional(*first);
}

/// The line of the centre along all stages, of which no more than so much is left out at once.
std::optional<OffsetRing> rolled_along(const std::vector<Stage>& way, const ArcFits& fits,
                                       double most_skipped_m) {
  OffsetRing out;
  double at = way.front().first;
  for (std::size_t on = 0; on + 1 < way.size();) {
    const std::optional<Touch> first =
        first_that_fits(way, on, touches(way, on, at, way.size()), fits, most_skipped_m);
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

/// The stages of a ring, repeated three times, and a walk along them.
class Walk {
 public:
  Walk(const std::vector<CentreLine>& centre_lines, std::size_t start, const ArcFits& fits,
       double most_skipped_m)
      : fits_(fits), most_skipped_m_(most_skipped_m) {
    std::size_t centre_line = start;
    do {
      ring_.push_back(centre_line);
      stages_.push_back({&centre_lines[centre_line], 0, centre_lines[centre_line].curve.extent});
      centre_line = centre_lines[centre_line].next;
    } while (centre_line != start);
    for (int i = 0; i < 2; ++i)
      stages_.insert(stages_.end(), stages_.begin(), stages_.begin() + std::ssize(ring_));
  }

  /// The part of a stage along which the circle rolls.
  struct Stretch {
    std::size_t on = 0;  ///< number of the stage
    double first = 0;
    double last = 0;
  };
  struct Walked {
    std::vector<std::vector<Stretch>> ways{{}};  ///< a new one behind each kink
    std::optional<std::size_t> behind_kink{};    ///< the stage behind the first kink that ended a way
  };

  /// Goes round once or twice. Precondition: from a stage of the first round, twice from the first stage
  /// only.
  Walked go(std::size_t from, std::size_t rounds) const {
    assert(from + (rounds + 1) * round() <= stages_.size());
    Walked out;
    double at = 0;
    for (std::size_t on = from; on < from + rounds * round();) {
      const std::optional<Touch> next =
          first_that_fits(stages_, on, touches(stages_, on, at, reach_from(on)), fits_, 2 * most_skipped_m_);
      const double end = next ? next->here : stages_[on].last;
      if (end > at) out.ways.back().push_back({on, at, end});
      if (!next && !stages_[on].centre_line->straight_on) {
        if (!out.behind_kink) out.behind_kink = on + 1;
        out.ways.emplace_back();
      }
      at = next ? next->there : 0;
      on = next ? next->stage : on + 1;
    }
    return out;
  }

  /// The number of stages.
  std::size_t round() const { return ring_.size(); }
  /// Index of the centre line.
  std::size_t centre_line_of(const Stretch& stretch) const { return ring_[stretch.on % round()]; }

 private:
  /// The first stage too far ahead to be reached from this one.
  std::size_t reach_from(std::size_t on) const {
    double skipped_m = 0;
    std::size_t k = on + 1;
    while (k + 1 < on + round() && skipped_m <= most_skipped_m_)
      skipped_m += length_m(*stages_[k++].centre_line);
    return k;
  }

  const ArcFits& fits_;
  double most_skipped_m_;
  std::vector<std::size_t> ring_;
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
      // Offset lines have no arc about a corner that turns by less.
      out.back().straight_on =
          std::abs(std::atan2(cross(before, after), dot(before, after))) <= kNoCorner_rad;
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
  return rolled_along(stages(centre_lines, from, to), fits, std::numeric_limits<double>::infinity());
}

RollingCirclePaths rolling_circle_paths(const std::vector<CentreLine>& centre_lines, std::size_t start,
                                        const ArcFits& fits, double most_skipped_m) {
  const Walk walk(centre_lines, start, fits, most_skipped_m);
  RollingCirclePaths out;
  // In the first round the circle has not come to where it begins yet, and may not get there.
  const Walk::Walked twice = walk.go(0, 2);
  if (twice.behind_kink) {
    for (const std::vector<Walk::Stretch>& way : walk.go(*twice.behind_kink % walk.round(), 1).ways) {
      OffsetRing ring;
      for (const Walk::Stretch& stretch : way)
        ring.push_back(
            piece_between(centre_lines[walk.centre_line_of(stretch)], stretch.first, stretch.last));
      if (!ring.empty()) out.open.push_back(std::move(ring));
    }
    return out;
  }
  // Where it passes for sure: on the way of the second round, and best not near its ends.
  const std::vector<Walk::Stretch>& way = twice.ways.front();
  const auto length_in_second_round_m = [&](const Walk::Stretch& stretch) {
    if (stretch.on < walk.round()) return 0.0;
    return length_m(centre_lines[walk.centre_line_of(stretch)].curve, stretch.last - stretch.first);
  };
  const auto longest = std::ranges::max_element(way, {}, length_in_second_round_m);
  if (longest == way.end()) return out;
  const std::size_t line = walk.centre_line_of(*longest);
  const double from = std::lerp(longest->first, longest->last, 0.4);
  const double to = std::lerp(longest->first, longest->last, 0.6);
  out.closed = rolled_along(stages(centre_lines, {line, to}, {line, from}), fits, 2 * most_skipped_m);
  if (out.closed) out.closed->push_back(piece_between(centre_lines[line], from, to));
  return out;
}

}  // namespace tramline
