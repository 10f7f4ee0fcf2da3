#pragma once
// Columns of a plan file as exported. docs/export.md has the table.

#include <string>
#include <string_view>

namespace tramline::io {

/// The name a column has in a Shapefile, whose names have ten characters at most: "stop_at_start" becomes
/// "stop_start". Names that are short enough stay; one not in the list is cut.
std::string shapefile_name(std::string_view column);

/// Whether a column has no meaning outside the plan file: the exact path in the field's own plane, and the
/// detours that are given by its segments.
bool stays_in_plan_file(std::string_view column);

/// The column with the number of detours of a track, exported in place of the detours.
inline constexpr const char* kDetourCount = "detour_count";
/// What the column `kind` says of headland passes in the layer of the tracks.
inline constexpr const char* kHeadlandKind = "headland";

/// The title that KML shows beside a feature: "Track 12", "Subfield 1", "Overlap 3". Precondition: number >
/// 0.
std::string title_of(std::string_view layer, int number);

}  // namespace tramline::io
