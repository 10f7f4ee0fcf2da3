#pragma once
// The report of `dose`.

#include <nlohmann/json.hpp>
#include <string>

#include "tramline/model/dose_map.h"

namespace tramline::app {

/// One object (docs/json.md).
nlohmann::ordered_json dose_json(const DoseMap& map, double seconds);
std::string dose_table(const DoseMap& map, double seconds);

}  // namespace tramline::app
