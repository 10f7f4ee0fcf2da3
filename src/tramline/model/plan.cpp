#include "tramline/model/plan.h"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <initializer_list>

namespace tramline {
namespace {

template <class Choice>
std::optional<Choice> named(std::string_view word, std::initializer_list<Choice> choices) {
  for (const Choice choice : choices)
    if (word == name(choice)) return choice;
  return std::nullopt;
}

}  // namespace

const char* name(EndRule rule) {
  switch (rule) {
    case EndRule::kCentre:
      return "centre";
    case EndRule::kCover:
      return "cover";
    case EndRule::kInside:
      return "inside";
    case EndRule::kCheapest:
      return "cheapest";
  }
  return "";
}

const char* name(Aim aim) { return aim == Aim::kCost ? "cost" : "whole_cost"; }

const char* name(EdgeKind kind) { return kind == EdgeKind::kSoft ? "soft" : "hard"; }

const char* name(Strategy strategy) { return strategy == Strategy::kBest ? "best" : "sweep"; }

const char* name(CellDirection choice) { return choice == CellDirection::kRectangle ? "rectangle" : "width"; }

const char* name(Avoidance choice) {
  switch (choice) {
    case Avoidance::kCheapest:
      return "cheapest";
    case Avoidance::kPaper:
      return "paper";
    case Avoidance::kCut:
      return "cut";
  }
  return "";
}

const char* name(TrackShape shape) {
  switch (shape) {
    case TrackShape::kStraight:
      return "straight";
    case TrackShape::kCurved:
      return "curved";
    case TrackShape::kAuto:
      return "auto";
  }
  return "";
}

const char* name(TrackConstruction how) { return how == TrackConstruction::kPaper ? "paper" : "parallel"; }

const char* name(AbAnchor anchor) {
  switch (anchor) {
    case AbAnchor::kDefault:
      return "default";
    case AbAnchor::kLine:
      return "line";
    case AbAnchor::kEnvelope:
      return "envelope";
  }
  return "";
}

AbAnchor anchor_of(const PlanSettings& settings) {
  if (settings.ab_anchor != AbAnchor::kDefault) return settings.ab_anchor;
  const bool as_in_the_paper = settings.tracks == TrackConstruction::kPaper;
  return as_in_the_paper && settings.guide.size() == 2 ? AbAnchor::kEnvelope : AbAnchor::kLine;
}

const char* name(DroppedFor why) { return why == DroppedFor::kWay ? "way" : "short"; }

const char* name(Passing way) {
  switch (way) {
    case Passing::kLeft:
      return "left";
    case Passing::kRight:
      return "right";
    case Passing::kCut:
      return "cut";
  }
  return "";
}

const char* name(TurnPlanning choice) {
  switch (choice) {
    case TurnPlanning::kNone:
      return "none";
    case TurnPlanning::kTurns:
      return "planned";
    case TurnPlanning::kRoute:
      return "route";
  }
  return "";
}
const char* name(HeadlandRule rule) { return rule == HeadlandRule::kTurns ? "auto" : "passes"; }
const char* name(PlanOrigin origin) { return origin == PlanOrigin::kLines ? "lines" : "planned"; }

std::optional<EndRule> end_rule_named(std::string_view word) {
  return named(word, {EndRule::kCentre, EndRule::kCover, EndRule::kInside, EndRule::kCheapest});
}
std::optional<EdgeKind> edge_kind_named(std::string_view word) {
  return named(word, {EdgeKind::kSoft, EdgeKind::kHard});
}
std::optional<Aim> aim_named(std::string_view word) { return named(word, {Aim::kCost, Aim::kWholeCost}); }
std::optional<Strategy> strategy_named(std::string_view word) {
  return named(word, {Strategy::kBest, Strategy::kSweep});
}
std::optional<CellDirection> cell_direction_named(std::string_view word) {
  return named(word, {CellDirection::kRectangle, CellDirection::kWidth});
}
std::optional<Avoidance> avoidance_named(std::string_view word) {
  return named(word, {Avoidance::kCheapest, Avoidance::kPaper, Avoidance::kCut});
}
std::optional<TrackShape> track_shape_named(std::string_view word) {
  return named(word, {TrackShape::kStraight, TrackShape::kCurved, TrackShape::kAuto});
}
std::optional<TrackConstruction> track_construction_named(std::string_view word) {
  return named(word, {TrackConstruction::kParallel, TrackConstruction::kPaper});
}
std::optional<AbAnchor> ab_anchor_named(std::string_view word) {
  return named(word, {AbAnchor::kLine, AbAnchor::kEnvelope});
}
std::optional<Passing> passing_named(std::string_view word) {
  return named(word, {Passing::kLeft, Passing::kRight, Passing::kCut});
}

std::optional<DroppedFor> dropped_for_named(std::string_view word) {
  return named(word, {DroppedFor::kShort, DroppedFor::kWay});
}

std::optional<HeadlandRule> headland_rule_named(std::string_view word) {
  return named(word, {HeadlandRule::kPasses, HeadlandRule::kTurns});
}
std::optional<TurnPlanning> turn_planning_named(std::string_view word) {
  return named(word, {TurnPlanning::kNone, TurnPlanning::kTurns, TurnPlanning::kRoute});
}
std::optional<PlanOrigin> plan_origin_named(std::string_view word) {
  return named(word, {PlanOrigin::kPlanned, PlanOrigin::kLines});
}

double gap(double cost, double bound) { return cost > 0 ? (cost - bound) / cost : 0; }

double land_m2(const Plan& plan) {
  const double headland_m2 = plan.figures == PlanFigures::kTracks ? 0 : area(plan.headland.ground);
  return area(plan.body) + headland_m2;
}

double identity_error_m2(const Plan& plan) {
  double length_m = 0;
  for (const TrackPiece& piece : plan.pieces) length_m += length(piece);
  const double by_passes_m2 = plan.figures == PlanFigures::kTracks ? 0 : plan.headland.worked_m2;
  return plan.machine.width_m * length_m + by_passes_m2 -
         (land_m2(plan) - plan.tally.uncovered_m2 + plan.tally.overlap_m2);
}

Region left_out_land(const Plan& plan) {
  assert(plan.left_out <= plan.given_up.size());
  return {plan.given_up.end() - static_cast<std::ptrdiff_t>(plan.left_out), plan.given_up.end()};
}

bool is_curved(const Plan& plan) {
  return std::any_of(plan.pieces.begin(), plan.pieces.end(),
                     [](const TrackPiece& piece) { return !piece.curve.empty(); });
}

std::vector<int> curved_tracks_by_subfield(const Plan& plan) {
  std::vector<int> out(plan.subfields.size(), 0);
  for (const TrackPiece& piece : plan.pieces) {
    assert(piece.subfield < out.size());
    if (!piece.curve.empty()) ++out[piece.subfield];
  }
  return out;
}

const char* kind_of_tracks(const Plan& plan) {
  if (!is_curved(plan)) return "straight";
  const bool all = std::none_of(plan.pieces.begin(), plan.pieces.end(),
                                [](const TrackPiece& piece) { return piece.curve.empty(); });
  return all ? "curved" : "straight and curved";
}

std::size_t stops(const Plan& plan) {
  return plan.route.planned() ? sums_of(plan.route).back_outs : static_cast<std::size_t>(plan.tally.stops);
}

std::vector<Path> references(const Plan& plan) {
  std::vector<Path> out;
  for (const Subfield& subfield : plan.subfields)
    if (!subfield.reference.empty() && std::find(out.begin(), out.end(), subfield.reference) == out.end())
      out.push_back(subfield.reference);
  return out;
}

std::optional<Path> common_reference(const Plan& plan) {
  const auto differs = [&plan](const Subfield& subfield) {
    return subfield.reference.empty() || subfield.reference != plan.subfields.front().reference;
  };
  if (plan.subfields.empty() || std::any_of(plan.subfields.begin(), plan.subfields.end(), differs))
    return std::nullopt;
  return plan.subfields.front().reference;
}

Region swaths(const Plan& plan) {
  Region out;
  out.reserve(plan.pieces.size());
  for (const TrackPiece& piece : plan.pieces) out.push_back({swath(piece, plan.machine.width_m), {}});
  return out;
}

}  // namespace tramline
