#include "server/input/land_input.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "server/input/drawn_shape.h"
#include "server/input/geometry_input.h"
#include "server/input/json_input.h"
#include "tramline/admission/given/place_subfields.h"
#include "tramline/geometry/error.h"
#include "tramline/geometry/polygon/boolean.h"

namespace tramline::server {
namespace {

using nlohmann::ordered_json;

DrawnKind drawn_kind_in(const JsonInput& input) {
  const std::string word = input.text("kind");
  if (word == "subfield") return DrawnKind::kSubfield;
  if (word == "cut") return DrawnKind::kCut;
  if (word == "skip") return DrawnKind::kSkip;
  if (word == "done") return DrawnKind::kDone;
  throw bad_input(
      fmt::format("{} is '{}', but has to be subfield, cut, skip or done", input.place_of("kind"), word));
}

DrawnLand one_in(const ordered_json& json, const std::string& place) {
  constexpr double kMost_deg = 360;
  const JsonInput input(json, place, {"kind", "geometry", "direction_deg", "guide"});
  DrawnLand out;
  out.kind = drawn_kind_in(input);
  out.shape = raw_feature_in(input.value("geometry"), input.place_of("geometry"));
  const bool fits = out.kind == DrawnKind::kCut ? !out.shape.lines.empty() : !out.shape.polygons.empty();
  if (!fits)
    throw bad_input(fmt::format("{} has to be a {}", input.place_of("geometry"),
                                out.kind == DrawnKind::kCut ? "line" : "polygon"));
  const std::optional<double> degrees = input.number_if("direction_deg");
  if ((degrees || input.has("guide")) && out.kind != DrawnKind::kSubfield)
    throw bad_input(fmt::format("{}: direction_deg and guide are for subfields", place));
  if (degrees && input.has("guide"))
    throw bad_input(fmt::format("{} has both direction_deg and guide; give one of them", place));
  if (degrees && !(std::abs(*degrees) <= kMost_deg))
    throw bad_input(fmt::format("{} has to lie between -360 and 360", input.place_of("direction_deg")));
  if (degrees) out.direction = Direction::clockwise_from_north(Angle::degrees(*degrees));
  if (input.has("guide")) out.guide = positions_of(input.value("guide"), input.place_of("guide"));
  return out;
}

std::string origin_of(std::size_t index) { return fmt::format("drawn {}", index + 1); }

/// All but what is done, with the lines that subfields follow after it.
std::vector<LooseSubfield> subfields_of(const std::vector<DrawnLand>& drawn, const Field& field) {
  std::vector<LooseSubfield> out, guides;
  for (std::size_t i = 0; i < drawn.size(); ++i) {
    const DrawnLand& one = drawn[i];
    if (one.kind == DrawnKind::kDone) continue;
    const std::string guide = one.guide.empty() ? "" : "line of " + origin_of(i);
    out.push_back({drawn_shape(one.shape, origin_of(i), field), "", one.direction, guide,
                   one.kind == DrawnKind::kSkip});
    if (guide.empty()) continue;
    RawFeature line;
    line.lines.push_back(one.guide);
    guides.push_back({drawn_shape(line, guide, field), guide, std::nullopt, "", false});
  }
  std::move(guides.begin(), guides.end(), std::back_inserter(out));
  return out;
}

void require_met(const std::vector<char>& used, std::size_t index, const std::string& origin) {
  if (used[index] == 0)
    throw bad_input(fmt::format("the land {} does not reach the field; draw it over the field", origin));
}

}  // namespace

std::vector<DrawnLand> land_in(const ordered_json& json, const std::string& place) {
  constexpr std::size_t kMost = 200;
  if (!json.is_array()) throw bad_input(place + " has to be a list");
  if (json.size() > kMost) throw bad_input(fmt::format("{} may have {} shapes at most", place, kMost));
  std::vector<DrawnLand> out;
  for (const ordered_json& one : json)
    out.push_back(one_in(one, fmt::format("{} {}", place, out.size() + 1)));
  return out;
}

bool has_done(const std::vector<DrawnLand>& drawn) {
  return std::any_of(drawn.begin(), drawn.end(),
                     [](const DrawnLand& one) { return one.kind == DrawnKind::kDone; });
}

GivenLand land_on(const std::vector<DrawnLand>& drawn, const Field& field) {
  GivenLand out;
  const std::vector<LooseSubfield> subfields = subfields_of(drawn, field);
  std::vector<char> used(subfields.size(), 0);
  place_subfields(field, subfields, used, out);
  for (std::size_t i = 0; i < subfields.size(); ++i)
    if (subfields[i].name.empty()) require_met(used, i, subfields[i].feature.origin);
  std::vector<LooseObstacle> done;
  for (std::size_t i = 0; i < drawn.size(); ++i)
    if (drawn[i].kind == DrawnKind::kDone) done.push_back(drawn_shape(drawn[i].shape, origin_of(i), field));
  if (done.empty()) return out;
  std::vector<char> met(done.size(), 0);
  out.done = placed_land(field, done, met);
  for (std::size_t i = 0; i < done.size(); ++i) require_met(met, i, done[i].origin);
  return out;
}

}  // namespace tramline::server
