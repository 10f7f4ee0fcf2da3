#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "tramline/geometry/error.h"
#include "tramline/io/export/export_plan.h"
#include "tramline/io/export/file_set.h"
#include "tramline/io/export/thinned_line.h"
#include "tramline/io/terminal/each_plan.h"
#include "tramline/io/terminal/task_set.h"
#include "tramline/io/terminal/terminal_field.h"
#include "tramline/io/vector/lower_case.h"

namespace tramline::io {
namespace {

namespace fs = std::filesystem;

// Terminals look for these names, in capitals.
constexpr const char* kFolder = "TASKDATA";
constexpr const char* kFile = "TASKDATA.XML";

void count(const TerminalField& field, TaskSetReport& report) {
  ++report.fields;
  report.obstacles += field.obstacles.size();
  report.headlands += field.headland.size();
  report.gaps += field.gaps.size();
  const LineCounts counts = counts_of(field.lines);
  report.lines += counts.lines;
  report.curves += counts.curves;
}

bool is_zip(const fs::path& target) { return lower_case(target.extension().string()) == ".zip"; }

/// A new folder, and the name of the file in it. A folder that is there already gets a folder TASKDATA.
struct SetPlace {
  fs::path folder;
  std::string file;
};

SetPlace place_in(const fs::path& target) {
  const fs::path whole = target.lexically_normal();
  const fs::path name = whole.has_filename() ? whole : whole.parent_path();
  if (name.filename() == kFolder) return {name, kFile};
  std::error_code ignored;
  if (fs::exists(name, ignored)) return {name / kFolder, kFile};
  return {name, fmt::format("{}/{}", kFolder, kFile)};
}

/// Returns what was written.
fs::path write_set(std::string xml, const fs::path& target) {
  if (is_zip(target)) {
    write_zip({{fmt::format("{}/{}", kFolder, kFile), std::move(xml)}}, target);
    return target;
  }
  const SetPlace place = place_in(target);
  write_folder({{place.file, std::move(xml)}}, place.folder);
  return place.folder / place.file;
}

void require_target(const fs::path& target) {
  if (is_zip(target)) return;
  if (lower_case(target.extension().string()) == ".xml")
    throw bad_input(fmt::format("'{}': terminals look for {}/{}; name a folder, or a zip file",
                                target.string(), kFolder, kFile));
  require_free(place_in(target).folder);
}

}  // namespace

TaskSetReport export_task_set(const TaskSetRequest& request) {
  require_tolerance(request.tolerance_m);
  require_target(request.target);
  TaskSetReport report;
  std::vector<TerminalField> fields;
  for_each_field(request.plans, request.field, request.lines, request.tolerance_m, [&](TerminalField field) {
    count(field, report);
    fields.push_back(std::move(field));
  });
  TaskSet set = task_set(fields, {request.version, request.obstacles, request.customer, request.farm});
  report.bytes = set.xml.size();
  report.changed = std::move(set.changed);
  report.file = write_set(std::move(set.xml), request.target);
  return report;
}

}  // namespace tramline::io
