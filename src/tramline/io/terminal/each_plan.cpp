#include "tramline/io/terminal/each_plan.h"

#include <fmt/format.h>

#include <utility>

#include "tramline/geometry/error.h"
#include "tramline/io/coverage/read_coverage.h"
#include "tramline/io/plan/fields_in.h"
#include "tramline/io/plan/read_plan.h"

namespace tramline::io {
namespace {

void require_one_choice(const std::vector<std::filesystem::path>& files, const std::string& field) {
  if (files.empty()) throw bad_input("there is no plan to export; name a plan file");
  if (!field.empty() && files.size() > 1)
    throw bad_input("--id chooses a field of one plan file; name that file alone");
}

}  // namespace

void for_each_plan(const std::vector<std::filesystem::path>& files, const std::string& field,
                   const std::function<void(const Plan& plan, const std::string& file)>& use) {
  require_one_choice(files, field);
  for (const std::filesystem::path& file : files) {
    if (is_coverage_file(file))
      throw bad_input(
          fmt::format("{}: the coverage of a drive has no lines; export its gaps to .gpx, .geojson, .kml or "
                      ".zip, or for a terminal",
                      file.string()));
    const std::vector<FieldNames> fields = fields_in(file);
    if (fields.empty() || !field.empty()) {
      use(read_plan(file, field), file.string());
      continue;
    }
    for (const FieldNames& one : fields) use(read_plan(file, one.key), file.string());
  }
}

void for_each_field(const std::vector<std::filesystem::path>& files, const std::string& field,
                    LineChoice choice, double tolerance_m,
                    const std::function<void(TerminalField field)>& use) {
  require_one_choice(files, field);
  for (const std::filesystem::path& path : files) {
    if (!is_coverage_file(path)) {
      for_each_plan({path}, field, [&](const Plan& plan, const std::string& file) {
        use(terminal_field(plan, choice, tolerance_m, file));
      });
      continue;
    }
    for (TerminalField& part : terminal_fields(read_coverage(path), tolerance_m, path.string()))
      use(std::move(part));
  }
}

}  // namespace tramline::io
