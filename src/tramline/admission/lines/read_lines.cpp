#include "tramline/admission/lines/read_lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <optional>
#include <utility>

#include "tramline/admission/lines/point_placer.h"
#include "tramline/admission/lonlat_reader.h"
#include "tramline/geodesy/crs.h"
#include "tramline/geodesy/field_projection.h"
#include "tramline/geometry/error.h"

namespace tramline {
namespace {

constexpr const char *kOrder = "order", *kSubfield = "subfield", *kAfterCrossing = "after_crossing",
                     *kAfterCrossingShort = "after_x", *kKind = "kind", *kExactPath = "exact_path";

/// What no number begins counts as none.
double number_in(const RawFeature& feature, const char* column, double otherwise) {
  const auto found = feature.attributes.find(column);
  if (found == feature.attributes.end()) return otherwise;
  const char* const begin = found->second.c_str();
  char* end = nullptr;
  const double value = std::strtod(begin, &end);
  return end == begin ? otherwise : value;
}

std::string text_in(const RawFeature& feature, const char* column) {
  const auto found = feature.attributes.find(column);
  return found == feature.attributes.end() ? std::string() : found->second;
}

bool is_pass(const RawLayer& layer, const RawFeature& feature) {
  return layer.name == "headland_passes" || text_in(feature, kKind) == "headland";
}

Error without_lines(const RawDataset& dataset) {
  bool areas = false, points = false;
  for (const RawLayer& layer : dataset.layers)
    for (const RawFeature& feature : layer.features) {
      areas = areas || !feature.polygons.empty();
      points = points || !feature.points.empty();
    }
  const char* instead = areas ? "areas, not lines" : points ? "points, not lines" : "no lines";
  return bad_input(
      fmt::format("'{}' holds {}: give a file with the centre lines of the tracks", dataset.file, instead));
}

/// The lines of one layer.
class LayerLines {
 public:
  LayerLines(const RawDataset& dataset, const RawLayer& layer, const Crs& crs, DrawnLines& out)
      : file_(file_name(dataset.file)), layer_(layer), crs_(crs), out_(out) {}

  void append() {
    for (const RawFeature* feature : in_order()) {
      const std::string name = feature->id.empty() ? std::to_string(feature->fid) : feature->id;
      const std::string origin = fmt::format("{} feature {}", file_, name);
      if (feature->lines.empty())
        out_.skipped.push_back({"feature", origin, fmt::format("it is no line: {}", feature->geometry_type)});
      LonlatReader read(crs_, origin);
      for (const std::vector<Point>& given : feature->lines) {
        DrawnLine line;
        line.origin = origin;
        line.plain = crs_.plain();
        line.after_turn =
            number_in(*feature, kAfterCrossing, 1) == 0 || number_in(*feature, kAfterCrossingShort, 1) == 0;
        line.subfield = static_cast<int>(number_in(*feature, kSubfield, 0));
        line.is_pass = is_pass(layer_, *feature);
        // Of a line that is in parts now, the path is that of none.
        if (feature->lines.size() == 1) line.exact_path = text_in(*feature, kExactPath);
        for (const Point p : given) line.points.push_back(read(p));
        out_.lines.push_back(std::move(line));
      }
    }
  }

 private:
  /// By the column `order` where every track has one; headland passes follow the tracks.
  std::vector<const RawFeature*> in_order() const {
    std::vector<const RawFeature*> out;
    for (const RawFeature& feature : layer_.features) out.push_back(&feature);
    constexpr double kNone = std::numeric_limits<double>::infinity();
    const auto order = [](const RawFeature* feature) { return number_in(*feature, kOrder, kNone); };
    const bool all = std::all_of(out.begin(), out.end(), [&](const RawFeature* feature) {
      return std::isfinite(order(feature)) || is_pass(layer_, *feature);
    });
    if (all)
      std::stable_sort(out.begin(), out.end(),
                       [&](const RawFeature* a, const RawFeature* b) { return order(a) < order(b); });
    return out;
  }

  std::string file_;
  const RawLayer& layer_;
  const Crs& crs_;
  DrawnLines& out_;
};

}  // namespace

std::vector<std::string> columns_of_lines() {
  return {kOrder, kSubfield, kAfterCrossing, kAfterCrossingShort, kKind, kExactPath};
}

DrawnLines read_lines(const RawDataset& dataset, const std::string& fields_crs) {
  const bool plain = Crs(fields_crs).plain();
  DrawnLines out;
  out.skipped = dataset.skipped;
  for (const RawLayer& layer : dataset.layers) {
    const Crs crs = plain ? Crs() : Crs(layer.crs.empty() ? fields_crs : layer.crs);
    LayerLines(dataset, layer, crs, out).append();
  }
  if (out.lines.empty()) throw without_lines(dataset);
  return out;
}

std::vector<Point> placed_line(const DrawnLine& line, const Field& field) {
  const PointPlacer placer(field, {line.plain, line.origin, "line"});
  std::vector<Point> out;
  for (const Point p : line.points) out.push_back(placer.place(p));
  return out;
}

}  // namespace tramline
