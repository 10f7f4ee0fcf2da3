#include "tramline/io/plan/plan_styles.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "tramline/io/field/field_styles.h"
#include "tramline/io/geopackage/qml.h"
#include "tramline/io/plan/plan_layers.h"
#include "tramline/io/plan/route_rows.h"
#include "tramline/model/palette.h"
#include "tramline/model/plain_zero.h"

namespace tramline::io {
namespace {

using qml::mm;
using qml::Rule;
using qml::Shape;
using qml::Symbol;

constexpr double kTrackLine_mm = mm(1.1), kDetourLine_mm = mm(2.2), kRim_mm = mm(4.4), kArrow_mm = mm(9);
constexpr double kHeadlandLine_mm = mm(1.4), kRouteLine_mm = mm(1.4);
constexpr double kSliver_mm = mm(1.5);

Symbol symbol(Shape shape, std::vector<qml::SymbolLayer> layers) { return {shape, std::move(layers)}; }

std::string fill_style(qml::SymbolLayer layer) {
  return qml::document({Shape::kPolygon, {std::move(layer)}});
}

std::string given_up_style() {
  return qml::document(
      Shape::kPolygon,
      {{"", "",
        symbol(Shape::kPolygon, {qml::simple_fill(kUncoveredColour, kUncoveredColour, kSliver_mm),
                                 qml::hatch(kGivenUpHatch, mm(6), mm(1.6), 135)})}});
}

Rule tinted(std::size_t i, const std::string& label) {
  return {fmt::format("\"number\" = {}", i + 1), label,
          symbol(Shape::kPolygon, {qml::simple_fill(tint(i), kSubfieldEdge, mm(1.4))})};
}

/// A tint for each, and its direction in the legend.
std::string subfields_style(const Plan& plan) {
  std::vector<Rule> rules;
  for (std::size_t i = 0; i < plan.subfields.size(); ++i) {
    const double degrees = plain_zero(plan.subfields[i].direction.degrees());
    const std::string direction =
        std::isfinite(degrees) ? fmt::format("{:.1f}° from north", degrees) : std::string("no direction");
    rules.push_back(tinted(i, fmt::format("{}: {}", i + 1, direction)));
  }
  if (rules.empty())
    rules.push_back({"", "", symbol(Shape::kPolygon, {qml::simple_fill(tint(0), kSubfieldEdge, mm(1.4))})});
  return qml::document(Shape::kPolygon, rules);
}

qml::SymbolLayer stop_at(const char* place) {
  return qml::marker_on_line(place, qml::simple_marker("circle", kInk, kBackgroundColour, mm(8.4)));
}

/// The parts of a track that its column detours names by the segments of its path: from the point with the
/// number of the first segment to the one behind the last.
constexpr const char* kDetourParts =
    "with_variable('points', string_to_array(\"path\", '; '), collect_geometries(array_foreach("
    "from_json(\"detours\"), line_substring($geometry, "
    "line_locate_point($geometry, geom_from_wkt('POINT(' || regexp_substr(array_get(@points, "
    "map_get(@element, 'first')), '^(\\\\S+ \\\\S+)') || ')')), "
    "line_locate_point($geometry, geom_from_wkt('POINT(' || regexp_substr(array_get(@points, "
    "map_get(@element, 'last') + 1), '^(\\\\S+ \\\\S+)') || ')'))))))";

/// How the detours of a track are drawn: those that its columns say, or all of it.
enum class Detours { kFromColumns, kWholeTrack };

std::string tracks_style(Detours drawn) {
  const qml::SymbolLayer track = qml::simple_line(kTrackColour, kTrackLine_mm);
  const qml::SymbolLayer arrow = qml::marker_on_line(
      "centralpoint", qml::simple_marker("filled_arrowhead", kFieldEdge, kFieldEdge, kArrow_mm));
  const Symbol marked = symbol(
      Shape::kLine, {qml::simple_line(kDetourRim, kRim_mm), qml::simple_line(kDetourColour, kDetourLine_mm)});
  const qml::SymbolLayer detours = drawn == Detours::kFromColumns
                                       ? qml::generated(kDetourParts, marked)
                                       : qml::simple_line(kDetourColour, kDetourLine_mm);
  return qml::document(
      Shape::kLine,
      {{"\"kind\" = 'straight'", "track", symbol(Shape::kLine, {track, arrow})},
       {"\"kind\" = 'curved'", "curved track", symbol(Shape::kLine, {track, arrow})},
       {"\"kind\" = 'detour'", "track with detours round obstacles",
        symbol(Shape::kLine, {track, arrow, detours})},
       {"\"stop_at_start\"", "stop at the start", symbol(Shape::kLine, {stop_at("firstvertex")})},
       {"\"stop_at_end\"", "stop: the machine backs out", symbol(Shape::kLine, {stop_at("lastvertex")})}});
}

/// Closed lines: an arrow in the middle of every stretch of some length.
std::string headland_passes_style() {
  qml::SymbolLayer arrows = qml::marker_on_line(
      "interval",
      qml::simple_marker("filled_arrowhead", kHeadlandPassColour, kHeadlandPassColour, kArrow_mm));
  const std::string apart = fmt::format("{:g}", mm(220)), first = fmt::format("{:g}", mm(110));
  arrows.properties.insert(arrows.properties.end(), {{"interval", apart},
                                                     {"interval_unit", "MM"},
                                                     {"offset_along_line", first},
                                                     {"offset_along_line_unit", "MM"}});
  return qml::document(
      Shape::kLine,
      {{"", "",
        symbol(Shape::kLine, {qml::simple_line(kHeadlandPassColour, kHeadlandLine_mm, "dash"), arrows})}});
}

/// As in pictures: gaps of micrometres between two swaths are no faults that anybody wants to see, and may
/// hang on to a real one as a tail.
std::string fault_style(Colour colour) {
  constexpr const char* kWithoutTails = "buffer(buffer($geometry, -0.0005), 0.0005)";
  return fill_style(
      qml::generated(kWithoutTails, symbol(Shape::kPolygon, {qml::simple_fill(colour, colour, kSliver_mm)})));
}

/// Every second one a shade darker.
std::string swaths_style() {
  constexpr Colour kNothing = rgb(kBackgroundHex, 0);
  return qml::document(
      Shape::kPolygon,
      {{"\"order\" % 2 = 1", "swath", symbol(Shape::kPolygon, {qml::simple_fill(kStripe, kNothing, 0)})},
       {"\"order\" % 2 = 0", "swath", symbol(Shape::kPolygon, {qml::simple_fill(kNothing, kNothing, 0)})}});
}

std::string encounters_style() {
  const auto dot = [](Colour colour) {
    return symbol(Shape::kPoint, {qml::simple_marker("circle", colour, kBackgroundColour, mm(5))});
  };
  return qml::document(Shape::kPoint,
                       {{"\"chosen\" = 'cut'", "cut", dot(kFaintInk)},
                        {"\"chosen\" <> 'cut'", "passed on the left or right", dot(kDetourColour)}});
}

/// By kind; legs along tracks and passes lie on those. In reverse dashed, and above all of them those that
/// leave the land.
LayerStyle route_style() {
  const auto rule = [](const std::string& filter, const char* label, Colour colour) {
    const Symbol forward = symbol(Shape::kLine, {qml::simple_line(colour, kRouteLine_mm)});
    const Symbol reverse = symbol(Shape::kLine, {qml::simple_line(colour, kRouteLine_mm, "dash")});
    return std::vector<Rule>{
        {filter + " AND \"gear\" = 'forward'", label, forward},
        {filter + " AND \"gear\" = 'reverse'", fmt::format("{} in reverse", label), reverse}};
  };
  std::vector<Rule> rules;
  for (const auto& [kind, label, colour] :
       {std::tuple{LegKind::kWork, "along a track", kTrackColour},
        std::tuple{LegKind::kHeadland, "along a headland pass", kHeadlandPassColour},
        std::tuple{LegKind::kTurn, "turn", kTurnColour},
        std::tuple{LegKind::kTransit, "way with the work off", kTransitColour},
        std::tuple{LegKind::kBackOut, "backing out or in", kBackOutColour}})
    for (Rule& part : rule(fmt::format("\"kind\" = '{}' AND \"missing_m\" = 0", name(kind)), label, colour))
      rules.push_back(std::move(part));
  for (Rule& part : rule("\"missing_m\" > 0", "leaves the land", kNoRoomColour))
    rules.push_back(std::move(part));
  return {plan_layers::kRouteLegs, "every way of the machine, by its kind",
          qml::document(Shape::kLine, rules)};
}

/// Those that all plans have.
std::vector<LayerStyle> styles_with(std::string subfields, std::string tracks) {
  namespace layers = plan_layers;
  return {
      {layers::kField, "the outer boundary", fill_style(qml::simple_edge(kFieldEdge, mm(2.2)))},
      obstacles_style(),
      {layers::kBody, "what the tracks have to cover", fill_style(qml::simple_edge(kFaintInk, mm(1), "dot"))},
      {layers::kHeadland, "what the headland passes are there to work",
       fill_style(qml::simple_fill(kHeadlandColour, kSubfieldEdge, mm(1.4)))},
      {layers::kGivenUp, "given up on purpose, uncovered", given_up_style()},
      {layers::kSubfields, "a tint for each driving direction", std::move(subfields)},
      {layers::kHeadlandPasses, "passes round the field and its obstacles", headland_passes_style()},
      {layers::kTracks, "tracks with arrows, detours and stops", std::move(tracks)},
      {layers::kSwaths, "the ground each track works", swaths_style()},
      {layers::kOverlap, "land worked again", fault_style(kOverlapColour)},
      {layers::kUncovered, "land left out", fault_style(kUncoveredColour)},
      {layers::kHeadlandUnworked, "headland left out", fault_style(kUncoveredColour)},
      {layers::kDropped, "not worth driving",
       qml::document(Shape::kLine,
                     {{"", "", symbol(Shape::kLine, {qml::simple_line(kDroppedColour, mm(1.8), "dash")})}})},
      {layers::kEncounters, "where tracks meet obstacles", encounters_style()}};
}

}  // namespace

std::vector<LayerStyle> styles_of(const Plan& plan) {
  std::vector<LayerStyle> out = styles_with(subfields_style(plan), tracks_style(Detours::kFromColumns));
  if (has_route(plan)) out.push_back(route_style());
  if (!plan.worked.empty())
    out.push_back({plan_layers::kWorked, "worked before, or left for good",
                   fill_style(qml::simple_fill(kCoveredColour, kCoveredEdge, mm(1)))});
  return out;
}

std::vector<LayerStyle> styles_of_many(std::size_t most_subfields, Routes routes) {
  std::vector<Rule> rules;
  for (std::size_t i = 0; i < std::max<std::size_t>(1, most_subfields); ++i)
    rules.push_back(tinted(i, fmt::format("subfield {} of its field", i + 1)));
  std::vector<LayerStyle> out =
      styles_with(qml::document(Shape::kPolygon, rules), tracks_style(Detours::kWholeTrack));
  if (routes == Routes::kSome) out.push_back(route_style());
  return out;
}

}  // namespace tramline::io
