#pragma once
// A plan: every piece the machine drives over a field, with its areas, counts and cost.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tramline/geometry/angle.h"
#include "tramline/geometry/polygon/region.h"
#include "tramline/model/field.h"
#include "tramline/model/front.h"
#include "tramline/model/headland.h"
#include "tramline/model/machine.h"
#include "tramline/model/manoeuvre.h"
#include "tramline/model/objective.h"
#include "tramline/model/report.h"
#include "tramline/model/route.h"
#include "tramline/model/tally.h"
#include "tramline/model/track.h"

namespace tramline {

/// Where a swath ends at a soft edge that crosses it obliquely (glossary: end rule).
enum class EndRule { kCentre, kCover, kInside, kCheapest };
enum class EdgeKind { kSoft, kHard };
/// kBest searches every direction and offset, and divides the land where that pays; kSweep is Versleijen's
/// search.
enum class Strategy { kBest, kSweep };
/// The shape of tracks: straight, along a curve, or whichever of the two costs less.
enum class TrackShape { kStraight, kCurved, kAuto };
/// How tracks along a line are made. kParallel: each parallel to the line itself, and drivable. kPaper: as in
/// Zhou §2.3.4, each from the one before it with all kinks, for comparison.
enum class TrackConstruction { kParallel, kPaper };
/// Where straight tracks along a line lie. kLine: the line is the border of a swath. kEnvelope: as in
/// Zhou §2.3.4 the first swath lies along that side of the envelope of the body that is parallel to the line
/// and on its left, so that the tracks lie to the right of it. kDefault: kEnvelope for straight tracks made
/// as in the paper, kLine for all others; no plan has it.
enum class AbAnchor { kDefault, kLine, kEnvelope };
/// How a cell gets its direction: along the long side of its smallest bounding rectangle (Versleijen §2.2.1),
/// or at right angles to its least width.
enum class CellDirection { kRectangle, kWidth };
/// Where the tracks of a plan come from. kPlanned: laid here. kLines: lines that somebody else drew or
/// planned; only their figures are ours, and no rule of planning applies to them.
enum class PlanOrigin { kPlanned, kLines };

/// Land that the user wants to be subfields of its own: one for each connected part of it that tracks work.
struct GivenSubfield {
  Region shape;                          ///< may reach beyond the field
  std::string origin;                    ///< "cuts.gpkg feature 3"
  std::optional<Direction> direction{};  ///< of its tracks
  std::vector<Point> guide{};            ///< a line its tracks run parallel to; goes before the direction
};

/// A line that the user wants to divide land along. It may reach beyond the field.
struct GivenCut {
  std::vector<Point> line;
  std::string origin;
};

/// What the user decides about the land of a field. Frame: the field's local metres. Subfields and land left
/// out do not overlap one another.
struct GivenLand {
  std::vector<GivenSubfield> subfields;
  std::vector<GivenCut> cuts;  ///< of the land that no subfield takes up
  Region left_out;             ///< not to be worked: it is given up
  Region done;                 ///< worked before
  Region elsewhere;  ///< not to be worked now: swaths may run on over it, as over land worked before
  std::vector<std::string> remarks;  ///< what became of the shapes that the user drew; sentences

  bool divides() const { return !subfields.empty() || !cuts.empty(); }
};

/// How many headland passes there are. kPasses: as many as the settings say. kTurns: as many as the turns at
/// the ends of the tracks need, and none along edges where no track ends.
enum class HeadlandRule { kPasses, kTurns };
/// What is planned between the tracks. kTurns: the turn from each to the next. kRoute: the whole route,
/// headland passes and gates included.
enum class TurnPlanning { kNone, kTurns, kRoute };

/// What the planner makes least. kCost: the cost of tracks and passes by the objective (Plan::cost).
/// kWholeCost: the euros of the whole route (WholeCost), with TurnPlanning::kRoute.
enum class Aim { kCost, kWholeCost };

/// Everything besides field, machine and objective that shapes a plan.
struct PlanSettings {
  Aim aim = Aim::kCost;
  Strategy strategy = Strategy::kBest;
  EndRule end_rule = EndRule::kCheapest;
  EdgeKind boundary = EdgeKind::kSoft;  ///< kind of the field's outer ring; obstacles are hard
  CellDirection cell_direction = CellDirection::kRectangle;
  Angle direction_tolerance = Angle::degrees(0.01);  ///< resolution of directions with Strategy::kBest
  /// Versleijen §2.2.3. Neighbouring cells are merged whose directions differ by at most this
  /// (Strategy::kSweep), or by less (kBest).
  Angle merge_threshold = Angle::degrees(1);
  Angle decomposition_threshold = Angle::degrees(180);  ///< Versleijen §2.2.2
  double short_edge_m = 0;     ///< Versleijen §4.2.1: a corner of two shorter edges does not split the field
  double small_cell_m2 = 200;  ///< Versleijen §2.2.3
  Avoidance avoid = Avoidance::kCheapest;
  double avoid_threshold_m = -1;  ///< Versleijen table 3, with Avoidance::kPaper; negative: the default, w
  /// With Avoidance::kPaper: detours leave their track by this at most; negative: however far they have to.
  /// Half the width is what the program of Versleijen 2019 allowed (§4.3, fig. 50 a).
  double avoid_room_m = -1;
  double clearance_m = 0;      ///< kept between swaths and obstacles
  int headlands = 0;           ///< passes round the field (Zhou §2.3.3); with any, nothing leaves the field
  int obstacle_headlands = 0;  ///< passes round each obstacle that tracks do not avoid by detours
  HeadlandRule headland_rule = HeadlandRule::kPasses;
  HeadlandRule obstacle_headland_rule = HeadlandRule::kPasses;
  TurnPlanning turns = TurnPlanning::kNone;
  TrackShape shape = TrackShape::kStraight;
  /// Within a block of tracks that lie side by side, each is followed by one at least so many tracks away; 1:
  /// the planner's choice.
  int skip = 1;
  RouteSettings route{};  ///< with TurnPlanning::kRoute
  /// How far outside a soft boundary without headland the machine may turn, m; negative: as far as it needs.
  double turn_room_m = -1;
  /// The most by which a towed implement may be beside its track where the work begins, m.
  double towing_error_m = 0.1;
  /// kPaper requires the end rule kCover, a soft boundary, and tracks along a line or a curve.
  TrackConstruction tracks = TrackConstruction::kParallel;
  /// Tracks run parallel to this line, local metres, and are numbered from it: it is the border of the
  /// swaths 0 and −1 (Zhou §2.3.4), or is moved to where it is (`ab_anchor`). Empty: the planner's
  /// choice.
  std::vector<Point> guide;
  AbAnchor ab_anchor = AbAnchor::kDefault;  ///< kEnvelope requires a guide of two points
  /// Passes by edge of Field::outer, edge i from vertex i to vertex i + 1; empty: `headlands` everywhere,
  /// else `headlands` is the largest of them. Different numbers require TrackConstruction::kParallel.
  std::vector<int> headland_edges{};
  GivenLand given;  ///< not kept in plan files, where Plan says what became of it
  /// Whether prices on the ground are sought that prove a sharper bound of plans with any division, which
  /// takes seconds. Not kept in plan files: those that were found are.
  bool prove = false;
};

/// Why a piece is not worth driving. kShort: shorter than the machine's least length (Versleijen §2.2.1).
/// kWay: to go there costs more than its land is worth.
enum class DroppedFor { kShort, kWay };

/// The anchor that the settings amount to: never kDefault.
AbAnchor anchor_of(const PlanSettings& settings);

const char* name(Aim aim);                ///< cost, whole_cost
const char* name(EndRule rule);           ///< centre, cover, inside, cheapest
const char* name(EdgeKind kind);          ///< soft, hard
const char* name(Strategy strategy);      ///< best, sweep
const char* name(CellDirection choice);   ///< rectangle, width
const char* name(Avoidance choice);       ///< cheapest, paper, cut
const char* name(TrackShape shape);       ///< straight, curved, auto
const char* name(TrackConstruction how);  ///< parallel, paper
const char* name(AbAnchor anchor);        ///< line, envelope; default
const char* name(Passing way);            ///< left, right, cut
const char* name(DroppedFor why);         ///< short, way
const char* name(PlanOrigin origin);      ///< planned, lines
const char* name(HeadlandRule rule);      ///< passes, auto
const char* name(TurnPlanning choice);    ///< none, planned, route
/// The inverse of name(); nullopt for any other word.
std::optional<Aim> aim_named(std::string_view word);
std::optional<EndRule> end_rule_named(std::string_view word);
std::optional<EdgeKind> edge_kind_named(std::string_view word);
std::optional<Strategy> strategy_named(std::string_view word);
std::optional<CellDirection> cell_direction_named(std::string_view word);
std::optional<Avoidance> avoidance_named(std::string_view word);
std::optional<TrackShape> track_shape_named(std::string_view word);
std::optional<TrackConstruction> track_construction_named(std::string_view word);
std::optional<AbAnchor> ab_anchor_named(std::string_view word);  ///< not for default
std::optional<Passing> passing_named(std::string_view word);
std::optional<DroppedFor> dropped_for_named(std::string_view word);
std::optional<PlanOrigin> plan_origin_named(std::string_view word);
std::optional<HeadlandRule> headland_rule_named(std::string_view word);
std::optional<TurnPlanning> turn_planning_named(std::string_view word);

/// In a repair the work goes on over worked land that is shorter than this along a line, m: a shorter break
/// is not worth switching off for.
inline constexpr double kLeastBreak_m = 2;

/// The end of a given line is a stop where an obstacle begins within this distance ahead of it, m: exports
/// are this exact. Ends of planned tracks are exact.
inline constexpr double kAheadOfLine_m = 0.01;
/// Less of it there does not count, m²: a tenth of a millimetre beside the swath.
inline constexpr double kAheadOfLine_m2 = 1e-6;

/// Prices on the ground that prove a bound for plans with any division (docs/bounds.md).
struct GroundPrices {
  struct Cell {
    Ring shape;        ///< convex, local metres
    double price = 0;  ///< per m² of its land
  };
  std::vector<Cell> cells;  ///< next to one another
  double bound = 0;         ///< no plan of tracks costs less, further subfields not counted
};

/// What a search proved about the plans it did not make. Where the strategy proves nothing a bound is 0,
/// which no cost falls below.
struct Proof {
  double bound = 0;                ///< no plan costs less (docs/bounds.md: the class of plans)
  double one_direction_cost = 0;   ///< cost of the best plan found with the land undivided
  double one_direction_bound = 0;  ///< no plan with the land undivided costs less
  bool cut_short = false;          ///< the search was ended before it was complete
  GroundPrices prices;             ///< where they were asked for (PlanSettings::prove)
};

/// What the figures and layers of a plan count: tracks and headland passes compared with all land or, in
/// files of earlier versions, tracks alone compared with the body.
enum class PlanFigures { kTracksAndPasses, kTracks };

/// Which ends of pieces are stops. kNoWayOff: those from which no turn leads away. kTouching: those against
/// an obstacle without headland or land given up, as in files of earlier versions and of lines of others.
enum class StopRule { kNoWayOff, kTouching };

/// What a plan is made for: the land of a field, all of it or less what is done, or the gaps that another
/// drive has left.
enum class PlanKind { kField, kRepair };

/// (cost − bound)/cost; 0 where the cost is 0.
double gap(double cost, double bound);

struct Subfield {
  Polygon shape;        ///< may contain passable obstacles; of given lines: about where they lie
  Direction direction;  ///< of its tracks; where they follow a curve, that of the curve as a whole
  Path reference{};     ///< line its tracks run parallel to, where they follow a line or a curve; else empty
  std::string given_by{};  ///< where the user drew it: "cuts.gpkg feature 3"; empty: the planner's choice
};

/// A piece that is not worth driving. It is reported, and its land counts as uncovered.
struct DroppedPiece {
  Point start;
  Point end;
  std::size_t subfield = 0;  ///< index into Plan::subfields
  DroppedFor why = DroppedFor::kShort;
};

/// Frame: the field's local metres.
struct Plan {
  PlanOrigin origin = PlanOrigin::kPlanned;
  Field field;
  Machine machine;
  Objective objective;
  PlanSettings settings;
  PlanKind kind = PlanKind::kField;
  Region body;  ///< field minus obstacles, passable ones included, minus headlands, minus land worked before;
                ///< of a repair: the gaps
  Region
      worked;  ///< the rest of the field minus obstacles, where the plan is not for all of it: worked before,
               ///< not to be worked now, or left for good; swaths may run on over it. Without headlands
  Headland headland;
  /// The part of the body that lies between clustered obstacles, between an obstacle and the edge, or nearer
  /// to an obstacle than the clearance; hard. Then the part that the user wants left out, as hard.
  Region given_up;
  std::size_t left_out =
      0;  ///< how many of the last polygons of given_up are land that the user wants left out
  std::vector<Subfield> subfields;
  std::vector<TrackPiece> pieces;  ///< in driving order
  std::vector<DroppedPiece> dropped;
  /// By edge of Field::outer, where turns were planned and the boundary is soft: how far beyond it turns
  /// reach, m. Not kept in plan files.
  std::vector<double> room_beyond_m;
  std::vector<PlannedTurn> turns;     ///< where settings.turns asks for them, by piece
  Route route;                        ///< where settings.turns asks for it
  std::vector<Encounter> encounters;  ///< by subfield, track and position along it
  PlanFigures figures = PlanFigures::kTracksAndPasses;
  StopRule stop_rule = StopRule::kTouching;
  /// Areas: of all swaths and headland passes compared with the land, which is body and headland. Counts and
  /// track length: of the tracks alone. Σ width · length of both = area of the land − uncovered + overlap.
  Tally tally;
  /// The same for the tracks alone, compared with the body. Its sum with the headland's figures may differ
  /// from `tally`.
  Tally track_tally;
  double cost = 0;   ///< of `tally`
  Region overlap;    ///< land worked outside the land to work, or worked more than once
  Region uncovered;  ///< land that neither swath nor headland pass covers
  int directions_tried = 0;
  Proof proof;
  std::vector<std::string> warnings;
  Front front;  ///< other plans of the field to choose from, where they were asked for
};

/// The area that a plan has to cover, m²: the field less its obstacles, passable ones included, and less the
/// land worked before; of a repair, the gaps; with PlanFigures::kTracks, the body.
double land_m2(const Plan& plan);

/// Σ w·L of tracks and passes − (land − uncovered + overlap), m²: 0 but for rounding, whatever the plan
/// (follows from Zhou §2.3.5; Zhou table 4 meets it).
double identity_error_m2(const Plan& plan);

/// Whether it is a plan for the gaps that another drive has left.
inline bool is_repair(const Plan& plan) { return plan.kind == PlanKind::kRepair; }

/// The part of the land given up that the user wants left out. Precondition: left_out is at most the number
/// of polygons given up.
Region left_out_land(const Plan& plan);

/// Whether its tracks are lines that somebody else drew or planned.
inline bool is_of_lines(const Plan& plan) { return plan.origin == PlanOrigin::kLines; }

/// Whether any track follows a curve.
bool is_curved(const Plan& plan);

/// How many tracks follow a curve, by subfield. Precondition: every piece belongs to a subfield.
std::vector<int> curved_tracks_by_subfield(const Plan& plan);

/// "straight", "curved" or, where there are both, "straight and curved".
const char* kind_of_tracks(const Plan& plan);

/// The reference lines that tracks follow, each once, in the order of the subfields. O(subfields²).
std::vector<Path> references(const Plan& plan);

/// How often the machine stops to back out or in: as its route says or, where there is none, Tally::stops.
/// O(legs).
std::size_t stops(const Plan& plan);

/// The line that the tracks of all subfields follow; nullopt where some follow another one, or none.
std::optional<Path> common_reference(const Plan& plan);

/// All swaths, in driving order.
Region swaths(const Plan& plan);

}  // namespace tramline
