#include "output/close_ups.h"

#include <fmt/format.h>

#include "tramline/geometry/error.h"
#include "tramline/render/close_up/close_up.h"

namespace tramline::app {

std::vector<std::string> CloseUps::write(const Plan& plan, const std::string& field) const {
  std::vector<std::string> out;
  if (folder_.empty()) return out;
  std::error_code error;
  std::filesystem::create_directories(folder_, error);
  if (error)
    throw failure(fmt::format("folder '{}' for the pictures of obstacles could not be made: {}",
                              folder_.string(), error.message()));
  for (std::size_t i = 0; i < plan.field.obstacles.size(); ++i)
    if (plan.field.obstacles[i].kind == ObstacleKind::kObstacle) {
      const std::filesystem::path file = folder_ / fmt::format("{}-obstacle-{}.png", field, i + 1);
      render::draw_close_up(plan, i, file);
      out.push_back(file.string());
    }
  return out;
}

}  // namespace tramline::app
