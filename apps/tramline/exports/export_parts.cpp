#include "exports/export_parts.h"

#include <fmt/format.h>

#include <iterator>

#include "output/output_target.h"
#include "output/result_output.h"

namespace tramline::app {

io::LineChoice line_choice(const ExportOptions& options) {
  return options.lines == "all" ? io::LineChoice::kAll : io::LineChoice::kSubfields;
}

std::vector<std::filesystem::path> plan_paths(const ExportOptions& options) {
  return {options.plans.begin(), options.plans.end()};
}

void require_zip_or_folder(const ExportOptions& options) {
  const std::string extension = std::filesystem::path(options.output).extension().string();
  if (extension == ".zip" || extension == ".ZIP")
    require_writable(options.output, "--output", {".zip"}, options.plans);
  else
    require_folder(options.output, "--output");
}

void print_report(const ExportOptions& options, const std::string& table,
                  const nlohmann::ordered_json& json) {
  if (options.json)
    print_json(json);
  else if (!options.quiet)
    print_result(table);
}

std::string count_row(const char* what, std::size_t count) {
  return fmt::format("  {:<18}{:>8}\n", what, count);
}

std::string renamed_rows(const std::vector<io::ChangedName>& changed) {
  std::string out;
  for (const io::ChangedName& name : changed)
    fmt::format_to(std::back_inserter(out), "renamed: '{}' is shown as '{}'\n", name.name, name.shown);
  return out;
}

nlohmann::ordered_json renamed_json(const std::vector<io::ChangedName>& changed) {
  nlohmann::ordered_json out = nlohmann::ordered_json::array();
  for (const io::ChangedName& name : changed) out.push_back({{"name", name.name}, {"shown", name.shown}});
  return out;
}

}  // namespace tramline::app
