#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "tramline/io/export/export_plan.h"
#include "tramline/io/export/file_set.h"
#include "tramline/io/export/thinned_line.h"
#include "tramline/io/terminal/agopengps_folder.h"
#include "tramline/io/terminal/designators.h"
#include "tramline/io/terminal/each_plan.h"
#include "tramline/io/terminal/terminal_field.h"
#include "tramline/io/vector/lower_case.h"

namespace tramline::io {
namespace {

namespace fs = std::filesystem;

struct Folder {
  std::string name;
  std::vector<NamedFile> files;
};

/// The name that a field's folder has where it is the target itself.
std::string name_of(const fs::path& target) {
  const fs::path whole = target.lexically_normal();
  return (whole.has_filename() ? whole : whole.parent_path()).filename().string();
}

std::vector<NamedFile> in_folders(std::vector<Folder> folders) {
  std::vector<NamedFile> out;
  for (Folder& folder : folders)
    for (NamedFile& file : folder.files)
      out.push_back({folder.name + "/" + file.name, std::move(file.content)});
  return out;
}

}  // namespace

AgOpenGpsReport export_agopengps(const AgOpenGpsRequest& request) {
  require_tolerance(request.tolerance_m);
  const bool zipped = lower_case(request.target.extension().string()) == ".zip";
  if (!zipped) require_free(request.target);
  AgOpenGpsReport report;
  std::vector<TerminalField> fields;
  for_each_field(request.plans, request.field, request.lines, request.tolerance_m,
                 [&](TerminalField field) { fields.push_back(std::move(field)); });
  const bool is_target = !zipped && fields.size() == 1;
  Designators names;
  std::vector<Folder> folders;
  for (const TerminalField& field : fields) {
    const std::string name =
        is_target ? name_of(request.target)
                  : names.unique_folder(field.name, fmt::format("Field {}", folders.size() + 1));
    if (!is_target && name != field.name) report.changed.push_back({field.name, name});
    report.folders.push_back(name);
    const LineCounts counts = counts_of(field.lines);
    report.lines += counts.lines;
    report.curves += counts.curves;
    report.obstacles += field.obstacles.size();
    folders.push_back({name, agopengps_files(field, name)});
  }
  if (is_target)
    write_folder(folders.front().files, request.target);
  else if (zipped)
    write_zip(in_folders(std::move(folders)), request.target);
  else
    write_folder(in_folders(std::move(folders)), request.target);
  return report;
}

}  // namespace tramline::io
