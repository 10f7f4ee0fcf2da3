#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>

#include "tramline/check/rules/route/route_facts.h"
#include "tramline/check/rules/rules.h"
#include "tramline/check/tolerances.h"
#include "tramline/check/turning/land_parts.h"

namespace tramline::check {
namespace {

/// Legs are compared with their pieces and passes at places so far apart, m.
constexpr double kCompared_m = 0.5;
/// Work that goes on over a passable obstacle, or is off beside it, counts from such a length on, m: planners
/// look for the edges of obstacles in steps.
constexpr double kLeastInterrupted_m = 0.5;
constexpr double kInterruptionStep_m = 0.1;

/// The place of the leg that is farthest from the course, which has worked `from_m` where the leg begins.
struct Deviation {
  double off_m = 0;
  Point at;
};

Deviation deviation(const SteeredPath& path, const WorkedCourse& course, double from_m) {
  Deviation out;
  for (const CoursePlace& is : course_of(path, kCompared_m)) {
    const double off_m = distance(is.place.at, course.axle(from_m + is.along_m).at);
    if (off_m >= out.off_m) out = {off_m, is.place.at};
  }
  return out;
}

class OrderCheck {
 public:
  OrderCheck(const Case& c, Violations& out)
      : plan_(c.plan), legs_(c.plan.route.legs), parts_(c.plan), out_(out) {}

  void run() {
    for (std::size_t i = 0; i < legs_.size(); ++i) check_what_it_works(i);
    if (!references_exist_) return;
    check_pieces_in_order();
    for (std::size_t pass = 0; pass < plan_.headland.passes.size(); ++pass) check_pass(pass);
    check_parts_and_phases();
    check_sequence();
  }

 private:
  Point start_of(std::size_t leg) const { return legs_[leg].path.front().start.at; }

  void add(std::size_t leg, const std::string& what, double amount = 0) {
    out_.push_back(
        {Rule::kRouteOrder, fmt::format("{} {}", leg_name(plan_, leg), what), start_of(leg), amount});
  }

  void check_what_it_works(std::size_t i) {
    const RouteLeg& leg = legs_[i];
    const bool on_piece = leg.kind == LegKind::kWork, on_pass = leg.kind == LegKind::kHeadland;
    if (leg.work != (on_piece || on_pass))
      add(i, leg.work ? "has the work on" : "has the work off", length(leg));
    if (leg.work && leg.gear != Gear::kForward) add(i, "is worked in reverse", length(leg));
    const bool may_name_pass = on_pass || leg.kind == LegKind::kTransit;
    if (leg.piece.has_value() != on_piece || (leg.piece && *leg.piece >= plan_.pieces.size()))
      refuse(i, "names no piece of the plan, or one although it works none");
    if ((on_pass && !leg.pass) || (leg.pass && !may_name_pass) ||
        (leg.pass && *leg.pass >= plan_.headland.passes.size()))
      refuse(i, "names no headland pass of the plan, or one although it follows none");
  }

  void refuse(std::size_t leg, const char* what) {
    add(leg, what);
    references_exist_ = false;
  }

  void check_pieces_in_order() {
    std::vector<int> driven(plan_.pieces.size(), 0);
    const std::vector<std::size_t> works = work_legs(plan_);
    for (std::size_t k = 0; k < works.size(); ++k) {
      const std::size_t piece = *legs_[works[k]].piece;
      ++driven[piece];
      if (piece != k)
        add(works[k], fmt::format("works piece {}, where it is the turn of piece {}", piece + 1, k + 1));
      check_course(works[k], course_of_piece(plan_, piece), piece_name(piece));
      if (k > 0 && piece > 0 && plan_.pieces[piece].after_crossing) check_crossing(works[k - 1], works[k]);
    }
    for (std::size_t i = 0; i < driven.size(); ++i)
      if (driven[i] != 1)
        out_.push_back({Rule::kRouteOrder,
                        fmt::format("the route drives {} {} times", piece_name(i), driven[i]),
                        plan_.pieces[i].start, static_cast<double>(driven[i])});
  }

  void check_course(std::size_t leg, const WorkedCourse& course, const std::string& what) {
    const double longer_m = length(legs_[leg]) - course.length_m();
    if (std::abs(longer_m) > kLengthTolerance_m)
      add(leg, fmt::format("is {:.3f} m longer than {}", longer_m, what), longer_m);
    const Deviation off = deviation(legs_[leg].path, course, 0);
    if (off.off_m > kLengthTolerance_m)
      out_.push_back({Rule::kRouteOrder,
                      fmt::format("{} is {:.3f} m off {}", leg_name(plan_, leg), off.off_m, what), off.at,
                      off.off_m});
  }

  /// Between two pieces of one line there is nothing but the way across, forward.
  void check_crossing(std::size_t before, std::size_t after) {
    const bool one = after == before + 2;
    if (!one || legs_[before + 1].kind != LegKind::kTransit || legs_[before + 1].gear != Gear::kForward)
      return add(after, "follows a crossing that is more than one way across");
    for (const SteeredStretch& stretch : legs_[before + 1].path)
      if (stretch.curvature_at_start != 0 || stretch.curvature_at_end != 0)
        return add(before + 1, "is not driven straight on", length(legs_[before + 1]));
  }

  void check_pass(std::size_t pass) {
    const std::vector<std::size_t> legs = legs_of_pass(plan_, pass);
    const Point begins = plan_.headland.passes[pass].path.front().from;
    const auto add_pass = [&](const std::string& what, double amount) {
      out_.push_back({Rule::kRouteOrder, fmt::format("{} {}", pass_name(pass), what), begins, amount});
    };
    if (legs.empty()) return add_pass("is not driven", 0);
    if (legs.back() - legs.front() + 1 != legs.size())
      return add_pass("is left before it is worked, and taken up again", 0);
    SteeredPath whole;
    for (const std::size_t leg : legs)
      whole.insert(whole.end(), legs_[leg].path.begin(), legs_[leg].path.end());
    const double longer_m = length(whole) - course_of_pass(plan_, pass, PassSense::kAlong).length_m();
    if (std::abs(longer_m) > kLengthTolerance_m)
      return add_pass(fmt::format("is {:.3f} m shorter than what is driven of it", longer_m), longer_m);
    Deviation least{std::numeric_limits<double>::infinity(), begins};
    const auto course = course_driven(pass, whole, least);
    if (!course) return add_pass(fmt::format("is driven {:.3f} m off its place", least.off_m), least.off_m);
    check_interruptions(legs, course->course, course->from_m);
  }

  struct Driven {
    WorkedCourse course;
    double from_m = 0;
  };

  /// Either way round, and where the pass is closed from any place.
  std::optional<Driven> course_driven(std::size_t pass, const SteeredPath& whole, Deviation& least) const {
    for (const PassSense sense : {PassSense::kAlong, PassSense::kAgainst}) {
      const WorkedCourse course = course_of_pass(plan_, pass, sense);
      std::vector<double> entries{0};
      if (is_closed(plan_.headland.passes[pass])) {
        entries = course.line().positions_near(whole.front().start.at, kLengthTolerance_m);
        for (double& entry : entries) entry -= course.ahead_m();
      }
      for (const double from_m : entries) {
        const Deviation off = deviation(whole, course, from_m);
        if (off.off_m <= kLengthTolerance_m) return Driven{course, from_m};
        if (off.off_m < least.off_m) least = off;
      }
    }
    if (!std::isfinite(least.off_m))
      least.off_m = distance(whole.front().start.at, plan_.headland.passes[pass].path.front().from);
    return std::nullopt;
  }

  /// The work is off where the implement's middle is on passable obstacles, and nowhere else.
  void check_interruptions(const std::vector<std::size_t>& legs, const WorkedCourse& course, double from_m) {
    if (!has_passables() && legs.size() == 1 && legs_[legs.front()].work) return;
    for (const std::size_t leg : legs) {
      const double length_m = length(legs_[leg]);
      double wrong_m = 0, longest_m = 0;
      for (double at_m = 0; at_m < length_m; at_m += kInterruptionStep_m) {
        const bool wrong = on_passable(course.implement(from_m + at_m)) == legs_[leg].work;
        wrong_m = wrong ? wrong_m + kInterruptionStep_m : 0;
        longest_m = std::max(longest_m, wrong_m);
      }
      if (longest_m > kLeastInterrupted_m || (!legs_[leg].work && longest_m >= length_m))
        add(leg,
            fmt::format("has the work {} {:.1f} m {} passable obstacles",
                        legs_[leg].work ? "on along" : "off along", longest_m,
                        legs_[leg].work ? "on" : "beside"),
            longest_m);
      from_m += length_m;
    }
  }

  bool has_passables() const {
    return std::any_of(plan_.field.obstacles.begin(), plan_.field.obstacles.end(),
                       [](const Obstacle& o) { return o.kind == ObstacleKind::kPassable; });
  }
  bool on_passable(Point p) const {
    return std::any_of(plan_.field.obstacles.begin(), plan_.field.obstacles.end(), [p](const Obstacle& o) {
      return o.kind == ObstacleKind::kPassable && contains(o.shape, p);
    });
  }

  /// One part of the land is worked after the other, and on each of them all headland passes before all
  /// tracks or after them, as the settings ask; or round obstacles among the tracks, behind all that end
  /// there.
  void check_parts_and_phases() {
    const bool first = plan_.settings.route.passes == PassTime::kFirst;
    std::set<std::size_t> left;
    std::optional<std::size_t> part;
    std::vector<std::size_t> before;  // on the part: pieces, or passes
    for (std::size_t i = 0; i < legs_.size(); ++i) {
      const RouteLeg& leg = legs_[i];
      if (!leg.piece && !leg.pass) continue;
      const std::size_t here = part_of(leg, plan_, parts_);
      if (part && here != *part) {
        left.insert(*part);
        before.clear();
        if (left.contains(here))
          add(i, "goes back to land that it had left, and that the machine cannot drive to");
      }
      part = here;
      if (first ? leg.piece.has_value() : leg.pass.has_value())
        before.push_back(first ? *leg.piece : *leg.pass);
      if (first && leg.pass && !before.empty()) add(i, "follows a pass after the tracks");
      if (!first && leg.piece) check_passes_before(i, before);
    }
  }

  void check_passes_before(std::size_t leg, const std::vector<std::size_t>& passes) {
    const TrackPiece& piece = plan_.pieces[*legs_[leg].piece];
    for (const std::size_t pass : passes) {
      if (plan_.headland.passes[pass].around_field) return add(leg, "works a track after the passes");
      const WorkedCourse course = course_of_pass(plan_, pass, PassSense::kAlong);
      for (const Point end : {piece.start, piece.end})
        if (!course.line().positions_near(end, plan_.machine.width_m).empty())
          return add(leg, fmt::format("works a track that ends beside {}, after that", pass_name(pass)));
    }
  }

  /// Of passes along one boundary and on one part of the land the outer ones come first, or the inner ones,
  /// where the settings ask.
  void check_sequence() {
    const PassSequence sequence = plan_.settings.route.sequence;
    if (sequence == PassSequence::kAny) return;
    const std::vector<HeadlandPass>& passes = plan_.headland.passes;
    for (std::size_t one = 0; one < passes.size(); ++one)
      for (std::size_t other = 0; other < passes.size(); ++other) {
        const bool later = sequence == PassSequence::kInwards ? passes[one].number > passes[other].number
                                                              : passes[one].number < passes[other].number;
        if (!later || !along_one_boundary(passes[one], passes[other])) continue;
        const std::vector<std::size_t> too_early = legs_of_pass(plan_, one),
                                       late = legs_of_pass(plan_, other);
        if (too_early.empty() || late.empty() || too_early.front() > late.front()) continue;
        if (part_of(legs_[too_early.front()], plan_, parts_) == part_of(legs_[late.front()], plan_, parts_))
          add(too_early.front(),
              fmt::format("comes before {}, though passes go {}", pass_name(other), name(sequence)));
      }
  }

  const Plan& plan_;
  const std::vector<RouteLeg>& legs_;
  LandParts parts_;
  Violations& out_;
  bool references_exist_ = true;
};

}  // namespace

void check_route_order(const Case& c, Violations& out) {
  if (c.plan.route.planned()) return OrderCheck(c, out).run();
  const bool asked = c.plan.settings.turns == TurnPlanning::kRoute;
  if (!asked || c.plan.pieces.empty()) return;
  out.push_back(
      {Rule::kRouteOrder,
       fmt::format("there is no route, although one was asked for over {} pieces", c.plan.pieces.size()),
       c.plan.pieces.front().start, static_cast<double>(c.plan.pieces.size())});
}

}  // namespace tramline::check
