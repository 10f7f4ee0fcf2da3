#pragma once
// The common parts of the reports of all commands.

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "request/field_input.h"
#include "tramline/geometry/angle.h"
#include "tramline/model/field.h"
#include "tramline/model/machine.h"
#include "tramline/model/objective.h"

namespace tramline::app {

/// JSON as printed: `indent` spaces a level, -1 for a single line; no number is "-0", and bytes that are not
/// UTF-8 become U+FFFD.
std::string json_text(const nlohmann::ordered_json& json, int indent);
/// json_text() without a line break.
std::string json_line(const nlohmann::ordered_json& json);

/// The version of what --json prints (docs/json.md says what raises it).
inline constexpr int kJsonVersion = 1;
/// The object with the key `format_version` before all others.
nlohmann::ordered_json versioned(const nlohmann::ordered_json& result);

/// Null where it is not a finite number.
nlohmann::ordered_json number_json(double value);

nlohmann::ordered_json repairs_json(const std::vector<Repair>& repairs);
nlohmann::ordered_json skipped_json(const std::vector<Skipped>& skipped);
/// The keys that identify a field: field_id, key, file, layer, feature and part (docs/json.md), and then the
/// keys of `result`.
nlohmann::ordered_json with_field_names(const Field& field, const nlohmann::ordered_json& result);
/// A feature that was refused, in a run with --all: its names and `error`.
nlohmann::ordered_json refusal_json(const std::string& file, const std::string& layer,
                                    const Refusal& refusal);

/// "skipped      what (where): why", a row each.
std::string skipped_rows(const std::vector<Skipped>& skipped);

/// "note         what", a row each.
std::string note_rows(const std::vector<std::string>& warnings);

/// In double quotes, as a CSV has texts with commas.
std::string csv_text(const std::string& text);

/// "95.98°, 12.30°": each once, and "…" for those beyond `most`.
std::string directions_text(const std::vector<Direction>& directions, std::size_t most);

/// "0.02·overlap + 0.1·uncovered + 1·turns + 5·stops + 5·further subfields"
std::string prices_text(const Objective& prices);
/// The object `turning` of docs/json.md: all values, under the keys of the machine file.
nlohmann::ordered_json turning_json(const Turning& turning);
/// The operation, and those numbers that are not left to what is usual for it.
nlohmann::ordered_json given_rates_json(const Rates& rates);
/// The object `weights` of docs/json.md.
nlohmann::ordered_json weights_json(const Objective& prices);

}  // namespace tramline::app
