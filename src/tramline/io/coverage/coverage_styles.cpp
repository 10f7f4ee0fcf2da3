#include "tramline/io/coverage/coverage_styles.h"

#include <fmt/format.h>

#include "tramline/io/coverage/coverage_layers.h"
#include "tramline/io/geopackage/qml.h"
#include "tramline/model/palette.h"

namespace tramline::io {
namespace {

using qml::mm;
using qml::Shape;

constexpr double kSliver_mm = mm(1), kPath_mm = mm(0.9);

std::string fill_style(qml::SymbolLayer layer) {
  return qml::document({Shape::kPolygon, {std::move(layer)}});
}

/// Hatched, so that what was covered once shows below it.
std::string multiplicity_style() {
  constexpr Colour kNothing = rgb(kBackgroundHex, 0);
  return qml::document(
      Shape::kPolygon,
      {{"\"times\" = 1", "worked once", {Shape::kPolygon, {qml::simple_fill(kNothing, kNothing, 0)}}},
       {"\"times\" = 2", "worked twice", {Shape::kPolygon, {qml::hatch(kTwiceHatch, mm(6), mm(1), 45)}}},
       {"\"times\" = 3",
        "worked three times or more",
        {Shape::kPolygon,
         {qml::hatch(kTwiceHatch, mm(4), mm(1), 45), qml::hatch(kTwiceHatch, mm(4), mm(1), 135)}}}});
}

/// The largest are numbered, as in pictures.
std::string gaps_style() {
  const qml::Labels numbers{fmt::format("\"number\" <= {}", kGapsNumbered), "number", kInk, kBackgroundColour,
                            10};
  return qml::document(Shape::kPolygon,
                       {{"", "", {Shape::kPolygon, {qml::simple_edge(kUncoveredColour, mm(1.6))}}}}, numbers);
}

std::string not_recorded_style() {
  return qml::document({Shape::kPolygon,
                        {qml::simple_fill(kNotRecordedColour, kNotRecordedColour, kSliver_mm),
                         qml::hatch(kNotRecordedHatch, mm(7), mm(1.2), 45)}});
}

std::string track_style() {
  return qml::document(Shape::kLine,
                       {{"\"run\" IS NOT NULL",
                         "driven and worked",
                         {Shape::kLine, {qml::simple_line(kWorkedPathColour, kPath_mm)}}},
                        {"\"run\" IS NULL",
                         "driven without working",
                         {Shape::kLine, {qml::simple_line(kIdlePathColour, kPath_mm, "dash")}}}});
}

}  // namespace

std::vector<LayerStyle> coverage_styles() {
  namespace layers = coverage_layers;
  return {
      {layers::kField, "the field without its obstacles", fill_style(qml::simple_edge(kFieldEdge, mm(2.2)))},
      {layers::kCovered, "land worked once or more",
       fill_style(qml::simple_fill(kCoveredColour, kCoveredEdge, mm(0.8)))},
      {layers::kRepeated, "land worked again",
       fill_style(qml::simple_fill(kOverlapColour, kOverlapColour, 0))},
      {layers::kMissed, "land left out",
       fill_style(qml::simple_fill(kUncoveredColour, kUncoveredColour, kSliver_mm))},
      {layers::kNotRecorded, "land that may have been worked while the log has no fixes",
       not_recorded_style()},
      {layers::kMultiplicity, "how often land was worked", multiplicity_style()},
      {layers::kGaps, "the gaps, the largest numbered", gaps_style()},
      {layers::kTrack, "the way of the machine", track_style()}};
}

}  // namespace tramline::io
