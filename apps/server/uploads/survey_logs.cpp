#include "server/uploads/survey.h"
#include "tramline/geometry/error.h"
#include "tramline/io/log/read_log.h"

namespace tramline::server {

using nlohmann::ordered_json;

ordered_json survey_logs_of(const Upload& upload) {
  ordered_json logs = ordered_json::array();
  for (const io::LogEntry& entry : io::list_logs(upload.path.string())) {
    io::LogOptions options;
    options.log = entry.name;
    const WorkLog log = io::read_log(upload.path.string(), options);
    ordered_json from, to;
    for (const Fix& fix : log.fixes)
      if (!std::isnan(fix.time_s)) {
        if (from.is_null()) from = fix.time_s;
        to = fix.time_s;
      }
    logs.push_back({{"name", entry.name},
                    {"task", entry.task_name},
                    {"partfield", entry.field_id},
                    {"fixes", log.fixes.size()},
                    {"from_s", from},
                    {"to_s", to},
                    {"width_m", nullptr}});
  }
  return {{"logs", std::move(logs)}};
}

}  // namespace tramline::server
