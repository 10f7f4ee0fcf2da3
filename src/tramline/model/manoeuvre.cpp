#include "tramline/model/manoeuvre.h"

#include <array>

#include "tramline/model/speeds.h"

namespace tramline {
namespace {

constexpr std::array kStates = {TurnState::kFits, TurnState::kNoRoom, TurnState::kApart};
constexpr std::array kKinds = {ManoeuvreKind::kU,        ManoeuvreKind::kOmega,  ManoeuvreKind::kUnequalArcs,
                               ManoeuvreKind::kFishtail, ManoeuvreKind::kDubins, ManoeuvreKind::kReedsShepp,
                               ManoeuvreKind::kBackOut};

}  // namespace

const char* name(ManoeuvreKind kind) {
  switch (kind) {
    case ManoeuvreKind::kU:
      return "u";
    case ManoeuvreKind::kOmega:
      return "omega";
    case ManoeuvreKind::kUnequalArcs:
      return "unequal_arcs";
    case ManoeuvreKind::kFishtail:
      return "fishtail";
    case ManoeuvreKind::kDubins:
      return "dubins";
    case ManoeuvreKind::kReedsShepp:
      return "reeds_shepp";
    case ManoeuvreKind::kBackOut:
      return "back_out";
  }
  return "";
}

const char* name(TurnState state) {
  switch (state) {
    case TurnState::kFits:
      return "fits";
    case TurnState::kNoRoom:
      return "no_room";
    case TurnState::kApart:
      return "apart";
  }
  return "";
}

std::optional<TurnState> turn_state_named(std::string_view word) {
  for (const TurnState state : kStates)
    if (word == name(state)) return state;
  return std::nullopt;
}

std::optional<ManoeuvreKind> manoeuvre_kind_named(std::string_view word) {
  for (const ManoeuvreKind kind : kKinds)
    if (word == name(kind)) return kind;
  return std::nullopt;
}

int gear_changes(const Manoeuvre& manoeuvre) {
  const SteeredPath& path = manoeuvre.path;
  if (path.empty()) return 0;
  const auto reverse = [](const SteeredStretch& stretch) { return stretch.gear == Gear::kReverse ? 1 : 0; };
  return reverse(path.front()) + gear_changes(path) + reverse(path.back());
}

double seconds(const Manoeuvre& manoeuvre, const Machine& machine) {
  const Turning& turning = machine.turning;
  double sum = turning.gear_change_s * gear_changes(manoeuvre);
  for (const SteeredStretch& stretch : manoeuvre.path)
    sum += stretch.length_m / speed_with_work_off(stretch.gear, turning);
  return sum;
}

}  // namespace tramline
