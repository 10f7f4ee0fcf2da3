#pragma once
// Plans in memory to one file of many.

#include <filesystem>
#include <string>
#include <vector>

#include "tramline/model/plan.h"

namespace tramline::io {

struct KeyedPlan {
  std::string key;  ///< of its field; no two are alike
  const Plan* plan = nullptr;
};

/// Writes what write_plans() writes for the files of these plans, but without remarks. The file is made in
/// memory and written whole or not at all. Throws as write_plans(). Precondition: plans is not empty. O(n) in
/// vertices.
void write_plan_list(const std::vector<KeyedPlan>& plans, const std::filesystem::path& path);

}  // namespace tramline::io
