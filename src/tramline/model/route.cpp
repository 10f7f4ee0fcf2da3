#include "tramline/model/route.h"

#include <algorithm>
#include <array>

namespace tramline {
namespace {

template <class Value, std::size_t count>
std::optional<Value> named(std::string_view word, const std::array<Value, count>& values) {
  const auto found =
      std::find_if(values.begin(), values.end(), [&](Value value) { return word == name(value); });
  return found == values.end() ? std::nullopt : std::optional(*found);
}

constexpr std::array kLegKinds = {LegKind::kWork, LegKind::kHeadland, LegKind::kTurn, LegKind::kTransit,
                                  LegKind::kBackOut};
constexpr std::array kOrders = {TrackOrder::kBest, TrackOrder::kBySpacing};
constexpr std::array kTimes = {PassTime::kFirst, PassTime::kLast};
constexpr std::array kSequences = {PassSequence::kAny, PassSequence::kInwards, PassSequence::kOutwards};
constexpr std::array kCorners = {PassCorners::kAuto, PassCorners::kRound};

/// The sum that a leg of this kind is part of.
double& share_of(RouteSums& sums, LegKind kind) {
  switch (kind) {
    case LegKind::kWork:
      return sums.working_m;
    case LegKind::kHeadland:
      return sums.headland_m;
    case LegKind::kTransit:
      return sums.transit_m;
    case LegKind::kTurn:
    case LegKind::kBackOut:
      break;
  }
  return sums.turning_m;
}

}  // namespace

const char* name(LegKind kind) {
  switch (kind) {
    case LegKind::kWork:
      return "work";
    case LegKind::kHeadland:
      return "headland";
    case LegKind::kTurn:
      return "turn";
    case LegKind::kTransit:
      return "transit";
    case LegKind::kBackOut:
      return "back_out";
  }
  return "";
}

const char* name(TrackOrder order) { return order == TrackOrder::kBest ? "best" : "spacing"; }
const char* name(PassTime time) { return time == PassTime::kFirst ? "first" : "last"; }

const char* name(PassCorners corners) { return corners == PassCorners::kAuto ? "auto" : "round"; }

const char* name(PassSequence sequence) {
  switch (sequence) {
    case PassSequence::kAny:
      return "any";
    case PassSequence::kInwards:
      return "inwards";
    case PassSequence::kOutwards:
      return "outwards";
  }
  return "";
}

std::optional<LegKind> leg_kind_named(std::string_view word) { return named(word, kLegKinds); }
std::optional<TrackOrder> track_order_named(std::string_view word) { return named(word, kOrders); }
std::optional<PassTime> pass_time_named(std::string_view word) { return named(word, kTimes); }
std::optional<PassSequence> pass_sequence_named(std::string_view word) { return named(word, kSequences); }
std::optional<PassCorners> pass_corners_named(std::string_view word) { return named(word, kCorners); }

double length(const RouteLeg& leg) { return length(leg.path); }

bool lacks_room(const RouteLeg& leg, const Machine& machine) {
  constexpr double kFound_m = 0.01;  // to which missing_m is known
  const double allowed_m = leg.kind == LegKind::kHeadland ? corner_swing_m(machine) : 0;
  return leg.missing_m > (allowed_m > 0 ? allowed_m + kFound_m : 0);
}

std::size_t legs_without_room(const Route& route, const Machine& machine) {
  return static_cast<std::size_t>(std::count_if(
      route.legs.begin(), route.legs.end(), [&](const RouteLeg& leg) { return lacks_room(leg, machine); }));
}

RouteSums sums_of(const Route& route) {
  RouteSums out;
  for (const RouteLeg& leg : route.legs) {
    const double length_m = length(leg);
    out.length_m += length_m;
    share_of(out, leg.kind) += length_m;
    if (leg.gear == Gear::kReverse) out.reverse_m += length_m;
    out.time_s += leg.time_s;
    if (leg.kind == LegKind::kBackOut) ++out.back_outs;
  }
  return out;
}

double priced_time_s(const Route& route) {
  const RouteSums sums = sums_of(route);
  return sums.time_s + route.proof.stop_s * static_cast<double>(sums.back_outs);
}

}  // namespace tramline
