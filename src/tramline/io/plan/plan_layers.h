#pragma once
// Names shared by the writer and the reader of plan files.
//
// Numbers for people (order, subfield, track, obstacles) count from 1; the model counts from 0.

#include "tramline/io/field/field_file.h"
#include "tramline/io/geopackage/file_kind.h"
#include "tramline/io/geopackage/metadata.h"

namespace tramline::io {

inline constexpr FileKind kPlanFile{"plan", "tramline plan"};

}  // namespace tramline::io

namespace tramline::io::plan_layers {

inline constexpr const char* kField = field_layers::kField;
inline constexpr const char* kObstacles = field_layers::kObstacles;
inline constexpr const char* kBody = "body";
inline constexpr const char* kWorked = "worked";  ///< only of repairs and of plans for a part of the land
inline constexpr const char* kHeadland = "headland";
inline constexpr const char* kGivenUp = "given_up";
inline constexpr const char* kSubfields = "subfields";
inline constexpr const char* kHeadlandPasses = "headland_passes";
inline constexpr const char* kTracks = "tracks";
inline constexpr const char* kTurns = "turns";           ///< only where turns were planned
inline constexpr const char* kRouteLegs = "route_legs";  ///< only where a route was planned
inline constexpr const char* kSwaths = "swaths";
inline constexpr const char* kOverlap = "overlap";
inline constexpr const char* kUncovered = "uncovered";
inline constexpr const char* kHeadlandUnworked = "headland_unworked";
inline constexpr const char* kDropped = "dropped";
inline constexpr const char* kEncounters = "encounters";
inline constexpr const char* kFront = "front";    ///< only where a front was asked for
inline constexpr const char* kPrices = "prices";  ///< only where a bound by prices of the land was proven
inline constexpr const char* kMetadata = kMetadataTable;
inline constexpr const char* kStyles = "layer_styles";  ///< the name QGIS knows

inline constexpr const char* kStraight = "straight";
inline constexpr const char* kDetour = "detour";
inline constexpr const char* kCurved = "curved";

}  // namespace tramline::io::plan_layers
