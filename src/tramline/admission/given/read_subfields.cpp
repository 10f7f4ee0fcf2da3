#include "tramline/admission/given/read_subfields.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "tramline/geometry/error.h"

namespace tramline {
namespace {

std::string trimmed(const std::string& text) {
  const std::size_t from = text.find_first_not_of(" \t");
  return from == std::string::npos ? "" : text.substr(from, text.find_last_not_of(" \t") - from + 1);
}

std::string value_of(const RawFeature& feature, const char* column) {
  const auto found = feature.attributes.find(column);
  return found == feature.attributes.end() ? "" : trimmed(found->second);
}

std::optional<Direction> direction_in(const std::string& text, const std::string& origin) {
  constexpr double kMost_deg = 360;
  if (text.empty()) return std::nullopt;
  char* end = nullptr;
  const double degrees = std::strtod(text.c_str(), &end);
  if (*end != '\0' || !(std::abs(degrees) <= kMost_deg))
    throw bad_input(
        fmt::format("{}: {} is '{}'; give degrees clockwise from north, 0 for north and south and 90 for "
                    "east and west, or leave it empty",
                    origin, kDirectionColumn, text));
  return Direction::clockwise_from_north(Angle::degrees(degrees));
}

bool is_yes(std::string text, const std::string& origin) {
  std::string word = text;
  for (char& c : word) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  for (const char* no : {"", "0", "no", "n", "false", "f"})
    if (word == no) return false;
  for (const char* yes : {"1", "yes", "y", "true", "t", "x"})
    if (word == yes) return true;
  throw bad_input(fmt::format("{}: {} is '{}'; give yes or no", origin, kSkipColumn, text));
}

std::vector<const RawFeature*> features_of(const RawDataset& dataset) {
  std::vector<const RawFeature*> out;
  for (const RawLayer& layer : dataset.layers)
    for (const RawFeature& feature : layer.features) out.push_back(&feature);
  return out;
}

void require_guides(const std::vector<LooseSubfield>& all) {
  for (const LooseSubfield& subfield : all) {
    if (subfield.guide.empty()) continue;
    std::string names;
    std::size_t found = 0;
    for (const LooseSubfield& other : all) {
      if (other.feature.lines.empty()) continue;
      if (other.name == subfield.guide) found += other.feature.lines.size();
      if (!other.name.empty()) names += (names.empty() ? "" : ", ") + other.name;
    }
    if (found == 1) continue;
    throw bad_input(fmt::format(
        "{}: {} is '{}', and {} of the file is called so in the column {}; its lines are called: {}",
        subfield.feature.origin, kGuideColumn, subfield.guide, found == 0 ? "no line" : "more than one line",
        kNameColumn, names.empty() ? "nothing" : names));
  }
}

}  // namespace

std::vector<LooseSubfield> read_subfields(const RawDataset& dataset, const std::string& fields_crs) {
  std::vector<LooseObstacle> shapes = read_obstacles(dataset, ObstacleKind::kObstacle, fields_crs);
  const std::vector<const RawFeature*> features = features_of(dataset);
  std::vector<LooseSubfield> out;
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    const RawFeature& feature = *features[i];
    const std::string origin = shapes[i].origin;
    if (!shapes[i].points.empty())
      throw bad_input(origin + ": a point divides no land; draw a polygon, or a line to cut along");
    out.push_back({std::move(shapes[i]), value_of(feature, kNameColumn),
                   direction_in(value_of(feature, kDirectionColumn), origin), value_of(feature, kGuideColumn),
                   is_yes(value_of(feature, kSkipColumn), origin)});
    if (out.back().feature.polygons.empty()) {
      out.back().guide.clear();
      out.back().left_out = false;
    }
  }
  require_guides(out);
  return out;
}

}  // namespace tramline
