#include "close_ups.h"

#include <fmt/format.h>

#include "tramline/geometry/error.h"
#include "tramline/render/close_up.h"

namespace tramline::app {

void CloseUps::write(const Plan& plan) {
  if (folder_.empty()) return;
  std::error_code error;
  std::filesystem::create_directories(folder_, error);
  if (error)
    throw failure(fmt::format("folder '{}' for the pictures of obstacles could not be made: {}",
                              folder_.string(), error.message()));
  const std::string field = names_.next(as_file_name(plan.field.id));
  for (std::size_t i = 0; i < plan.field.obstacles.size(); ++i)
    if (plan.field.obstacles[i].kind == ObstacleKind::kObstacle)
      render::draw_close_up(plan, static_cast<int>(i),
                            folder_ / fmt::format("{}-obstacle-{}.png", field, i + 1));
}

}  // namespace tramline::app
