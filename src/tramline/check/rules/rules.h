#pragma once
// The rules that a plan is checked against, one file each: rule_<name>.cpp. Every function appends the
// violations it finds.

#include <optional>
#include <string>
#include <vector>

#include "tramline/check/measure/plan_facts.h"
#include "tramline/check/measure/swath_clearance.h"
#include "tramline/check/rules/case.h"
#include "tramline/check/verify.h"
#include "tramline/model/plan.h"

namespace tramline::check {

/// Every polygon is valid: at least three vertices, on the map, not crossing itself.
void check_shapes(const Plan& plan, Violations& out);
/// Pieces have distinct ends on the map, belong to a subfield and run along its direction. Their detours are
/// paths on the map that leave and rejoin the line, one after the other.
void check_pieces(const Plan& plan, Violations& out);
/// No boundary has more headland passes than were asked for, and passables have none. Every pass is a path on
/// the map that does not cross itself, and its number is one of those that a boundary named by it has.
void check_headland(const Plan& plan, Violations& out);
/// The body is the field less obstacles, passable ones included, and less the land of headlands. That land is
/// all that is nearer to a boundary than its passes are wide, except what is ceded to tracks
/// (check_ceded_to_tracks). Body and headlands are disjoint, and together with the obstacles they make up the
/// field. Land given up lies within the body. In a repair, body and worked land are disjoint, and together
/// with the obstacles they make up the field.
void check_body(const Case& c, Violations& out);
/// Land near a boundary that is body although it is nearer than the boundary's passes are wide: no pass works
/// it, it is a width from every boundary with a headland, and each part of it has room for a track of the
/// least length or of two widths, whichever is more. No part of the other land near boundaries that no pass
/// works has ample room for such a track.
void check_ceded_to_tracks(const Case& c, Violations& out);
/// Subfields partition the body less land given up, plus passables, without overlapping.
void check_subfields(const Case& c, Violations& out);
/// No straight or curved swath enters an obstacle, a passable or land given up; no swath of any kind crosses
/// a hard boundary, and no detour leaves the field. The boundary of a field with headland passes is hard.
/// `beyond`: what tracks work beyond it.
void check_swaths(const Case& c, Violations& out, Violations& beyond);
/// Swaths of headland passes stay in the field and enter no obstacle. Pass i keeps (i − ½)·w off every
/// boundary that has at least i passes. A closed pass has the land it goes round on its left.
void check_passes(const Case& c, Violations& out);
/// No headland pass has a useless stretch: in no stretch does it work so much land again, or so much beyond
/// the headland, that omitting the stretch would be far better. O(n·k) for n slices of half the width, k of
/// them at one spot.
void check_worth(const Case& c, Violations& out);
/// Where pieces state their overlap, it is the area of their swath that lies outside the body or has been
/// worked before, by another swath or by the same; and where all pieces do, the sum is the plan's overlap.
void check_swath_overlaps(const Case& c, Violations& out);
/// No detour's swath comes nearer to an obstacle than the clearance, nor enters a passable or land
/// given up. Where there is a clearance, straight and curved swaths keep it too.
void check_clearance(const Case& c, Violations& out);
/// The machine can drive every detour, curve and headland pass: no arc is too tight and no heading jumps.
/// Findings where the plan's tracks are lines of others or made as a paper makes them, and in the middle of
/// the paper's detours; plain headlands (HeadlandConstruction::kPlain) have corners.
void check_drivable(const Case& c, Violations& out, Violations& findings);
/// Each piece obeys the end rule over all its straight parts, or all along its curve. In a repair the land to
/// cover is that of any gap, and the work may go on over breaks of less than kLeastBreak_m.
void check_ends(const Case& c, Violations& out);
/// Where tracks follow a curve, and in a plan of lines of others, no two pieces of a subfield lie less than
/// the working width apart, across either of them.
void check_parallel(const Case& c, Violations& out);
/// Where tracks follow a curve, every piece lies on the line of its track except on its detours: at samples a
/// width apart or less, it is (k + ½) widths from the reference on its side, or rolls round a corner. Not
/// checked in a repair, nor along a reference that no machine could follow.
void check_track_lines(const Case& c, Violations& out);
/// Where tracks begin at the envelope of the body, the reference is a straight line, all subfields lie to its
/// right, the nearest of them at the line, and track k runs (k + ½) widths from it. Not checked in a repair.
void check_ab_anchor(const Case& c, Violations& out);
/// No piece is too short to drive, except those between crossings, and no dropped one is said to be that is
/// not.
void check_length(const Case& c, Violations& out);
/// A piece is flagged as ending in a stop where neither a quarter turn to the left nor one to the right leads
/// off the track on land where the machine may turn, and nowhere else. Ends before passable obstacles that
/// the track crosses are not stops. Where turns were not planned (StopRule::kTouching), a stop is an end
/// whose first millimetre beyond reaches an obstacle without headland or given-up land. Returns the number of
/// stops found.
int check_stops(const Case& c, Violations& out);
/// Every planned turn begins where its piece ends and ends where the next one begins, in place and heading,
/// without gaps; no tighter than the machine's radius, in reverse only where it may, steered no faster than
/// it can; and where it is said to fit, its outline stays on the land, at places 5 cm apart. Its time is that
/// of its lengths, speeds and changes of gear.
void check_turns(const Case& c, Violations& out);
/// Every leg of the route has a path of sound numbers; else the other rules of routes cannot be checked, and
/// it returns false.
bool check_route_is_sound(const Plan& plan, Violations& out);
/// The route drives every piece once, in the order of the plan, and every headland pass once, in one go,
/// either way round and from any place where it is closed; before all pieces or after them, and in the
/// sequence, as the settings ask; round obstacles also behind the pieces that end beside the pass. Crossings
/// are driven straight on. Each work leg is where the axle is while the implement works its piece. The work
/// is on along pieces and passes, off on passable obstacles, and off everywhere else.
void check_route_order(const Case& c, Violations& out);
/// Each leg begins in the pose in which the one before it ends, the first at the start gate; the last ends at
/// the end gate, or as near to it as the machine has room; without gates both are at work. A leg has one
/// gear. Ways between works are no tighter than the machine's radius and steered no faster than it can.
/// Reverse is driven out of works and into them, elsewhere only where the machine may, and never with a
/// drawbar in tow. Times are those of lengths, speeds and changes of gear.
void check_route_legs(const Case& c, Violations& out);
/// To back out is to drive back along the works before the leg, or behind it, and nothing else: by that name
/// a machine reverses that otherwise may not.
void check_route_backing(const Case& c, Violations& out);
/// Where work begins a towed implement is no farther beside its line than the leg before states.
void check_route_towing(const Case& c, Violations& out);
/// What the legs with the work off lead over is as long as the plan states, but for what lies within 2 cm of
/// the borders of worked land and of the tracks.
void check_route_driven_over(const Case& c, Violations& out);
/// Along every leg the outline stays on the land, at places 5 cm apart. Passable obstacles are land except to
/// turn on. A leg that says that it lacks room is a finding, and lacks no more than it says; so are works
/// that leave a soft boundary farther than turns may: rules of tracks say how far they reach.
void check_route_room(const Case& c, Violations& out, Violations& findings);
/// No bound of the route exceeds its time, nor what the prices of its nodes prove: a least spanning tree over
/// its lines and gates, between whose ends no way is shorter than those of Dubins, Reeds and Shepp.
/// O(n²) for n lines.
void check_route_bound(const Case& c, Violations& out);
/// What the route drives amounts to the areas of the tally, by the coverage engine. Not checked where tracks
/// or passes have kinks by construction, nor where figures count tracks alone.
void check_route_areas(const Case& c, Violations& out);
/// A piece after a crossing continues the line beyond a passable, with nothing else in the gap. Where tracks
/// follow a curve the line between two pieces is not known: the second begins ahead of the first. In a repair
/// the crossed land is worked land within the field.
void check_crossings(const Case& c, Violations& out);
/// Detours leave the line of their track, come back to it, and pass obstacles on the side they state. They
/// name the obstacles that lie beside that line, nearer than half the width and the clearance, and so do the
/// encounters there, of which there is at least one. Other obstacles that they name lie beside the line too,
/// on the side passed.
void check_detours(const Case& c, Violations& out);
/// Tracks do what their encounters state: where a way past was chosen, a detour takes it and names the
/// encounter's obstacles; where a cut was chosen, the track does not go on.
void check_encounters(const Case& c, Violations& out);
/// Wherever an obstacle without headland or land given up lies across the line of a track, between two of its
/// pieces, dropped ones included, there is an encounter that names it. Not checked beyond the last piece of a
/// track, since the file does not say what would have followed, nor in a repair, which makes no choices at
/// obstacles, nor where the lines are not known. O(g·e + k²) for g such gaps, e encounters and k pieces along
/// one line.
void check_listed_encounters(const Case& c, Violations& out);
/// Each way past an encounter has either a cost or a reason why it is impossible, and the chosen one has a
/// cost. Where the cheapest ways were asked for, the chosen one costs least: no other way, nor a cut, is
/// cheaper by more than rounding.
void check_ways(const Case& c, Violations& out);
/// The detours are allowed by the settings. With Avoidance::kCut there are none. With kPaper each passes one
/// encounter, and nothing on its track that is as wide across it as the threshold; encounters offer one side
/// at most, and are cut only where that side is not possible or another detour of the track may be in its
/// way.
void check_avoidance(const Case& c, Violations& out);
/// The stored tallies, cost and layers agree with the tracks and headland passes. `stops` is what check_stops
/// found. Returns the recomputed tallies.
struct Tallies {
  Tally whole;   ///< of tracks and headland passes
  Tally tracks;  ///< of the tracks alone, against the body
};
Tallies check_tally(const Case& c, int stops, Violations& out);
/// The stored tally of the headland and the layer of its uncovered land agree with its passes.
void check_headland_tally(const Case& c, Violations& out);

/// No bound exceeds the cost of a known plan: this one, those of the front, and for one direction the best
/// one found. Bounds, costs and prices are not negative. The bounds themselves are not verified.
void check_proof(const Plan& plan, Violations& out);
/// Where prices of the land prove a bound (GroundPrices): cells are convex and lie next to one another, no
/// price is above that of uncovered land, no piece of any direction and offset, straight or with detours, is
/// worth more than its turn, and the bound is no more than the land is worth less one turn.
void check_prices(const Plan& plan, Violations& out);
/// The plans of the front ascend in overlap, and none is dominated by or equal to another. The cost of each
/// follows from its figures at the plan's prices, its turns from its number of tracks, and its areas add up
/// to the land there is. All marks except the knee are on the right plans. O(f²) for f plans.
void check_front(const Case& c, Violations& out);

/// The same for one line and the swath along it, whether it is a plan's or only drawn: it is within the field
/// except at its ends, and keeps its clearance from land. Violations call it `name`.
void check_line_within_field(const Case& c, const SwathClearance& line, const std::string& name,
                             Violations& out);
void check_clearance_of(const Case& c, const SwathClearance& swath, const std::string& name, Violations& out);

/// The stretch of the track's line that a detour replaces, in the detour's heading; nullopt where the detour
/// does not lead from the line back to it, or the line is not known.
std::optional<Path> replaced_line(const Case& c, const TrackPiece& piece, const Detour& detour);
/// The encounters on the stretch of the track that a detour replaces. O(e).
std::vector<const Encounter*> encounters_at(const Case& c, const TrackPiece& piece, const Detour& detour);
/// Whether any of the encounters names the obstacle.
bool names(const std::vector<const Encounter*>& encounters, std::size_t obstacle);

}  // namespace tramline::check
