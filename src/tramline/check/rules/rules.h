#pragma once
// The rules a plan is judged by, one file each: rule_<name>.cpp. Every function appends what it finds.

#include <optional>
#include <string>
#include <vector>

#include "tramline/check/measure/plan_facts.h"
#include "tramline/check/measure/swath_clearance.h"
#include "tramline/check/rules/case.h"
#include "tramline/check/verify.h"
#include "tramline/model/plan.h"

namespace tramline::check {

/// Every polygon is one: at least three vertices, on the map, not crossing itself.
void check_shapes(const Plan& plan, Violations& out);
/// Pieces have distinct ends on the map, belong to a subfield and run along its direction. Their
/// detours are paths on the map that leave and rejoin the line one after the other.
void check_pieces(const Plan& plan, Violations& out);
/// No boundary has more passes of headland than were asked for, and passables have none. Every pass is a
/// path on the map that does not cross itself, and one of those that a boundary it names has.
void check_headland(const Plan& plan, Violations& out);
/// The body is the field less obstacles, passable ones too, and less the ground of headlands; that ground is
/// what is nearer to a boundary than its passes are wide, but for what is left to tracks
/// (check_ceded_to_tracks). Both are apart, and with the obstacles they are
/// the field. Land given up lies within the body. Of a repair: body and worked ground are apart, and with the
/// obstacles they are the field.
void check_body(const Case& c, Violations& out);
/// What is body although it is nearer to a boundary than its passes are wide: no pass works it, it is a
/// width from every boundary with a headland, and a track as long as the least length, or as two widths where
/// that is more, has room in each part of it. Of what else no pass works there, no part has ample room for
/// one.
void check_ceded_to_tracks(const Case& c, Violations& out);
/// Subfields part the body less land given up, plus passables, without overlapping.
void check_subfields(const Case& c, Violations& out);
/// No straight or curved swath enters an obstacle, a passable or land given up; none at all crosses a hard
/// boundary, and no detour leaves the field. Where there is a headland round it, the boundary is hard.
void check_swaths(const Case& c, Violations& out);
/// Swaths of headland passes stay in the field and enter no obstacle. Pass i keeps (i − ½)·w off every
/// boundary that has so many passes. A closed one has the land it goes round on its left.
void check_passes(const Case& c, Violations& out);
/// No headland pass runs on where nobody asked for it: in no stretch does it work so much ground again, or
/// beyond the headland, that leaving the stretch out would be better by far.
/// O(n·k) for n slices of half the width, k of them at one place.
void check_worth(const Case& c, Violations& out);
/// Where swaths say by how much they overlap, it is what of them lies outside the body or has been worked
/// before, by another swath or by the same; and where all do, the sum is the plan's overlap.
void check_swath_overlaps(const Case& c, Violations& out);
/// No detour's swath comes nearer to an obstacle than the clearance, nor enters a passable or land
/// given up. Where there is a clearance, straight and curved swaths keep it too.
void check_clearance(const Case& c, Violations& out);
/// The machine can drive every detour, curve and headland pass: no arc is too tight and no heading jumps.
void check_drivable(const Case& c, Violations& out);
/// Each piece obeys the end rule over all its straight parts, or all along its curve. In a repair the ground
/// asked for is that of any gap, and the work may go on over breaks of less than kLeastBreak_m.
void check_ends(const Case& c, Violations& out);
/// Where tracks follow a curve, no two pieces of a subfield lie less than the working width apart, across
/// either of them.
void check_parallel(const Case& c, Violations& out);
/// Where tracks follow a curve, every piece lies on the line of its track but for its detours: in places a
/// width apart and less, it is (k + ½) widths from the reference on its side, or rolls round a corner.
/// Nothing is asked of a repair, nor along a reference that no machine could follow.
void check_track_lines(const Case& c, Violations& out);
/// No piece is too short to drive, but for those between crossings.
void check_length(const Case& c, Violations& out);
/// A piece is flagged as ending in a stop where the first millimetre beyond it meets an obstacle without
/// headland or land given up, and nowhere else. Returns the number of stops found.
int check_stops(const Case& c, Violations& out);
/// A piece after a crossing goes on in line beyond a passable, with nothing else in the gap. Where tracks
/// follow a curve the line between two pieces is not known: the second begins ahead. In a repair what is
/// crossed is worked ground, within the field.
void check_crossings(const Case& c, Violations& out);
/// Detours leave the line of their track, come back to it, and pass on the side they say. They name the
/// obstacles that lie beside that line, nearer than half the width and the clearance, and so do the
/// encounters there, of which there is one; others that they name lie beside the line, too, and on the side
/// passed.
void check_detours(const Case& c, Violations& out);
/// What was decided where tracks meet obstacles is what they do: where a way past was chosen a detour takes
/// it and names the obstacles met, where a cut was the track does not go on.
void check_encounters(const Case& c, Violations& out);
/// Wherever an obstacle without headland or land given up lies across the line of a track, between two of its
/// pieces, dropped ones included, there is an encounter that names it. Where a track ends for good the file
/// does not say what would have followed: nothing is asked there, nor of a repair, which decides nothing at
/// obstacles, nor where the lines are not known. O(g·e + k²) for g such gaps, e encounters and k pieces along
/// one line.
void check_meetings(const Case& c, Violations& out);
/// Each way past an encounter has either a cost or a reason why not, and the chosen one a cost. Where the
/// cheapest ways were asked for, the chosen one costs least: no other, nor a cut, is cheaper by more
/// than rounding.
void check_ways(const Case& c, Violations& out);
/// The detours are such as the settings allow: with Avoidance::kCut there are none. With kPaper each passes
/// one encounter, and nothing that lies on its track and is as wide across it as the threshold; encounters
/// name one side at most, and are cut only where that is not possible or another detour of the track may
/// be in its way.
void check_avoidance(const Case& c, Violations& out);
/// The stored tallies, cost and layers agree with the tracks and headland passes. `stops` is what check_stops
/// found. Returns the recomputed tallies.
struct Tallies {
  Tally whole;   ///< of tracks and headland passes
  Tally tracks;  ///< of the tracks alone, against the body
};
Tallies check_tally(const Case& c, int stops, Violations& out);
/// The stored tally of the headland and the layer of what it leaves agree with its passes.
void check_headland_tally(const Case& c, Violations& out);

/// No bound exceeds the cost of a plan that there is: this one, those of the front, and for one direction the
/// best one found. Bounds, costs and prices are not negative. What a bound is worth beyond that is not
/// verified.
void check_proof(const Plan& plan, Violations& out);
/// The plans of the front ascend in overlap, and none is no better in anything than another. Each costs what
/// its figures do at the plan's prices, turns between all its tracks, and works the land there is. Marks are
/// where they belong, but for the knee. O(f²) for f plans.
void check_front(const Case& c, Violations& out);

/// The same for one line and the swath along it, whether it is a plan's or only drawn: it is within
/// the field but for its ends, and keeps clear of land. Violations call it `name`.
void check_line_within_field(const Case& c, const SwathClearance& line, const std::string& name,
                             Violations& out);
void check_clearance_of(const Case& c, const SwathClearance& swath, const std::string& name, Violations& out);

/// The stretch of the line of its track that a detour takes the place of, in its heading; nullopt where it
/// does not lead from the line back to it, or the line is not known.
std::optional<Path> line_left(const Case& c, const TrackPiece& piece, const Detour& detour);
/// The encounters on the stretch of its track that a detour takes the place of. O(e).
std::vector<const Encounter*> encounters_at(const Case& c, const TrackPiece& piece, const Detour& detour);
/// Does any of the encounters name the obstacle?
bool names(const std::vector<const Encounter*>& encounters, std::size_t obstacle);

}  // namespace tramline::check
