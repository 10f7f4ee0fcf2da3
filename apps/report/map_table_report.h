#pragma once
// The report of `map --directions` and `map --widths`.

#include <nlohmann/json.hpp>
#include <string>

#include "request/map_table.h"

namespace tramline::app {

/// The keys of docs/json.md.
nlohmann::ordered_json map_table_json(const MapTable& table, const std::vector<Skipped>& skipped);

/// For people: a row for each map, every number with its unit, and the best of each width.
std::string map_table_text(const MapTable& table, const std::vector<Skipped>& skipped);

/// A header, then a line for each map; commas, and full stops in numbers. Maps that there are not have empty
/// cells.
std::string map_table_csv(const MapTable& table);

/// What stands for a direction in the table: "94.05° edge", "30°", "curved", "as given".
std::string map_direction_text(const MapDirection& direction);

}  // namespace tramline::app
