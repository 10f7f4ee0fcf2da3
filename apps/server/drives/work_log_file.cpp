#include "server/drives/work_log_file.h"

#include <utility>

#include "server/uploads/uploads.h"
#include "tramline/geometry/error.h"
#include "tramline/io/log/read_log.h"

namespace tramline::server {

WorkLog read_work_log(const std::filesystem::path& path, const DriveSource& source) {
  Upload log;
  log.name = source.log_name;
  log.path = path;
  try {
    WorkLog out = io::read_log(path.string(), source.options.log);
    out.name = log.in_its_name(out.name);
    return out;
  } catch (const Error& error) {
    throw Error(error.kind(), log.in_its_name(error.what()));
  }
}

Coverage evaluated_log(WorkLog read, app::WorkGround ground, const coverage::EvaluateSettings& settings,
                       const coverage::FixProgress& progress) {
  WorkLog placed = app::placed_on(std::move(read), ground);
  Coverage out = coverage::evaluate(std::move(placed), ground.ground, settings, progress);
  out.field_id = ground.field_id;
  out.field = std::move(ground.ground);
  out.frame = ground.frame;
  return out;
}

}  // namespace tramline::server
