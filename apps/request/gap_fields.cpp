#include "request/gap_fields.h"

#include <fmt/format.h>

#include <utility>

#include "tramline/geometry/error.h"

namespace tramline::app {
namespace {

Field field_of(const Coverage& coverage, std::size_t part, const std::string& file) {
  const Polygon& ground = coverage.field[part];
  Field field;
  field.id = coverage.field_id.empty() ? "field" : coverage.field_id;
  if (part > 0) field.id += fmt::format("#{}", part + 1);
  field.outer = oriented(ground).outer;
  for (std::size_t i = 0; i < ground.holes.size(); ++i)
    field.obstacles.push_back({oriented({ground.holes[i], {}}), ObstacleKind::kObstacle,
                               fmt::format("hole {} of the field in {}", i + 1, file)});
  field.frame = coverage.frame;
  field.source.file = file;
  field.source.layer = "field";
  field.source.part = static_cast<int>(part);
  return field;
}

}  // namespace

std::vector<GapField> gap_fields(const Coverage& coverage, const std::string& file) {
  if (coverage.field.empty())
    throw bad_input(file +
                    " was evaluated without a field, so that nothing counts as missed: give 'tramline "
                    "evaluate' the field with --field");
  if (coverage.gaps.empty())
    throw bad_input(file + ": nothing of the field was missed, there is nothing to repair");
  std::vector<GapField> out;
  for (std::size_t i = 0; i < coverage.field.size(); ++i) {
    GapField part{field_of(coverage, i, file), {}, {}, coverage.lines};
    for (const Gap& gap : coverage.gaps)
      if (contains(coverage.field[i], gap.centre)) part.gaps.push_back(gap);
    const Box box = bounds(coverage.field[i]);
    for (const Polygon& missed : coverage.missed)
      if (intersects(bounds(missed), box) &&
          (coverage.field.size() == 1 || contains(part.field.outer, missed.outer.front())))
        part.missed.push_back(missed);
    out.push_back(std::move(part));
  }
  return out;
}

}  // namespace tramline::app
