#pragma once
// What the runs of 'tramline export' have in common.

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "exports/export_options.h"

namespace tramline::app {

/// Throws kBadInput, before any work, where neither a zip file nor a folder of that name can be written.
void require_zip_or_folder(const ExportOptions& options);

/// Prints the table, or with --json the object, unless --quiet.
void print_report(const ExportOptions& options, const std::string& table, const nlohmann::ordered_json& json);

/// "  AB lines               12"
std::string count_row(const char* what, std::size_t count);

/// "renamed: 'Große Breite' is shown as 'Grosse Breite'", a row each.
std::string renamed_rows(const std::vector<io::ChangedName>& changed);
nlohmann::ordered_json renamed_json(const std::vector<io::ChangedName>& changed);

}  // namespace tramline::app
