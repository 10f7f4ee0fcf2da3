#pragma once
// The route of a plan in its file: a layer of legs, and keys of the table `metadata`.

#include <filesystem>
#include <optional>

#include "tramline/io/geopackage/metadata.h"
#include "tramline/io/geopackage/rows.h"
#include "tramline/io/geopackage/table.h"
#include "tramline/io/plan/read_plan.h"

namespace tramline::io {

/// Whether a plan has a route, or was asked for one: only then is there the layer.
bool has_route(const Plan& plan);

/// The layer of the legs, in driving order. Failures of GDAL are left to the GdalErrors of the caller.
void write_route_legs(const Target& target, const Plan& plan);

/// The inverse. Throws Error(kBadInput) naming file, layer, feature and column where a word is unknown, the
/// stretches are of another form, or the legs are not numbered from 1 on.
void read_route_legs(Rows& file, PlanFile& out);

/// Settings that are not the default ones and, of a plan with a route, what proves it, what it leads over,
/// and its whole cost with all rates.
void write_route_values(const Plan& plan, Metadata& out);

/// The inverse. Gates are taken from the file's coordinates to those of the plan, whose frame has to be
/// known. Throws Error(kBadInput) naming the key at fault.
void apply_route_values(const Metadata& metadata, const std::filesystem::path& file, Plan& plan);

/// What a file says that the route costs; nullopt where it says nothing. Throws as apply_route_values().
std::optional<StatedCost> stated_cost_in(const Metadata& metadata, const std::filesystem::path& file);

}  // namespace tramline::io
