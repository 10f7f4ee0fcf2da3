#include <algorithm>
#include <mutex>
#include <set>

#include "request/field_input.h"
#include "server/drives/drive_rooms.h"
#include "server/drives/work_drive.h"
#include "server/uploads/feature_name.h"
#include "tramline/geometry/error.h"
#include "tramline/io/log/read_log.h"

namespace tramline::server {
namespace {

/// Of the log, or of all logs where none is named: the one that all their tasks name.
std::string partfield_named(const std::filesystem::path& task_set, const std::string& log) {
  std::set<std::string> named;
  for (const io::LogEntry& entry : io::list_logs(task_set.string()))
    if (log.empty() || entry.name == log) named.insert(entry.field_id);
  return named.size() == 1 ? *named.begin() : "";
}

bool same(const Field& a, const Field& b) {
  const auto same_obstacle = [](const Obstacle& x, const Obstacle& y) { return x.shape == y.shape; };
  return a.frame == b.frame && a.outer == b.outer &&
         std::equal(a.obstacles.begin(), a.obstacles.end(), b.obstacles.begin(), b.obstacles.end(),
                    same_obstacle);
}

}  // namespace

std::string partfield_of(App& app, const std::filesystem::path& task_set, const std::string& log) {
  const std::string id = partfield_named(task_set, log);
  // Ids of ISO 11783-10 are PFD and a number; anything else is not asked for in a filter.
  if (!id.starts_with("PFD") || id.find_first_not_of("PFD-0123456789") != std::string::npos) return "";
  app::FieldOptions options;
  options.file = task_set.string();
  options.where = "id = '" + id + "'";
  app::FieldInput input;
  try {
    input = app::load_fields(options);
  } catch (const Error&) {
    return "";  // the survey of the upload has told why it is refused
  }
  const auto larger = [](const Field& a, const Field& b) { return area_m2(a) < area_m2(b); };
  const auto field = std::max_element(input.fields.begin(), input.fields.end(), larger);
  if (field == input.fields.end()) return "";
  const std::string name = name_in_file(options.file, field->source.layer, field->source.fid);
  const std::lock_guard lock(app.drives->partfields);
  for (const KeptFieldPtr& kept : app.fields.list())
    if (same(kept->field, *field)) return kept->id;
  return app.fields.add(*field, name, input.skipped)->id;
}

}  // namespace tramline::server
