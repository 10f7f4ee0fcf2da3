#include "tramline/io/export/layer_copy.h"

#include <cpl_string.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "tramline/geometry/path/path.h"
#include "tramline/io/export/column_names.h"
#include "tramline/io/export/projected_shapes.h"
#include "tramline/io/export/thinned_shape.h"
#include "tramline/io/export/utf8_prefix.h"
#include "tramline/io/geopackage/field_names.h"
#include "tramline/io/plan/exact_path.h"
#include "tramline/io/plan/plan_layers.h"
#include "tramline/model/palette.h"
#include "tramline/model/route.h"

namespace tramline::io {
namespace {

/// DBF's longest text, bytes.
constexpr std::size_t kLongestText = 254;

CPLStringList layer_options(const LayerWay& way) {
  CPLStringList out;
  switch (way.format) {
    case ExportFormat::kGeoJson:
      out.SetNameValue("RFC7946", "YES");
      out.SetNameValue("COORDINATE_PRECISION", std::to_string(way.decimals).c_str());
      break;
    case ExportFormat::kFlatGeobuf:
      out.SetNameValue("SPATIAL_INDEX", "NO");  // it would sort the tracks out of their driving order
      break;
    case ExportFormat::kKml:
      break;
    case ExportFormat::kShapefiles: {
      std::tm utc{};
      gmtime_r(&way.time, &utc);
      // One byte holds the year.
      const int year = std::clamp(utc.tm_year + 1900, 1900, 2155);
      out.SetNameValue("ENCODING", "UTF-8");
      out.SetNameValue("DBF_DATE_LAST_UPDATE",
                       fmt::format("{:04}-{:02}-{:02}", year, utc.tm_mon + 1, utc.tm_mday).c_str());
      break;
    }
  }
  return out;
}

std::uint32_t hex_of(Colour colour) {
  const auto byte = [](double part) { return static_cast<std::uint32_t>(std::lround(255 * part)); };
  return byte(colour.red) << 16 | byte(colour.green) << 8 | byte(colour.blue);
}

/// As in pictures.
std::uint32_t colour_of_leg(const OGRFeature& leg) {
  if (leg.GetFieldAsDouble("missing_m") > 0) return kNoRoomHex;
  switch (leg_kind_named(leg.GetFieldAsString("kind")).value_or(LegKind::kTransit)) {
    case LegKind::kWork:
      return kTrackHex;
    case LegKind::kHeadland:
      return kHeadlandPassHex;
    case LegKind::kTurn:
      return kTurnHex;
    case LegKind::kBackOut:
      return hex_of(kBackOutColour);
    case LegKind::kTransit:
      break;
  }
  return hex_of(kTransitColour);
}

/// How a line is drawn where the format says such things (KML).
std::string pen_of(std::string_view layer, const OGRFeature& source, bool detour) {
  const bool headland = layer == plan_layers::kHeadlandPasses;
  const std::uint32_t colour = layer == plan_layers::kRouteLegs ? colour_of_leg(source)
                               : headland                       ? kHeadlandPassHex
                               : detour                         ? kDetourHex
                                                                : kTrackHex;
  return fmt::format("PEN(c:#{:06X},w:2px)", colour);
}

OGRLayer* made_layer(OGRLayer& like, GDALDataset& file, const LayerWay& way) {
  OGRSpatialReference reference(way.target.reference());
  CPLStringList options = layer_options(way);
  return file.CreateLayer(exported_layer(like.GetName()).c_str(), &reference, like.GetGeomType(),
                          options.List());
}

/// One layer on its way from the plan file to a layer of the export, which another may share.
class LayerCopy {
 public:
  LayerCopy(OGRLayer& from, OGRLayer& to, const LayerWay& way, std::vector<Skipped>& shortened)
      : from_(from), to_(to), way_(way), shortened_(shortened) {}

  /// All columns have to be there before the first feature.
  void make_columns() {
    if (way_.format == ExportFormat::kKml) title_ = add(OGRFieldDefn("Name", OFTString));
    const OGRFeatureDefn& columns = *from_.GetLayerDefn();
    for (int i = 0; i < columns.GetFieldCount(); ++i)
      if (!stays_in_plan_file(from_.GetName(), columns.GetFieldDefn(i)->GetNameRef()))
        kept_.push_back({i, add_like(i)});
    detours_ = columns.GetFieldIndex("detours");
    if (detours_ >= 0) detour_count_ = add(OGRFieldDefn(shown(kDetourCount).c_str(), OFTInteger));
    path_ = columns.GetFieldIndex("path");
    key_ = columns.GetFieldIndex(kFieldKey);
    if (path_ >= 0 && !way_.frames.empty() && way_.format != ExportFormat::kShapefiles)
      exact_path_ = add(OGRFieldDefn(kExactPath, OFTString));
  }

  /// `kind`: what the column of that name says of all of them; nullptr: what it says in the plan file.
  int copy_features(const char* kind = nullptr) {
    if (kind != nullptr) kind_ = to_.GetLayerDefn()->GetFieldIndex("kind");
    int count = 0;
    from_.ResetReading();
    while (const OGRFeatureUniquePtr feature{from_.GetNextFeature()}) copy(*feature, ++count, kind);
    return count;
  }

 private:
  struct Pair {
    int from;
    int to;
  };

  /// The number of the column: a new one, or that of this name where layers share it.
  int add(const OGRFieldDefn& column) {
    if (const int there = to_.GetLayerDefn()->GetFieldIndex(column.GetNameRef()); there >= 0) return there;
    if (to_.CreateField(const_cast<OGRFieldDefn*>(&column)) != OGRERR_NONE)
      CPLError(CE_Failure, CPLE_AppDefined, "column %s was refused", column.GetNameRef());
    return to_.GetLayerDefn()->GetFieldCount() - 1;
  }

  std::string shown(const char* column) const {
    return way_.format == ExportFormat::kShapefiles ? shapefile_name(column) : column;
  }

  /// The column of this number of the plan file. DBF keeps as many bytes for every text as the longest needs,
  /// and decimals as many as it is told.
  int add_like(int index) {
    const OGRFieldDefn& column = *from_.GetLayerDefn()->GetFieldDefn(index);
    OGRFieldDefn like(shown(column.GetNameRef()).c_str(), column.GetType());
    like.SetSubType(column.GetSubType());
    if (way_.format != ExportFormat::kShapefiles) return add(like);
    if (column.GetType() == OFTString) like.SetWidth(longest_text(index));
    if (column.GetSubType() == OFSTBoolean) like.SetWidth(1);
    if (column.GetType() == OFTReal) {
      const bool radians = std::string_view(column.GetNameRef()).ends_with("_rad");
      like.SetWidth(24);
      like.SetPrecision(radians ? 15 : 6);
    }
    return add(like);
  }

  int longest_text(int index) {
    std::size_t longest = 1;
    from_.ResetReading();
    while (const OGRFeatureUniquePtr feature{from_.GetNextFeature()})
      longest = std::max(longest, std::string_view(feature->GetFieldAsString(index)).size());
    return static_cast<int>(std::min(longest, kLongestText));
  }

  void copy(const OGRFeature& source, int number, const char* kind) {
    OGRFeature out(to_.GetLayerDefn());
    for (const auto [from, to] : kept_) copy_value(source, from, out, to);
    if (kind_ >= 0) out.SetField(kind_, kind);
    if (exact_path_ >= 0) out.SetField(exact_path_, exact_path_of(source).c_str());
    if (detours_ >= 0) out.SetField(detour_count_, count_of(source.GetFieldAsString(detours_)));
    if (title_ >= 0) {
      out.SetField(title_, title_of(from_.GetName(), number).c_str());
      const int detour = detour_count_ >= 0 ? out.GetFieldAsInteger(detour_count_) : 0;
      out.SetStyleString(pen_of(from_.GetName(), source, detour > 0).c_str());
    }
    if (const OGRGeometry* shape = source.GetGeometryRef())
      out.SetGeometryDirectly(exported(*shape).release());
    if (to_.CreateFeature(&out) != OGRERR_NONE)
      CPLError(CE_Failure, CPLE_AppDefined, "a feature of layer %s was refused", from_.GetName());
  }

  /// Half of the tolerance is for vertices that are left out, half for edges that bend on their way into the
  /// target. What the user drew keeps its vertices; the drawn lines of arcs are chords already.
  std::unique_ptr<OGRGeometry> exported(const OGRGeometry& shape) const {
    const double half_m = 0.5 * way_.tolerance_m;
    const double most_aside_m = half_m > 0 ? std::min(half_m, kMostAside_m) : kMostAside_m;
    const double thinning_m = half_m - kChordSagitta;
    const std::string_view layer = from_.GetName();
    if (thinning_m <= 0 || layer == plan_layers::kField || layer == plan_layers::kObstacles)
      return projected(shape, way_.offset, way_.target, most_aside_m);
    return projected(*thinned_shape(shape, thinning_m), way_.offset, way_.target, most_aside_m);
  }

  std::string exact_path_of(const OGRFeature& source) const {
    const auto frame = way_.frames.find(key_ >= 0 ? source.GetFieldAsString(key_) : "");
    if (frame == way_.frames.end()) return {};
    return exact_path_text(frame->second, std::max(way_.tolerance_m, kMostAside_m),
                           source.GetFieldAsString(path_));
  }

  static int count_of(const char* detours) {
    const nlohmann::json list = nlohmann::json::parse(detours, nullptr, false);
    return list.is_array() ? static_cast<int>(list.size()) : 0;
  }

  void copy_value(const OGRFeature& source, int from, OGRFeature& out, int to) const {
    if (!source.IsFieldSetAndNotNull(from)) return out.SetFieldNull(to);
    const OGRFieldDefn& column = *from_.GetLayerDefn()->GetFieldDefn(from);
    const std::string_view text = source.GetFieldAsString(from);
    const bool too_long = way_.format == ExportFormat::kShapefiles && column.GetType() == OFTString &&
                          text.size() > kLongestText;
    if (!too_long) return out.SetField(to, source.GetRawFieldRef(from));
    out.SetField(to, std::string(utf8_prefix(text, kLongestText)).c_str());
    shortened_.push_back(
        {column.GetNameRef(), fmt::format("layer {}, feature {}", from_.GetName(), source.GetFID()),
         fmt::format("the text has {} bytes, and a Shapefile takes {}", text.size(), kLongestText)});
  }

  OGRLayer &from_, &to_;
  const LayerWay& way_;
  std::vector<Skipped>& shortened_;
  std::vector<Pair> kept_;
  int title_ = -1, detours_ = -1, detour_count_ = -1, path_ = -1, key_ = -1, exact_path_ = -1, kind_ = -1;
};

}  // namespace

int copy_layer(OGRLayer& from, GDALDataset& to, const LayerWay& way, std::vector<Skipped>& shortened) {
  OGRLayer* const layer = made_layer(from, to, way);
  if (layer == nullptr) return 0;
  LayerCopy copy(from, *layer, way, shortened);
  copy.make_columns();
  return copy.copy_features();
}

std::pair<int, int> copy_lines(OGRLayer& tracks, OGRLayer& passes, GDALDataset& to, const LayerWay& way,
                               std::vector<Skipped>& shortened) {
  OGRLayer* const layer = made_layer(tracks, to, way);
  if (layer == nullptr) return {};
  LayerCopy first(tracks, *layer, way, shortened), second(passes, *layer, way, shortened);
  first.make_columns();
  second.make_columns();
  const int track_count = first.copy_features();
  return {track_count, second.copy_features(kHeadlandKind)};
}

}  // namespace tramline::io
