#include "tramline/check/verify.h"

namespace tramline::check {

// NOLINTNEXTLINE(readability-function-size): a name for each rule
std::string_view name(Rule rule) {
  switch (rule) {
    case Rule::kBody:
      return "body";
    case Rule::kClearance:
      return "clearance";
    case Rule::kCrossings:
      return "crossings";
    case Rule::kDrivable:
      return "drivable";
    case Rule::kEncounters:
      return "encounters";
    case Rule::kEnds:
      return "ends";
    case Rule::kField:
      return "field";
    case Rule::kFront:
      return "front";
    case Rule::kHeadland:
      return "headland";
    case Rule::kLayers:
      return "layers";
    case Rule::kLength:
      return "length";
    case Rule::kParallel:
      return "parallel";
    case Rule::kPieces:
      return "pieces";
    case Rule::kProof:
      return "proof";
    case Rule::kRouteAreas:
      return "route areas";
    case Rule::kRouteBound:
      return "route bound";
    case Rule::kRouteDrivenOver:
      return "route driven over";
    case Rule::kRouteLegs:
      return "route legs";
    case Rule::kRouteOrder:
      return "route order";
    case Rule::kRouteRoom:
      return "route room";
    case Rule::kShapes:
      return "shapes";
    case Rule::kStops:
      return "stops";
    case Rule::kSubfields:
      return "subfields";
    case Rule::kSwathOverlap:
      return "swath overlap";
    case Rule::kSwaths:
      return "swaths";
    case Rule::kTally:
      return "tally";
    case Rule::kTurns:
      return "turns";
    case Rule::kWarnings:
      return "warnings";
    case Rule::kWholeCost:
      return "whole cost";
  }
  return "";
}

}  // namespace tramline::check
