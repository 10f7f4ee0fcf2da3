#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tramline/model/plan.h"

namespace tramline::io {

/// A plan file to be included in a file of many plans.
struct KeptPlan {
  std::string key;  ///< key of its field; no two are alike
  std::filesystem::path file;
};

/// Writes plans to one GeoPackage: the layers and tables of write_plan(), each with all rows of all plans, in
/// the order given, and with the columns field_key and field_id before all others. Empty layers exist too.
///
/// Coordinates: the plane of each field is its own, so shapes are put into one transverse Mercator on WGS 84
/// centred on all fields (those in plain metres: into the input's own plane, as in a plan file), from which
/// read_plan_file() restores them to 1e-7 m; texts of paths stay bit-identical. That plane is recorded in
/// metadata, under the key `collection` and an empty field_key.
///
/// The same plan files give the same bytes. The file is written whole or not at all; one plan is in memory at
/// a time. Throws Error(kBadInput) where a file is not a plan, where some are in plain metres and others
/// georeferenced, and where they lie too far apart for one plane; Error(kFailure) where the file cannot be
/// written. Precondition: plans is not empty. O(n) in vertices.
void write_plans(const std::vector<KeptPlan>& plans, const std::filesystem::path& path);

/// A plan in memory to be included in a file of many plans.
struct KeyedPlan {
  std::string key;  ///< key of its field; no two are alike
  const Plan* plan = nullptr;
};

/// The same for plans that are in no file yet. The file is made in memory.
void write_plans(const std::vector<KeyedPlan>& plans, const std::filesystem::path& path);

}  // namespace tramline::io
