#include "tramline/planner/validate_request.h"

#include <fmt/format.h>

#include <cmath>
#include <string>

#include "tramline/geometry/error.h"
#include "tramline/model/limits.h"
#include "tramline/model/rate_values.h"
#include "tramline/model/turning_values.h"

namespace tramline {
namespace {

void require_weight(double value, const char* what) {
  constexpr double kMost = 1e15;  // a field's cost stays a number
  if (!(value >= 0 && value <= kMost))
    throw bad_input(
        fmt::format("the weight of {} must be a number from 0 to {:g}, not {}", what, kMost, value));
}

void require_degrees(Angle angle, double least, double most, const char* what) {
  if (!(angle.degrees() >= least && angle.degrees() <= most))
    throw bad_input(fmt::format("the {} must lie between {} and {} degrees, not at {}", what, least, most,
                                angle.degrees()));
}

void require_width(double value) {
  if (!(value > 0 && value <= kFarthest_m))
    throw bad_input(
        fmt::format("the working width must be more than 0 and at most {} m, not {}", kFarthest_m, value));
}

/// A negative value stands for the default.
void require_metres_or_default(double value, const char* what) {
  if (!(std::isfinite(value) && value < 0)) require_metres(value, 0, kFarthest_m, what);
}

/// Refuses settings that Zhou's construction does not support.
void require_paper_rules(const PlanSettings& settings) {
  if (settings.end_rule != EndRule::kCover)
    throw bad_input(fmt::format(
        "tracks as in the paper end where nothing is left to cover: --tracks paper goes with --end-rule "
        "cover, not {}",
        name(settings.end_rule)));
  if (settings.boundary == EdgeKind::kHard && settings.headlands == 0)
    throw bad_input(
        "tracks as in the paper run on over the edge of the body: leave --boundary hard out, or give "
        "--headlands");
}

/// Refuses what goes with land given by the user in no sensible way.
void require_given_land(const PlanSettings& settings) {
  const GivenLand& given = settings.given;
  const bool takes_part = !given.done.empty() || !given.elsewhere.empty();
  if (takes_part && (settings.headlands > 0 || settings.obstacle_headlands > 0))
    throw bad_input(
        "headland passes go round a whole field: with --done or --only leave out --headlands and "
        "--obstacle-headlands");
  if (settings.tracks == TrackConstruction::kPaper &&
      (takes_part || given.divides() || !given.left_out.empty()))
    throw bad_input(
        "tracks as in the paper cover a whole field along one line: with --subfields, --only or --done leave "
        "out "
        "--tracks paper");
}

/// Refuses what prices of the land prove nothing about.
void require_provable(const PlanSettings& settings) {
  if (settings.turns == TurnPlanning::kRoute)
    throw bad_input("--prove is about what tracks cost, not whole routes: give --route none as well");
  if (settings.strategy != Strategy::kBest)
    throw bad_input("--prove goes with --strategy best, which alone proves anything");
  if (settings.shape == TrackShape::kCurved || !settings.guide.empty())
    throw bad_input(
        "--prove is about plans of straight tracks of any direction: leave out --curved and --line");
}

}  // namespace

void require_metres(double value, double least, double most, const char* what) {
  // Written so that NaN is refused.
  if (!(value >= least && value <= most))
    throw bad_input(fmt::format("the {} must lie between {} and {} m, not at {}", what, least, most, value));
}

void validate_request(const Machine& machine, const Objective& objective, const PlanSettings& settings) {
  require_width(machine.width_m);
  require_metres(machine.radius_m, 0, kFarthest_m, "turning radius");
  require_metres_or_default(machine.min_length_m, kLeastTrackLength);
  if (const std::string fault = turning_fault(machine.turning); !fault.empty())
    throw bad_input("the machine's " + fault);
  if (const std::string fault = rates_fault(machine.rates); !fault.empty())
    throw bad_input("the machine's " + fault);
  require_weight(objective.overlap, "overlap");
  require_weight(objective.uncovered, "uncovered land");
  require_weight(objective.turn, "turns");
  require_weight(objective.stop, "stops");
  require_weight(objective.subfield, "further subfields");
  constexpr double kMostClearance = 1000;
  require_metres(settings.clearance_m, 0, kMostClearance, "clearance");
  require_metres_or_default(settings.avoid_threshold_m, kAvoidThreshold);
  require_metres_or_default(settings.avoid_room_m, kAvoidRoom);
  if (settings.tracks == TrackConstruction::kPaper) require_paper_rules(settings);
  require_given_land(settings);
  if (settings.prove) require_provable(settings);
  constexpr double kFinestDirections_deg = 1e-4;
  require_degrees(settings.direction_tolerance, kFinestDirections_deg, 10, "direction tolerance");
  require_metres(settings.short_edge_m, 0, kFarthest_m, "short edge");
  require_degrees(settings.merge_threshold, 0, 90, "merge threshold");
  require_degrees(settings.decomposition_threshold, 180, 360, "decomposition threshold");
}

}  // namespace tramline
