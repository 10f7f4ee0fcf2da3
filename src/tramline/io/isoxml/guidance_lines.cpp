#include "tramline/io/isoxml/guidance_lines.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <optional>
#include <pugixml.hpp>
#include <string_view>
#include <utility>
#include <vector>

#include "tramline/io/fixes/number_text.h"
#include "tramline/io/isoxml/partfield_rings.h"

namespace tramline::io {
namespace {

constexpr std::string_view kGuidance = "5", kAPlus = "2", kPivot = "4";

/// One guidance line as it stands in the set.
struct FoundLine {
  std::string id;
  std::string name;
  pugi::xml_node line;     ///< LSG
  pugi::xml_node pattern;  ///< GPN; none in version 3
};

/// The end of a line of kAPlusLength_m along the heading from true north.
Point end_of_a_plus(Point a, double heading_deg) {
  // Radii of curvature of the WGS 84 ellipsoid in and across the meridian.
  constexpr double kSemiMajor_m = 6378137, kEccentricity2 = 6.69437999014e-3;
  const double degree = std::numbers::pi / 180, sine = std::sin(a.y * degree);
  const double w2 = 1 - kEccentricity2 * sine * sine;
  const double across_m = kSemiMajor_m / std::sqrt(w2), along_m = across_m * (1 - kEccentricity2) / w2;
  const double heading = heading_deg * degree;
  return {a.x + kAPlusLength_m * std::sin(heading) / (across_m * std::cos(a.y * degree) * degree),
          a.y + kAPlusLength_m * std::cos(heading) / (along_m * degree)};
}

/// The line's points, at least two of them; nullopt with the reason in `fault`.
std::optional<std::vector<Point>> line_of(const FoundLine& found, std::string& fault) {
  const std::string_view kind = found.pattern.attribute("C").value();
  if (kind == kPivot) {
    fault = "it is a pivot, a circle that tracks cannot be parallel to";
    return std::nullopt;
  }
  auto out = points_of(found.line, "the line", fault);
  if (!out) return std::nullopt;
  const auto heading = number_in(found.pattern.attribute("G").value());
  if (kind == kAPlus && out->size() == 1 && heading) out->push_back(end_of_a_plus(out->front(), *heading));
  if (out->size() >= 2) return out;
  fault = kind == kAPlus ? "an A+ line needs a point and a heading" : "a line needs two points";
  return std::nullopt;
}

std::vector<FoundLine> lines_in(const pugi::xml_node& partfield) {
  std::vector<FoundLine> out;
  for (const pugi::xml_node group : partfield.children("GGP"))
    for (const pugi::xml_node pattern : group.children("GPN"))
      for (const pugi::xml_node line : pattern.children("LSG"))
        if (line.attribute("A").value() == kGuidance)
          out.push_back({pattern.attribute("A").value(), pattern.attribute("B").value(), line, pattern});
  int number = 0;
  for (const pugi::xml_node line : partfield.children("LSG"))
    if (line.attribute("A").value() == kGuidance)
      out.push_back({fmt::format("{} line {}", partfield.attribute("A").value(), ++number),
                     line.attribute("B").value(),
                     line,
                     {}});
  return out;
}

}  // namespace

RawDataset empty_guidance(const std::string& file) {
  RawDataset out;
  out.file = file;
  out.driver = "ISOXML";
  out.layers = {{"guidance", "Line String", "EPSG:4326", {}, 0}};
  return out;
}

void add_guidance(const pugi::xml_node& partfield, const std::string& file, RawDataset& dataset) {
  RawLayer& layer = dataset.layers.front();
  for (const FoundLine& found : lines_in(partfield)) {
    std::string fault;
    auto line = line_of(found, fault);
    if (!line) {
      dataset.skipped.push_back({fmt::format("guidance line {} ({})", found.id, found.name), file, fault});
      continue;
    }
    RawFeature feature;
    feature.fid = std::ssize(layer.features) + 1;
    feature.id = found.id;
    feature.geometry_type = "Line String";
    feature.attributes["name"] = found.name;
    feature.attributes["role"] = "track";
    feature.lines.push_back(*std::move(line));
    layer.features.push_back(std::move(feature));
  }
}

}  // namespace tramline::io
