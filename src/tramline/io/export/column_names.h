#pragma once
// Columns of a plan file as exported. docs/export.md has the table.

#include <string>
#include <string_view>

namespace tramline::io {

/// The name a column has in a Shapefile, whose names have ten characters at most: "stop_at_start" becomes
/// "stop_start". Names that are short enough stay; one not in the list is cut.
std::string shapefile_name(std::string_view column);

/// Columns that mean nothing outside the plan file: the exact path in the field's own plane, and the
/// detours that are given by its segments.
bool stays_in_plan_file(std::string_view column);

/// How many detours a track has: what is exported in place of them.
inline constexpr const char* kDetourCount = "detour_count";
/// "Track 12", "Subfield 1", "Overlap 3": what KML shows beside a feature. Precondition: number > 0.
std::string title_of(std::string_view layer, int number);

}  // namespace tramline::io
