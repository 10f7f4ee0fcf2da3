#include "tramline/io/plan/front_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "tramline/geometry/error.h"
#include "tramline/model/plain_zero.h"

namespace tramline::io {
namespace {

using nlohmann::json;

}  // namespace

std::string degrees_text(const std::vector<Direction>& directions) {
  json list = json::array();
  for (const Direction direction : directions) list.push_back(plain_zero(direction.degrees()));
  return list.dump();
}

std::string radians_text(const std::vector<Direction>& directions) {
  json list = json::array();
  for (const Direction direction : directions) list.push_back(plain_zero(direction.angle().radians()));
  return list.dump();
}

std::vector<Direction> directions_from_text(const std::string& radians, const std::string& place) {
  std::vector<Direction> out;
  try {
    for (const double value : json::parse(radians).get<std::vector<double>>()) {
      if (!std::isfinite(value)) throw json::other_error::create(0, "not finite", nullptr);
      out.push_back(Direction::clockwise_from_north(Angle::radians(value)));
    }
  } catch (const json::exception&) {
    throw bad_input(fmt::format("{} is not a JSON list of numbers; write the plan again", place));
  }
  return out;
}

std::string marks_text(const Front& front, std::size_t point) {
  return fmt::format("{}", fmt::join(marks_of(front, point), ", "));
}

void apply_marks(const std::string& text, std::size_t point, const std::string& place, FrontMarks& marks) {
  for (std::size_t from = 0; from < text.size();) {
    const std::size_t comma = std::min(text.find(", ", from), text.size());
    const std::string word = text.substr(from, comma - from);
    std::size_t* const mark = mark_named(marks, word);
    if (mark == nullptr)
      throw bad_input(fmt::format("{} has '{}', which is not a mark; write the plan again", place, word));
    *mark = point;
    from = comma + 2;
  }
}

}  // namespace tramline::io
