#include "avoidance/pole_field.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "tramline/geometry/polygon/boolean.h"
#include "tramline/geometry/tolerances.h"
#include "tramline/tracks/straight_tracks.h"
#include "tramline/tracks/tolerances.h"

namespace tramline::testing_poles {
namespace {

const Direction kNorth = Direction::clockwise_from_north(Angle::degrees(0));

/// Coarser than that of files, for the sake of thousands of unions.
constexpr double kSagitta = 1e-4;

/// The swath of a piece in parts that touch.
Region swath_parts(const LaidPiece& piece, const StripGrid& grid) {
  Region out;
  const double left = grid.line(piece.track), right = grid.line(piece.track + 1);
  double at = piece.from;
  const auto add_straight = [&](double to) {
    if (to > at) out.push_back({box(left, at, right, to), {}});
  };
  for (const TrackDetour& detour : piece.detours) {
    add_straight(detour.from);
    out.push_back({band(detour.path, grid.width_m, kSagitta), {}});
    at = detour.to;
  }
  add_straight(piece.to);
  return out;
}

double driven_m(const LaidPiece& piece) {
  double sum = piece.to - piece.from;
  for (const TrackDetour& detour : piece.detours) sum += length(detour.path) - (detour.to - detour.from);
  return sum;
}

LaidPiece piece(int track, double from, double to) {
  LaidPiece out;
  out.track = track;
  out.from = from;
  out.to = to;
  return out;
}

}  // namespace

Ring regular(int corners, double radius, Point centre) {
  Ring ring;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * i / corners;
    ring.push_back(centre + radius * Point{std::cos(angle), std::sin(angle)});
  }
  return ring;
}

PoleField::PoleField(Ring outer, std::vector<Ring> poles, const Machine& machine, const Objective& objective,
                     const PlanSettings& settings, const std::vector<Ring>& passable)
    : machine_(machine), objective_(objective), reach_(bounds(outer)) {
  field_.outer = std::move(outer);
  for (Ring& pole : poles)
    field_.obstacles.push_back({{std::move(pole), {}}, ObstacleKind::kObstacle, "pole"});
  for (const Ring& ring : passable)
    field_.obstacles.push_back({{ring, {}}, ObstacleKind::kPassable, "passable"});
  for (const Avoidance avoid : {Avoidance::kCheapest, Avoidance::kPaper, Avoidance::kCut}) {
    PlanSettings& own = settings_[static_cast<std::size_t>(avoid)];
    own = settings;
    own.avoid = avoid;
  }
  ground_ = classify_obstacles(field_, machine.width_m, settings.clearance_m);
  subfields_ = {{ground_.plannable.front(), kNorth}};
  TurnedGround turned{ground_.hard, ground_.passable, {}, ground_.beyond};
  if (settings.boundary == EdgeKind::kHard) turned.field = {{field_.outer, {}}};
  families_ = {straight_tracks({TrackFrame(kNorth), 0, machine.width_m}, ground_.plannable.front(), turned,
                               end_criterion(settings.end_rule, objective, machine.width_m))};
}

AvoidanceTask PoleField::task(Avoidance avoid) const {
  return {field_,     ground_,   machine_,          objective_, settings_[static_cast<std::size_t>(avoid)],
          subfields_, families_, area(ground_.body)};
}

WayRound PoleField::way(const Track& strip, std::size_t gap, Passing side) const {
  return way_round({family().grid, strip, gap, machine_.radius_m}, side,
                   turned_surroundings(ground_, field_.outer, settings_[0].boundary, family().grid.frame));
}

Tally PoleField::by_booleans(const std::vector<LaidPiece>& pieces) const {
  constexpr double kAtEdge = 1e-3;
  Tally tally;
  Region parts;
  for (const LaidPiece& piece : pieces) {
    for (Polygon& part : swath_parts(piece, family().grid)) parts.push_back(std::move(part));
    tally.track_length_m += driven_m(piece);
    tally.stops += piece.from > reach_.min_y + kAtEdge ? 1 : 0;
    tally.stops += piece.to < reach_.max_y - kAtEdge ? 1 : 0;
  }
  tally.pieces = static_cast<int>(pieces.size());
  tally.turns = std::max(0, tally.pieces - 1);
  tally.worked_m2 = machine_.width_m * tally.track_length_m;
  const double useful = area(intersection(unite(parts), ground_.body));
  tally.overlap_m2 = tally.worked_m2 - useful;
  tally.uncovered_m2 = area(ground_.body) - useful;
  return tally;
}

double PoleField::area_tolerance(const std::vector<LaidPiece>& pieces) const {
  double edges = perimeter(field_.outer), ends = 0;
  for (const LaidPiece& piece : pieces) {
    edges += 2 * (driven_m(piece) + machine_.width_m);
    ends += 2 * machine_.width_m;
  }
  double bent = 0;
  for (const LaidPiece& piece : pieces)
    for (const TrackDetour& detour : piece.detours) bent += 2 * length(detour.path);
  return kSagitta * bent + 3 * kGridSize * edges + 3 * kWidthTolerance * ends;
}

double PoleField::cost_tolerance(const std::vector<LaidPiece>& pieces) const {
  return (objective_.overlap + objective_.uncovered) * area_tolerance(pieces);
}

Machine machine(double width_m, double radius_m) { return {"", width_m, radius_m, 0}; }

StripWays rolling_circle_paths(const PoleField& field, const Track& strip) {
  const Intervals& at = strip.stretches;
  if (at.size() != 2) return {{{piece(strip.index, at.front().from, at.back().to)}}, {Passing::kCut}};
  StripWays out{{{piece(strip.index, at[0].from, at[0].to), piece(strip.index, at[1].from, at[1].to)}},
                {Passing::kCut}};
  for (const Passing side : {Passing::kLeft, Passing::kRight}) {
    const WayRound way = field.way(strip, 1, side);
    if (!way.possible()) continue;
    LaidPiece whole = piece(strip.index, at[0].from, at[1].to);
    whole.detours = {way.detour};
    out.ways.push_back({whole});
    out.names.push_back(side);
  }
  return out;
}

void expect_own_tally(const PoleField& field, const Avoided& avoided) {
  const std::vector<LaidPiece>& pieces = avoided.tracks.front().pieces;
  const Tally other = field.by_booleans(pieces);
  const double tolerance = field.area_tolerance(pieces);
  EXPECT_NEAR(avoided.tally.overlap_m2, other.overlap_m2, tolerance);
  EXPECT_NEAR(avoided.tally.uncovered_m2, other.uncovered_m2, tolerance);
  EXPECT_NEAR(avoided.tally.worked_m2, other.worked_m2, 1e-6);
  EXPECT_NEAR(avoided.tally.track_length_m, other.track_length_m, 1e-6);
  EXPECT_EQ(avoided.tally.pieces, other.pieces);
  EXPECT_EQ(avoided.tally.turns, other.turns);
  EXPECT_EQ(avoided.tally.stops, other.stops);
  EXPECT_NEAR(avoided.cost, cost(field.objective(), other), field.cost_tolerance(pieces));
}

void expect_off_poles(const PoleField& field, const Avoided& avoided) {
  for (const LaidPiece& piece : avoided.tracks.front().pieces) {
    double at = piece.from;
    for (const TrackDetour& detour : piece.detours) {
      EXPECT_GE(detour.from, at - 1e-9) << "detours overlap";
      at = detour.to;
      const Region swath{{band(detour.path, field.width_m()), {}}};
      EXPECT_LT(area(intersection(swath, field.ground().hard)), 1e-4 * (1 + detour.length_m));
    }
    EXPECT_LE(at, piece.to + 1e-9);
  }
}

int detours_in(const Avoided& avoided) {
  std::size_t sum = 0;
  for (const LaidPiece& piece : avoided.tracks.front().pieces) sum += piece.detours.size();
  return static_cast<int>(sum);
}

Ring field_ring(double width_m) { return box(0, 0, 7 * width_m, 160); }

Ring ring_of(const Pole& pole) {
  const Point at{3.5 * pole.width_m + pole.off_m, 80};
  const double half = 0.5 * pole.across_m;
  if (pole.corners == 4) return box(at.x - half, at.y - half, at.x + half, at.y + half);
  return regular(pole.corners, half, at);
}

std::vector<Pole> poles() {
  std::vector<Pole> out;
  for (const double width : {1.5, 3.0, 6.0, 12.0})
    for (const double radius : {0.0, 3.0, 6.0, 12.0})
      for (const double across : {std::sqrt(0.3), 0.5 * width, 1.2 * width, 2 * width})
        for (const double off : {0.0, 0.2 * width, 0.5 * width, 0.5 * width - 0.5 * across})
          out.push_back({width, radius, across, off, std::array{4, 8, 16}[out.size() % 3]});
  return out;
}

::testing::Message description(const Pole& pole) {
  return ::testing::Message() << "w " << pole.width_m << " r " << pole.radius_m << " pole " << pole.across_m
                              << " off " << pole.off_m << " corners " << pole.corners;
}

}  // namespace tramline::testing_poles
