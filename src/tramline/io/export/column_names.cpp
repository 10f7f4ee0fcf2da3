#include "tramline/io/export/column_names.h"

#include <fmt/format.h>

#include <array>
#include <cassert>
#include <utility>

#include "tramline/io/plan/plan_layers.h"

namespace tramline::io {
namespace {

using Words = std::pair<std::string_view, std::string_view>;

constexpr std::array<Words, 12> kShortNames{{{"direction_deg", "dir_deg"},
                                             {"direction_rad", "dir_rad"},
                                             {"heading_deg", "heading"},
                                             {"smallest_radius_m", "min_radius"},
                                             {"stop_at_start", "stop_start"},
                                             {"stop_at_end", "stop_end"},
                                             {"after_crossing", "after_x"},
                                             {"around_field", "round_fld"},
                                             {"detour_count", "detours"},
                                             {"lateral_error_m", "lat_err_m"},
                                             {"why_not_left", "not_left"},
                                             {"why_not_right", "not_right"}}};

constexpr std::array<Words, 10> kTitles{{{plan_layers::kTracks, "Track"},
                                         {plan_layers::kHeadlandPasses, "Headland pass"},
                                         {plan_layers::kHeadlandUnworked, "Unworked headland"},
                                         {plan_layers::kRouteLegs, "Leg"},
                                         {plan_layers::kSubfields, "Subfield"},
                                         {plan_layers::kSwaths, "Swath"},
                                         {plan_layers::kObstacles, "Obstacle"},
                                         {plan_layers::kEncounters, "Encounter"},
                                         {plan_layers::kGivenUp, "Given up"},
                                         {plan_layers::kDropped, "Dropped piece"}}};

template <std::size_t n>
std::string_view found(const std::array<Words, n>& words, std::string_view key) {
  for (const auto& [from, to] : words)
    if (from == key) return to;
  return {};
}

}  // namespace

std::string shapefile_name(std::string_view column) {
  const std::string_view name = found(kShortNames, column);
  return std::string(name.empty() ? column.substr(0, 10) : name);
}

bool stays_in_plan_file(std::string_view layer, std::string_view column) {
  return column == "path" || column == "detours" ||
         (layer == plan_layers::kRouteLegs && column == "stretches");
}

std::string exported_layer(std::string_view in_plan_file) {
  return std::string(in_plan_file == plan_layers::kRouteLegs ? kRoute : in_plan_file);
}

std::string layer_in_plan_file(std::string_view exported) {
  return std::string(exported == kRoute ? plan_layers::kRouteLegs : exported);
}

std::string title_of(std::string_view layer, int number) {
  assert(number > 0);
  const std::string_view title = found(kTitles, layer);
  if (!title.empty()) return fmt::format("{} {}", title, number);
  std::string name(layer);
  if (!name.empty() && name[0] >= 'a' && name[0] <= 'z') name[0] = static_cast<char>(name[0] - 'a' + 'A');
  return fmt::format("{} {}", name, number);
}

}  // namespace tramline::io
