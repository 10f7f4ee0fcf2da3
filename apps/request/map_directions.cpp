#include "request/map_directions.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "tramline/geometry/error.h"

namespace tramline::app {
namespace {

std::optional<double> number_in(const std::string& word) {
  char* end = nullptr;
  const double value = std::strtod(word.c_str(), &end);
  if (word.empty() || *end != '\0' || !std::isfinite(value)) return std::nullopt;
  return value;
}

DirectionWords::Item item_of(const std::string& word) {
  using Word = DirectionWords::Word;
  if (word == "edges") return {Word::kEdges, {}};
  if (word == "curved") return {Word::kCurved, {}};
  const std::optional<double> degrees = number_in(word);
  if (!degrees || *degrees < 0 || *degrees >= 180)
    throw bad_input(fmt::format(
        "--directions takes 'edges', 'curved' and degrees clockwise from north, from 0 to less than "
        "180, separated by commas, and '{}' is none of these",
        word));
  return {Word::kAngle, Direction::clockwise_from_north(Angle::degrees(*degrees))};
}

/// Two points through the middle of the field.
std::vector<Point> line_at(Direction direction, const Field& field) {
  const Point middle = bounds(field.outer).centre();
  return {middle, middle + 100.0 * direction.unit()};
}

}  // namespace

MapDirections edge_directions(const Field& field, Angle merge) {
  std::vector<MapDirection> edges;
  for (std::size_t i = 0; i < field.outer.size(); ++i) {
    const Point a = field.outer[i], b = field.outer[i + 1 < field.outer.size() ? i + 1 : 0];
    if (a == b) continue;
    // The ring has the field on its left, Zhou's lines have it on their right.
    edges.push_back({MapDirection::Kind::kEdge, Direction::along(b, a), distance(a, b), {b, a}});
  }
  std::stable_sort(edges.begin(), edges.end(),
                   [](const MapDirection& a, const MapDirection& b) { return a.edge_m > b.edge_m; });
  const Angle alike = std::max(merge, kEdgesAlike);
  MapDirections out;
  for (MapDirection& edge : edges) {
    const auto like = [&](const MapDirection& other) {
      return angle_between(edge.direction, other.direction) <= alike;
    };
    if (std::none_of(out.all.begin(), out.all.end(), like)) out.all.push_back(std::move(edge));
  }
  if (out.all.size() > kMostEdgeDirections) {
    out.edges_left_out = out.all.size() - kMostEdgeDirections;
    out.all.resize(kMostEdgeDirections);
  }
  return out;
}

std::vector<std::string> words_of(const std::string& text) {
  std::vector<std::string> out;
  std::size_t from = 0;
  while (from <= text.size()) {
    const std::size_t comma = std::min(text.find(',', from), text.size());
    std::string word = text.substr(from, comma - from);
    word.erase(0, std::min(word.find_first_not_of(' '), word.size()));
    word.erase(word.find_last_not_of(' ') + 1);
    out.push_back(std::move(word));
    from = comma + 1;
  }
  return out;
}

DirectionWords direction_words(const std::string& text) {
  DirectionWords out;
  for (const std::string& word : words_of(text)) {
    DirectionWords::Item item = item_of(word);
    const auto same = [&item](const DirectionWords::Item& other) {
      if (item.word != other.word) return false;
      return item.word != DirectionWords::Word::kAngle || item.direction == other.direction;
    };
    if (std::any_of(out.items.begin(), out.items.end(), same))
      throw bad_input(fmt::format("--directions names '{}' twice", word));
    out.items.push_back(item);
  }
  return out;
}

MapDirections map_directions(const DirectionWords& words, const Field& field, Angle merge) {
  MapDirections out;
  for (const DirectionWords::Item& item : words.items) {
    switch (item.word) {
      case DirectionWords::Word::kEdges: {
        MapDirections edges = edge_directions(field, merge);
        out.edges_left_out = edges.edges_left_out;
        std::move(edges.all.begin(), edges.all.end(), std::back_inserter(out.all));
        break;
      }
      case DirectionWords::Word::kCurved:
        out.all.push_back({MapDirection::Kind::kCurved, {}, 0, {}});
        break;
      case DirectionWords::Word::kAngle:
        out.all.push_back({MapDirection::Kind::kAngle, item.direction, 0, line_at(item.direction, field)});
        break;
    }
  }
  return out;
}

std::vector<double> map_widths(const std::string& text) {
  std::vector<double> out;
  for (const std::string& word : words_of(text)) {
    const std::optional<double> width_m = number_in(word);
    if (!width_m || !(*width_m > 0))
      throw bad_input(
          fmt::format("--widths takes working widths in metres separated by commas, and '{}' in '{}' is none",
                      word, text));
    if (std::find(out.begin(), out.end(), *width_m) != out.end())
      throw bad_input(fmt::format("--widths names {} m twice", *width_m));
    out.push_back(*width_m);
  }
  return out;
}

PlanSettings settings_in_direction(const PlanSettings& settings, const MapDirection& direction) {
  PlanSettings out = settings;
  switch (direction.kind) {
    case MapDirection::Kind::kGiven:
      return out;
    case MapDirection::Kind::kCurved:
      out.shape = TrackShape::kCurved;
      out.ab_anchor = AbAnchor::kDefault;
      return out;
    case MapDirection::Kind::kAngle:
      if (settings.ab_anchor == AbAnchor::kLine)
        throw bad_input(
            "--directions has degrees, which have no line to lie on: leave --ab-anchor line out, or give "
            "--directions edges");
      break;
    case MapDirection::Kind::kEdge:
      break;
  }
  out.guide = direction.line;
  if (settings.ab_anchor == AbAnchor::kDefault) out.ab_anchor = AbAnchor::kEnvelope;
  return out;
}

}  // namespace tramline::app
