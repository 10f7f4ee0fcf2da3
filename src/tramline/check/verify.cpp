#include "tramline/check/verify.h"

#include "tramline/check/not_verified.h"
#include "tramline/check/rules/rules.h"

namespace tramline::check {

namespace {

/// Rules about figures and counts. How lines that somebody else drew are laid is no rule of ours: what they
/// break of those that a machine or an obstacle imposes are findings.
void check_lines(const Case& c, Verdict& verdict) {
  check_body(c, verdict.violations);
  check_swaths(c, verdict.findings, verdict.findings);
  check_drivable(c, verdict.findings, verdict.findings);
  const int stops = check_stops(c, verdict.violations);
  check_crossings(c, verdict.violations);
  const Tallies tallies = check_tally(c, stops, verdict.violations);
  verdict.recomputed = tallies.whole;
  verdict.track_tally = tallies.tracks;
  check_swath_overlaps(c, verdict.violations);
  check_headland_tally(c, verdict.violations);
  check_proof(c.plan, verdict.violations);
  check_parallel(c, verdict.findings);
  verdict.complete = true;
}

void check_route(const Case& c, Verdict& verdict) {
  if (!check_route_is_sound(c.plan, verdict.violations)) return;
  check_route_order(c, verdict.violations);
  check_route_legs(c, verdict.violations);
  check_route_backing(c, verdict.violations);
  check_route_towing(c, verdict.violations);
  check_route_room(c, verdict.violations, verdict.findings);
  check_route_bound(c, verdict.violations);
  check_route_areas(c, verdict.violations);
  check_route_driven_over(c, verdict.violations);
}

}  // namespace

Verdict verify(const Plan& plan) {
  Verdict verdict;
  verdict.not_verified = not_verified(plan);
  check_shapes(plan, verdict.violations);
  check_pieces(plan, verdict.violations);
  check_headland(plan, verdict.violations);
  if (!verdict.violations.empty()) return verdict;

  const Case c(plan);
  if (is_of_lines(plan)) {
    check_lines(c, verdict);
    return verdict;
  }
  check_body(c, verdict.violations);
  check_ceded_to_tracks(c, verdict.violations);
  check_subfields(c, verdict.violations);
  // Tracks made as Zhou makes them may cross one another, run on where a fold has taken their
  // land, and reach beyond the field with the mitres of their kinks.
  Violations& of_zhou =
      plan.settings.tracks == TrackConstruction::kPaper ? verdict.findings : verdict.violations;
  check_swaths(c, verdict.violations, of_zhou);
  check_passes(c, verdict.violations);
  check_worth(c, verdict.violations);
  check_clearance(c, verdict.violations);
  check_drivable(c, verdict.violations, verdict.findings);
  check_ends(c, of_zhou);
  check_parallel(c, of_zhou);
  check_track_lines(c, verdict.violations);
  check_ab_anchor(c, verdict.violations);
  check_length(c, verdict.violations);
  const int stops = check_stops(c, verdict.violations);
  check_turns(c, verdict.violations);
  check_route(c, verdict);
  check_crossings(c, verdict.violations);
  check_encounters(c, verdict.violations);
  check_detours(c, verdict.violations);
  check_listed_encounters(c, verdict.violations);
  check_ways(c, verdict.violations);
  check_avoidance(c, verdict.violations);
  const Tallies tallies = check_tally(c, stops, verdict.violations);
  verdict.recomputed = tallies.whole;
  verdict.track_tally = tallies.tracks;
  check_swath_overlaps(c, verdict.violations);
  check_headland_tally(c, verdict.violations);
  check_proof(plan, verdict.violations);
  check_prices(plan, verdict.violations);
  check_front(c, verdict.violations);
  verdict.complete = true;
  return verdict;
}

}  // namespace tramline::check
