#pragma once
// Columns of a plan file as exported. docs/export.md has the table.

#include <string>
#include <string_view>

namespace tramline::io {

/// The name a column has in a Shapefile, whose names have ten characters at most: "stop_at_start" becomes
/// "stop_start". Names that are short enough stay; one not in the list is cut.
std::string shapefile_name(std::string_view column);

/// Whether a column has no meaning outside the plan file: the exact path in the field's own plane, that of
/// the legs of a route, and the detours that are given by its segments. `layer`: its name in the plan file.
bool stays_in_plan_file(std::string_view layer, std::string_view column);

/// What the legs of a route are called outside the plan file.
inline constexpr const char* kRoute = "route";
/// The name that a layer of a plan file has in exports, and the inverse. All but one have the same.
std::string exported_layer(std::string_view in_plan_file);
std::string layer_in_plan_file(std::string_view exported);

/// The column with the number of detours of a track, exported in place of the detours.
inline constexpr const char* kDetourCount = "detour_count";
/// What the column `kind` says of headland passes in the layer of the tracks.
inline constexpr const char* kHeadlandKind = "headland";

/// The title that KML shows beside a feature: "Track 12", "Subfield 1", "Overlap 3". Precondition: number >
/// 0.
std::string title_of(std::string_view layer, int number);

}  // namespace tramline::io
