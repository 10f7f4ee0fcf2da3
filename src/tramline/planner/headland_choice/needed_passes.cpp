#include "tramline/planner/headland_choice/needed_passes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "tramline/planner/headland_choice/boundary_ahead.h"
#include "tramline/planner/headland_choice/whole_sides.h"
#include "tramline/route/turning/planned_turns.h"
#include "tramline/turns/outline/outline.h"
#include "tramline/turns/outline/swept_reach.h"
#include "tramline/turns/room/places_off.h"
#include "tramline/turns/turn_off.h"
#include "tramline/turns/turn_table.h"

namespace tramline {
namespace {

/// Depths that exceed whole passes by less need no further pass, m: what check allows a turn to be off.
constexpr double kSameDepth_m = 1e-3;

int passes_needed(double depth_m, double width_m) { return passes_for(depth_m - kSameDepth_m, width_m); }

/// A stretch of the outer ring, from one place to another anticlockwise along its vertices, and the passes
/// that a turn needs there.
struct PassesAlong {
  double from_m = 0;
  double to_m = 0;  ///< beyond the ring's length where it goes on past its first vertex
  int passes = 0;
};

class Sides {
 public:
  Sides(const Ring& ring, double gap_m) : ring_(ring), gap_m_(gap_m) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      begins_m_.push_back(whole_m_);
      whole_m_ += distance(ring[i], ring[(i + 1) % ring.size()]);
    }
  }

  void require(double a_m, double b_m, int passes) {
    if (passes == 0) return;
    double from_m = std::min(a_m, b_m), to_m = std::max(a_m, b_m);
    if (to_m - from_m > 0.5 * whole_m_) {
      std::swap(from_m, to_m);
      to_m += whole_m_;
    }
    stretches_.push_back({from_m, to_m, passes});
  }

  /// Between two turns that are no farther apart than `gap_m` the passes run on.
  std::vector<int> by_edge() {
    std::sort(stretches_.begin(), stretches_.end(),
              [](const PassesAlong& a, const PassesAlong& b) { return a.from_m < b.from_m; });
    std::vector<PassesAlong> all = stretches_;
    for (std::size_t i = 0; i < stretches_.size(); ++i) {
      const PassesAlong& next = stretches_[(i + 1) % stretches_.size()];
      const double next_m = next.from_m + (i + 1 == stretches_.size() ? whole_m_ : 0);
      const double gap = next_m - stretches_[i].to_m;
      if (gap > 0 && gap <= gap_m_)
        all.push_back({stretches_[i].to_m, next_m, std::max(stretches_[i].passes, next.passes)});
    }
    std::vector<int> out(ring_.size(), 0);
    for (const PassesAlong& stretch : all) mark(stretch, out);
    return out;
  }

 private:
  void mark(const PassesAlong& stretch, std::vector<int>& out) const {
    for (std::size_t i = 0; i < ring_.size(); ++i) {
      const double begin_m = begins_m_[i], end_m = i + 1 < ring_.size() ? begins_m_[i + 1] : whole_m_;
      for (const double shift_m : {0.0, whole_m_})
        if (stretch.from_m < end_m + shift_m && stretch.to_m > begin_m + shift_m)
          out[i] = std::max(out[i], stretch.passes);
    }
  }

  const Ring& ring_;
  double gap_m_;
  double whole_m_ = 0;
  std::vector<double> begins_m_;
  std::vector<PassesAlong> stretches_;
};

/// How far the line of a track may run on beyond a soft edge, in widths, and the boundary be ahead of an end.
constexpr double kBehind_widths = 4, kAhead_m = 1e4;

/// Cosine of the angle within which two edges are one side.
constexpr double kSameSide = 0.94;

double turn_width_m(const Plan& plan) {
  const double across_m = plan.settings.skip * plan.machine.width_m;
  return 2 * (std::max(2 * plan.machine.radius_m, across_m) + plan.machine.width_m);
}

std::optional<BoundaryPlace> place_at(const Plan& plan, const Pose& end, Point ahead) {
  const Pose looking{end.at, Heading::from_to({0, 0}, ahead)};
  return boundary_ahead(plan.field, looking, kBehind_widths * plan.machine.width_m, kAhead_m);
}

class Needs {
 public:
  explicit Needs(const Plan& plan)
      : plan_(plan), outline_(outline_of(plan.machine)), sides_(plan.field.outer, turn_width_m(plan)) {
    out_.obstacles.assign(plan.field.obstacles.size(), 0);
  }

  PassesByBoundary run() {
    most_ = most_passes();
    for (std::size_t i = 0; i + 1 < plan_.pieces.size(); ++i)
      if (!plan_.pieces[i + 1].after_crossing) add(hop_between(plan_.pieces[i], plan_.pieces[i + 1]));
    if (!plan_.pieces.empty()) add_outer_ends();
    out_.edges = sides_.by_edge();
    take_whole_sides(plan_.field.outer, plan_.machine.width_m, out_.edges);
    return out_;
  }

 private:
  /// Twice what the turn to the next track in order needs before a square border: turns in oblique corners
  /// that would take more are not worth so much headland.
  int most_passes() const {
    constexpr int kObliqueBorders = 2;
    const double across_m = std::max(1, plan_.settings.skip) * plan_.machine.width_m;
    const Hop square{{{0, 0}, Heading::from_to({0, 0}, {1, 0})},
                     {{0, across_m}, Heading::from_to({1, 0}, {0, 0})}};
    int least = std::numeric_limits<int>::max();
    for (const HopWay& way : manoeuvres_over(square, plan_.machine, {}))
      if (!way.manoeuvre.path.empty())
        least = std::min(least, passes_needed(swept_reach_m(way.manoeuvre.path, outline_, {0, 0}, {1, 0}),
                                              plan_.machine.width_m));
    return kObliqueBorders * std::max(1, least);
  }

  /// Passes that a manoeuvre needs before a boundary that lies `ahead_m` before the end of the track.
  int passes_before(const BoundaryPlace& place, const SteeredPath& path, Point end) const {
    const double depth_m = swept_reach_m(path, outline_, end, place.outward);
    const double slope = std::abs(dot(place.outward, direction_));
    // An inner seam with land enough behind it needs no headland at the boundary beyond.
    if (place.ahead_m * slope >= depth_m) return 0;
    return std::min(most_, passes_needed(depth_m, plan_.machine.width_m));
  }

  void add(const Hop& hop) {
    direction_ = hop.end.heading.unit();
    const auto from = place_at(plan_, hop.end, hop.end.heading.unit());
    const auto to = place_at(plan_, hop.start, -1.0 * hop.start.heading.unit());
    // Round a corner the land beyond one side says nothing about the other.
    if (from && to && dot(from->outward, to->outward) < kSameSide) return;
    int least = std::numeric_limits<int>::max(), at_end = 0, at_start = 0;
    const std::vector<HopWay> ways = manoeuvres_over(hop, plan_.machine, {});
    for (const auto& [way, over_tracks] : ways) {
      if (way.path.empty()) continue;
      if (over_tracks && !ways.front().over_tracks) break;
      const int end = from ? passes_before(*from, way.path, hop.end.at) : 0;
      const int start = to ? passes_before(*to, way.path, hop.start.at) : 0;
      if (std::max(end, start) >= least) continue;
      least = std::max(end, start);
      at_end = end;
      at_start = start;
    }
    if (from && to && !from->obstacle && !to->obstacle) {
      if (distance(hop.end.at, hop.start.at) <= turn_width_m(plan_))
        sides_.require(from->along_m, to->along_m, std::max(at_end, at_start));
      return;
    }
    take(from, at_end);
    take(to, at_start);
  }

  void take(const std::optional<BoundaryPlace>& place, int passes) {
    if (!place) return;
    if (place->obstacle)
      out_.obstacles[*place->obstacle] = std::max(out_.obstacles[*place->obstacle], passes);
    else
      sides_.require(place->along_m, place->along_m + kSameDepth_m, passes);
  }

  /// Before the first piece and after the last one the machine needs room to get onto the track and off it.
  void add_outer_ends() {
    const auto add_end = [&](Point at, Point ahead) {
      direction_ = (1 / length(ahead)) * ahead;
      const Pose end{at, Heading::from_to({0, 0}, ahead)};
      const auto place = place_at(plan_, end, ahead);
      if (!place) return;
      int least = std::numeric_limits<int>::max();
      for (const SteeredPath& way : ways_off_end(at, end.heading, plan_.machine))
        least = std::min(least, passes_before(*place, way, at));
      take(place, least);
    };
    const TrackPiece& first = plan_.pieces.front();
    const TrackPiece& last = plan_.pieces.back();
    add_end(first.start,
            first.curve.empty() ? first.start - first.end : -1.0 * direction_at_start(first.curve.front()));
    add_end(last.end, last.curve.empty() ? last.end - last.start : direction_at_end(last.curve.back()));
  }

  const Plan& plan_;
  Outline outline_;
  Sides sides_;
  int most_ = 0;
  Point direction_{};
  PassesByBoundary out_;
};

/// The entry of the edge of the field or of the obstacle that is nearest to a point.
int& nearest_to(const Field& field, Point p, PassesByBoundary& passes) {
  double least = std::numeric_limits<double>::infinity();
  int* nearest = &passes.edges.front();
  const auto look_at = [&](const Ring& ring, auto passes_of) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const double off_m = distance_to_segment(p, ring[i], ring[(i + 1) % ring.size()]);
      if (off_m >= least) continue;
      least = off_m;
      nearest = passes_of(i);
    }
  };
  look_at(field.outer, [&](std::size_t i) { return &passes.edges[i]; });
  for (std::size_t k = 0; k < field.obstacles.size(); ++k)
    if (field.obstacles[k].kind == ObstacleKind::kObstacle)
      look_at(field.obstacles[k].shape.outer, [&](std::size_t) { return &passes.obstacles[k]; });
  return *nearest;
}

/// Places of the outline that are looked at, by width of the machine.
constexpr double kStepsAWidth = 4;

/// Where turns leave the land, and how many passes more that takes.
class Lacking {
 public:
  Lacking(const Plan& plan, const AllowedLand& land)
      : plan_(plan), land_(land), outline_(outline_of(plan.machine)) {
    more_.edges.assign(plan.field.outer.size(), 0);
    more_.obstacles.assign(plan.field.obstacles.size(), 0);
  }

  PassesByBoundary run() {
    for (const PlannedTurn& turn : plan_.turns)
      if (turn.state == TurnState::kNoRoom) add(turn.manoeuvre.path);
    for (const TrackPiece& piece : plan_.pieces) {
      if (piece.stop_at_start) add_way_off(piece.start, -1.0 * heading_at_start(piece));
      if (piece.stop_at_end) add_way_off(piece.end, heading_at_end(piece));
    }
    take_whole_sides(plan_.field.outer, plan_.machine.width_m, more_.edges);
    return more_;
  }

 private:
  static Point heading_at_start(const TrackPiece& piece) {
    return piece.curve.empty() ? piece.end - piece.start : direction_at_start(piece.curve.front());
  }
  static Point heading_at_end(const TrackPiece& piece) {
    return piece.curve.empty() ? piece.end - piece.start : direction_at_end(piece.curve.back());
  }

  void add_way_off(Point end, Point ahead) {
    const auto ways = ways_off_end(end, Heading::from_to({0, 0}, ahead), plan_.machine);
    const bool first = land_.missing_m(ways[0], outline_) <= land_.missing_m(ways[1], outline_);
    add(ways[first ? 0 : 1]);
  }

  void add(const SteeredPath& path) {
    if (path.empty()) return;
    const int passes = passes_needed(land_.missing_m(path, outline_), plan_.machine.width_m);
    if (passes == 0) return;
    for (const Point& off : places_off(land_.edges(), path, outline_, plan_.machine.width_m / kStepsAWidth)) {
      int& more = nearest_to(plan_.field, off, more_);
      more = std::max(more, passes);
    }
  }

  const Plan& plan_;
  const AllowedLand& land_;
  Outline outline_;
  PassesByBoundary more_;
};

}  // namespace

PassesByBoundary needed_passes(const Plan& plan) { return Needs(plan).run(); }

PassesByBoundary lacking_passes(const Plan& plan, const AllowedLand& land) {
  return Lacking(plan, land).run();
}

}  // namespace tramline
