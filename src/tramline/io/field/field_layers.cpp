#include "tramline/io/field/field_layers.h"

#include <fmt/format.h>

#include <string>
#include <utility>

#include "tramline/geometry/error.h"

namespace tramline::io {

namespace layers = field_layers;

void write_field_layers(const Target& target, const Field& field) {
  const double area_m2 = area(Polygon{field.outer, {}});
  if (target.names != nullptr) {  // which have the column field_id already
    Table fields(target, layers::kField, wkbPolygon, {kAreaColumn});
    fields.add(target.shapes.polygon({field.outer, {}}), {area_m2});
  } else {
    Table fields(target, layers::kField, wkbPolygon, {text("field_id"), kAreaColumn});
    fields.add(target.shapes.polygon({field.outer, {}}), {field.id, area_m2});
  }

  Table obstacles(target, layers::kObstacles, wkbPolygon, {text("kind"), text("origin"), kAreaColumn});
  for (const Obstacle& obstacle : field.obstacles) {
    const bool passable = obstacle.kind == ObstacleKind::kPassable;
    obstacles.add(target.shapes.polygon(obstacle.shape),
                  {std::string(passable ? layers::kPassable : layers::kObstacle), obstacle.origin,
                   area(obstacle.shape)});
  }
}

void read_field_layers(Rows& file, const std::filesystem::path& path, const FileKind& kind, Field& field,
                       const std::function<void(const Row&, const Polygon&)>& seen) {
  int count = 0;
  file.each(layers::kField, [&](const Row& row) {
    field.outer = row.polygon().outer;
    ++count;
    if (seen) seen(row, {field.outer, {}});
  });
  if (count != 1)
    throw bad_input(fmt::format("{}: layer field holds {} features instead of one; write the {} again",
                                path.string(), count, kind.what));
  file.each(layers::kObstacles, [&](const Row& row) {
    Obstacle obstacle{row.polygon(), ObstacleKind::kObstacle, row.text("origin")};
    const std::string word = row.text("kind");
    if (word != layers::kObstacle && word != layers::kPassable)
      throw bad_input(fmt::format("{}: kind is '{}', expected obstacle or passable", row.place(), word));
    if (word == layers::kPassable) obstacle.kind = ObstacleKind::kPassable;
    if (seen) seen(row, obstacle.shape);
    field.obstacles.push_back(std::move(obstacle));
  });
}

}  // namespace tramline::io
