#pragma once
// The names of the rules, as violations and reports give them.

namespace tramline::check::rule {

inline constexpr const char* kBody = "body";
inline constexpr const char* kClearance = "clearance";
inline constexpr const char* kCrossings = "crossings";
inline constexpr const char* kDrivable = "drivable";
inline constexpr const char* kEncounters = "encounters";
inline constexpr const char* kEnds = "ends";
inline constexpr const char* kField = "field";
inline constexpr const char* kFront = "front";
inline constexpr const char* kHeadland = "headland";
inline constexpr const char* kLayers = "layers";
inline constexpr const char* kLength = "length";
inline constexpr const char* kParallel = "parallel";
inline constexpr const char* kPieces = "pieces";
inline constexpr const char* kProof = "proof";
inline constexpr const char* kShapes = "shapes";
inline constexpr const char* kStops = "stops";
inline constexpr const char* kSubfields = "subfields";
inline constexpr const char* kSwathOverlap = "swath overlap";
inline constexpr const char* kSwaths = "swaths";
inline constexpr const char* kTally = "tally";
inline constexpr const char* kWarnings = "warnings";

}  // namespace tramline::check::rule
