#pragma once
// The report of `tramline info`, as text and as JSON.

#include <nlohmann/json.hpp>
#include <string>

#include "request/field_input.h"

namespace tramline::app {

/// File, driver, layer and CRS, one row each, ending in a line break.
std::string source_rows(const std::string& file, const FieldInput& input);
/// One field in full.
std::string field_rows(const Field& field);
/// One line for each field and refusal, for choosing among them.
std::string candidate_rows(const FieldInput& input);

/// One field with everything about its source; skipped features concern all fields and are not included.
nlohmann::ordered_json field_json(const std::string& file, const FieldInput& input, const Field& field);
/// The list of candidates.
nlohmann::ordered_json candidates_json(const std::string& file, const FieldInput& input);

}  // namespace tramline::app
