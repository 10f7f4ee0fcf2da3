#pragma once
// The whole route of a machine over a field: every leg from the first metre to the last, in driving order.

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "tramline/geometry/path/steered_path.h"
#include "tramline/geometry/point.h"
#include "tramline/model/machine.h"

namespace tramline {

/// kWork: along a piece of a track. kHeadland: along a headland pass. kTurn: from one of these to a
/// neighbouring one. kTransit: any other way with the work off – along passes, past obstacles, to and from
/// the gates, across a passable obstacle. kBackOut: in reverse along the track or pass, out of its end or
/// into it.
enum class LegKind { kWork, kHeadland, kTurn, kTransit, kBackOut };
const char* name(LegKind kind);  ///< work, headland, turn, transit, back_out
std::optional<LegKind> leg_kind_named(std::string_view word);

/// A stretch of the route of one kind, driven in one gear, with the work on or off.
struct RouteLeg {
  LegKind kind = LegKind::kTurn;
  Gear gear = Gear::kForward;
  bool work = false;
  /// The way of the rear axle's middle. A work or headland leg begins when the implement is at the beginning
  /// of its piece or pass, and ends when it has reached the end: the axle is then as far ahead as the
  /// implement is behind it, on the piece or straight on beyond its end.
  SteeredPath path{};
  std::optional<std::size_t> piece{};  ///< of a work leg: index into Plan::pieces
  std::optional<std::size_t> pass{};   ///< of a headland leg: index into Headland::passes
  double time_s = 0;                   ///< a change of gear at its beginning included
  double missing_m = 0;                ///< how far the outline leaves the land where no way has room
  double lateral_error_m = 0;          ///< of a towed implement where the next work begins
};

/// Prices of the nodes of a route, which prove its bound (docs/route.md): of no route over these pieces and
/// passes, with all passes before or after the tracks as asked, or round obstacles among them, do the time
/// and `stop_s` for each back_out come to less than bound_s with this machine. Two for each line, the pieces
/// in driving order of which crossings join several, at its start and at its end; two for each open headland
/// pass, in the order of the passes; one for the gate at which the route starts and one for that at which it
/// ends, where there are any; one for each closed pass that has no sharp corners, in the order of the passes.
struct RouteProof {
  double bound_s = 0;
  double stop_s = 0;  ///< what backing out counts besides its time: its price, in seconds with the work off
  std::vector<double> node_prices_s{};
};

/// The route. Each leg begins in the pose in which the one before it ends.
struct Route {
  std::vector<RouteLeg> legs;
  RouteProof proof;
  // What the legs with the work off lead over, m of the axle's way.
  double over_worked_m = 0;    ///< over land worked before by this route
  double over_unworked_m = 0;  ///< over land that the route works later
  double over_tracks_m = 0;    ///< the part of both that lies on land of tracks, not of headlands

  bool planned() const { return !legs.empty(); }
};

/// Sums over the legs of a route.
struct RouteSums {
  double length_m = 0;
  double working_m = 0;   ///< along tracks
  double headland_m = 0;  ///< along headland passes
  double turning_m = 0;   ///< turns and backing out
  double transit_m = 0;
  double reverse_m = 0;  ///< the part of all that is driven in reverse
  double time_s = 0;
  std::size_t back_outs = 0;  ///< and back into a beginning

  double not_working_m() const { return turning_m + transit_m; }
};
RouteSums sums_of(const Route& route);

/// What the bound of a route is compared with: its time and RouteProof::stop_s for each back_out, s.
double priced_time_s(const Route& route);

double length(const RouteLeg& leg);

/// Whether nobody can drive the leg as it is planned: it leaves the land, and not only because corners of the
/// machine swing out where a headland pass turns (corner_swing_m()), which no way round can change.
bool lacks_room(const RouteLeg& leg, const Machine& machine);
std::size_t legs_without_room(const Route& route, const Machine& machine);

/// Which piece follows. kBest: the order that takes the least time. kBySpacing: neighbouring tracks, or those
/// that PlanSettings::skip asks for.
enum class TrackOrder { kBest, kBySpacing };
/// When headland passes are worked: before all tracks, or after them, or round obstacles after the tracks
/// that end there.
enum class PassTime { kFirst, kLast };
/// Which of several passes along one boundary comes first. kAny: as the way is shortest.
enum class PassSequence { kAny, kInwards, kOutwards };
/// Whether headland passes are driven straight on into corners, out of which the machine backs. kAuto: where
/// that costs less than the land that is left outside a round corner. With Aim::kWholeCost; else they are
/// round.
enum class PassCorners { kAuto, kRound };

const char* name(TrackOrder order);       ///< best, spacing
const char* name(PassTime time);          ///< first, last
const char* name(PassSequence sequence);  ///< any, inwards, outwards
const char* name(PassCorners corners);    ///< auto, round
std::optional<TrackOrder> track_order_named(std::string_view word);
std::optional<PassTime> pass_time_named(std::string_view word);
std::optional<PassSequence> pass_sequence_named(std::string_view word);
std::optional<PassCorners> pass_corners_named(std::string_view word);

/// What a user decides about a route. Gates are points of the field's frame; without them the route starts
/// and ends at a piece or a pass.
struct RouteSettings {
  TrackOrder order = TrackOrder::kBest;
  PassTime passes = PassTime::kLast;
  PassSequence sequence = PassSequence::kAny;
  std::optional<Point> start{};
  std::optional<Point> end{};
  PassCorners corners = PassCorners::kAuto;
};

}  // namespace tramline
