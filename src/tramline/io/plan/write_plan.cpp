#include "tramline/io/plan/write_plan.h"

#include <cpl_conv.h>
#include <cpl_port.h>
#include <cpl_string.h>
#include <cpl_vsi.h>
#include <fmt/format.h>
#include <ogrsf_frmts.h>
#include <unistd.h>

#include <atomic>
#include <cmath>
#include <memory>
#include <span>
#include <variant>

#include "tramline/geometry/error.h"
#include "tramline/io/plan/detour_text.h"
#include "tramline/io/plan/front_text.h"
#include "tramline/io/plan/gdal_errors.h"
#include "tramline/io/plan/local_crs.h"
#include "tramline/io/plan/path_text.h"
#include "tramline/io/plan/plan_layers.h"
#include "tramline/io/plan/plan_metadata.h"
#include "tramline/io/plan/plan_styles.h"
#include "tramline/io/plan/time_stamp.h"
#include "tramline/io/plan/whole_file.h"
#include "tramline/model/plain_zero.h"

namespace tramline::io {
namespace {

namespace layers = plan_layers;

struct Column {
  const char* name;
  OGRFieldType type;
  OGRFieldSubType subtype = OFSTNone;
};
using Cell = std::variant<std::monostate, long long, double, bool, std::string>;  // monostate: NULL

constexpr Column kArea{"area_m2", OFTReal};
constexpr Column integer(const char* name) { return {name, OFTInteger}; }
constexpr Column real(const char* name) { return {name, OFTReal}; }
constexpr Column text(const char* name) { return {name, OFTString}; }
constexpr Column flag(const char* name) { return {name, OFTInteger, OFSTBoolean}; }

/// Local metres to the file's coordinates.
class Shapes {
 public:
  explicit Shapes(Point offset) : offset_(offset) {}

  std::unique_ptr<OGRGeometry> point(Point p) const {
    return std::make_unique<OGRPoint>(plain_zero(p.x + offset_.x), plain_zero(p.y + offset_.y));
  }
  std::unique_ptr<OGRGeometry> line(const std::vector<Point>& points) const {
    auto out = std::make_unique<OGRLineString>();
    for (const Point p : points) append(*out, p);
    return out;
  }
  std::unique_ptr<OGRGeometry> polygon(const Polygon& polygon) const {
    auto out = std::make_unique<OGRPolygon>();
    append(*out, polygon.outer);
    for (const Ring& hole : polygon.holes) append(*out, hole);
    return out;
  }

 private:
  void append(OGRLineString& out, Point p) const {
    out.addPoint(plain_zero(p.x + offset_.x), plain_zero(p.y + offset_.y));
  }
  void append(OGRPolygon& out, const Ring& ring) const {
    auto closed = std::make_unique<OGRLinearRing>();
    for (const Point p : ring) append(*closed, p);
    if (!ring.empty()) append(*closed, ring.front());
    out.addRingDirectly(closed.release());
  }
  Point offset_;
};

/// A number, or NULL.
Cell number_if(bool any, double number) { return any ? Cell(number) : Cell(); }

/// A layer under construction. Failures are left to the GdalErrors of the caller.
class Table {
 public:
  Table(GDALDataset& file, const char* name, OGRwkbGeometryType type, OGRSpatialReference* crs,
        std::initializer_list<Column> columns, const char* key = "fid")
      : layer_(file.CreateLayer(name, crs, type, CPLStringList().SetNameValue("FID", key).List())) {
    if (layer_ == nullptr) return;
    for (const Column& column : columns) {
      OGRFieldDefn definition(column.name, column.type);
      definition.SetSubType(column.subtype);
      layer_->CreateField(&definition);
    }
  }

  void add(std::unique_ptr<OGRGeometry> shape, std::initializer_list<Cell> cells) {
    if (layer_ == nullptr) return;
    OGRFeature feature(layer_->GetLayerDefn());
    int column = 0;
    for (const Cell& cell : cells) set(feature, column++, cell);
    if (shape != nullptr) {
      feature.SetGeometryDirectly(shape.release());
    }
    if (layer_->CreateFeature(&feature) != OGRERR_NONE)
      CPLError(CE_Failure, CPLE_AppDefined, "a feature of layer %s was refused", layer_->GetName());
  }

 private:
  static void set(OGRFeature& feature, int column, const Cell& cell) {
    if (const auto* whole = std::get_if<long long>(&cell)) feature.SetField(column, GIntBig{*whole});
    if (const auto* number = std::get_if<double>(&cell)) feature.SetField(column, plain_zero(*number));
    if (const auto* yes = std::get_if<bool>(&cell)) feature.SetField(column, *yes ? 1 : 0);
    if (const auto* word = std::get_if<std::string>(&cell)) feature.SetField(column, word->c_str());
  }
  OGRLayer* layer_;
};

struct Target {
  GDALDataset& file;
  OGRSpatialReference* crs;
  Point offset;
  Shapes shapes;
};

void write_region(const Target& target, const char* name, const Region& region) {
  Table table(target.file, name, wkbPolygon, target.crs, {kArea});
  for (const Polygon& polygon : region) table.add(target.shapes.polygon(polygon), {area(polygon)});
}

void write_field(const Target& target, const Field& field) {
  Table fields(target.file, layers::kField, wkbPolygon, target.crs, {text("field_id"), kArea});
  fields.add(target.shapes.polygon({field.outer, {}}), {field.id, area(Polygon{field.outer, {}})});

  Table obstacles(target.file, layers::kObstacles, wkbPolygon, target.crs,
                  {text("kind"), text("origin"), kArea});
  for (const Obstacle& obstacle : field.obstacles) {
    const bool passable = obstacle.kind == ObstacleKind::kPassable;
    obstacles.add(target.shapes.polygon(obstacle.shape),
                  {std::string(passable ? layers::kPassable : layers::kObstacle), obstacle.origin,
                   area(obstacle.shape)});
  }
}

/// direction_rad gives the direction back to the bit, which degrees do not.
void write_subfields(const Target& target, const Plan& plan) {
  Table table(target.file, layers::kSubfields, wkbPolygon, target.crs,
              {integer("number"), real("direction_deg"), real("direction_rad"), kArea});
  long long number = 0;
  for (const Subfield& subfield : plan.subfields)
    table.add(
        target.shapes.polygon(subfield.shape),
        {++number, subfield.direction.degrees(), subfield.direction.angle().radians(), area(subfield.shape)});
}

/// What a GIS draws: two points for a straight piece, chords for one with detours or a curve.
std::vector<Point> drawn(const TrackPiece& piece) {
  if (piece.detours.empty() && piece.curve.empty()) return {piece.start, piece.end};
  return chords(centre_line(piece));
}

void write_headland_passes(const Target& target, const Headland& headland) {
  Table table(target.file, layers::kHeadlandPasses, wkbLineString, target.crs,
              {integer("number"), flag("around_field"), text("obstacles"), real("length_m"),
               real("smallest_radius_m"), text("path")});
  for (const HeadlandPass& pass : headland.passes) {
    const double smallest_m = smallest_radius(pass.path);
    table.add(target.shapes.line(chords(pass.path)),
              {pass.number + 0LL, pass.around_field, obstacles_text(pass.obstacles), length(pass.path),
               number_if(std::isfinite(smallest_m), smallest_m), path_text(pass.path, target.offset)});
  }
}

void write_tracks(const Target& target, const Plan& plan) {
  Table table(
      target.file, layers::kTracks, wkbLineString, target.crs,
      {integer("order"), integer("subfield"), integer("track"), text("kind"), real("heading_deg"),
       real("length_m"), real("smallest_radius_m"), text("obstacles"), text("sides"), flag("stop_at_start"),
       flag("stop_at_end"), flag("after_crossing"), text("path"), text("detours")});
  long long order = 0;
  for (const TrackPiece& piece : plan.pieces) {
    const Path path = written_path(piece);
    const double smallest_m = smallest_radius(path);
    table.add(target.shapes.line(drawn(piece)),
              {++order, piece.subfield + 1LL, piece.track + 1LL, std::string(kind_of(piece)),
               Heading::from_to(piece.start, piece.end).degrees(), length(piece),
               number_if(std::isfinite(smallest_m), smallest_m), obstacles_avoided(piece), sides_text(piece),
               piece.stop_at_start, piece.stop_at_end, piece.after_crossing, path_text(path, target.offset),
               detours_text(piece)});
  }
}

void write_swaths(const Target& target, const Plan& plan) {
  Table table(target.file, layers::kSwaths, wkbPolygon, target.crs,
              {integer("order"), real("width_m"), kArea, real("overlap_m2")});
  const double width_m = plan.machine.width_m;
  long long order = 0;
  for (const TrackPiece& piece : plan.pieces)
    table.add(target.shapes.polygon({swath(piece, width_m), {}}),
              {++order, width_m, width_m * length(piece),
               number_if(piece.overlap_m2.has_value(), piece.overlap_m2.value_or(0))});
}

void write_dropped(const Target& target, const Plan& plan) {
  Table table(target.file, layers::kDropped, wkbLineString, target.crs,
              {integer("subfield"), real("length_m")});
  for (const DroppedPiece& piece : plan.dropped)
    table.add(target.shapes.line({piece.start, piece.end}),
              {piece.subfield + 1LL, distance(piece.start, piece.end)});
}

void write_encounters(const Target& target, const Plan& plan) {
  Table table(target.file, layers::kEncounters, wkbPoint, target.crs,
              {integer("number"), integer("subfield"), integer("track"), text("obstacles"), text("chosen"),
               real("cost_left"), real("cost_right"), text("why_not_left"), text("why_not_right")});
  long long number = 0;
  for (const Encounter& encounter : plan.encounters)
    table.add(target.shapes.point(encounter.at),
              {++number, encounter.subfield + 1LL, encounter.track + 1LL, obstacles_text(encounter.obstacles),
               std::string(name(encounter.chosen)), number_if(encounter.left.possible, encounter.left.cost),
               number_if(encounter.right.possible, encounter.right.cost), encounter.left.why_not,
               encounter.right.why_not});
}

void write_front(GDALDataset& file, const Front& front) {
  if (front.points.empty()) return;
  Table table(
      file, layers::kFront, wkbNone, nullptr,
      {integer("number"), real("overlap_m2"), real("uncovered_m2"), integer("turns"), integer("stops"),
       integer("crossings"), integer("tracks"), real("track_length_m"), real("worked_m2"),
       integer("subfields"), text("direction_deg"), text("direction_rad"), real("cost"), text("marks"),
       real("laid_for_overlap"), real("laid_for_uncovered"), real("laid_for_turn"), real("laid_for_stop")});
  for (std::size_t i = 0; i < front.points.size(); ++i) {
    const FrontPoint& point = front.points[i];
    const Tally& tally = point.tally;
    const Objective& prices = point.laid_for;
    table.add(nullptr,
              {static_cast<long long>(i + 1), tally.overlap_m2, tally.uncovered_m2, tally.turns + 0LL,
               tally.stops + 0LL, tally.crossings + 0LL, tally.pieces + 0LL, tally.track_length_m,
               tally.worked_m2, static_cast<long long>(point.directions.size()),
               degrees_text(point.directions), radians_text(point.directions), point.cost,
               marks_text(front, i), prices.overlap, prices.uncovered, prices.turn, prices.stop});
  }
}

void write_metadata(GDALDataset& file, const Plan& plan) {
  Table table(file, layers::kMetadata, wkbNone, nullptr, {text("key"), text("value")});
  for (const auto& [key, value] : metadata_of(plan)) table.add(nullptr, {key, value});
}

/// The table in which QGIS looks for styles, with the columns it makes itself. It takes a default only where
/// the schema is an empty text, not NULL.
void write_styles(GDALDataset& file, const Plan& plan) {
  Table table(file, layers::kStyles, wkbNone, nullptr,
              {text("f_table_catalog"),
               text("f_table_schema"),
               text("f_table_name"),
               text("f_geometry_column"),
               text("styleName"),
               text("styleQML"),
               text("styleSLD"),
               flag("useAsDefault"),
               text("description"),
               text("owner"),
               text("ui"),
               {"update_time", OFTDateTime}},
              "id");
  const std::string nothing, now = time_stamp();
  for (const LayerStyle& style : styles_of(plan))
    table.add(nullptr,
              {nothing, nothing, std::string(style.layer), std::string("geom"), std::string("tramline"),
               style.qml, nothing, true, style.about, std::string("tramline"), Cell(), now});
}

void write_layers(GDALDataset& file, const Plan& plan) {
  OGRSpatialReference crs = crs_of(plan.field.frame);
  const Point offset = offset_of(plan.field.frame);
  const Target target{file, &crs, offset, Shapes(offset)};
  file.StartTransaction();
  write_field(target, plan.field);
  write_region(target, layers::kBody, plan.body);
  write_region(target, layers::kHeadland, plan.headland.ground);
  write_region(target, layers::kGivenUp, plan.given_up);
  write_subfields(target, plan);
  write_headland_passes(target, plan.headland);
  write_tracks(target, plan);
  write_swaths(target, plan);
  write_region(target, layers::kOverlap, plan.overlap);
  write_region(target, layers::kUncovered, plan.uncovered);
  write_region(target, layers::kHeadlandUnworked, plan.headland.unworked);
  write_dropped(target, plan);
  write_encounters(target, plan);
  write_front(file, plan.front);
  write_metadata(file, plan);
  write_styles(file, plan);
  file.CommitTransaction();
}

/// A file in GDAL's memory, gone at the end of the scope. Building the GeoPackage there keeps
/// half-written databases and journals off the disk, whatever happens.
class MemoryFile {
 public:
  MemoryFile() {
    static std::atomic<unsigned> count{0};
    name_ = fmt::format("/vsimem/tramline_plan_{}_{}.gpkg", getpid(), count++);
  }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;
  ~MemoryFile() { VSIUnlink(name_.c_str()); }
  const char* name() const { return name_.c_str(); }
  std::span<const std::byte> bytes() const {
    vsi_l_offset size = 0;
    const GByte* data = VSIGetMemFileBuffer(name_.c_str(), &size, FALSE);
    return std::as_bytes(std::span(data, static_cast<std::size_t>(size)));
  }

 private:
  std::string name_;
};

GDALDriver& driver() {
  RegisterOGRGeoPackage();
  GDALDriver* found = GetGDALDriverManager()->GetDriverByName("GPKG");
  if (found == nullptr) throw failure("this GDAL has no GeoPackage driver; install one built with SQLite");
  return *found;
}

}  // namespace

void write_plan(const Plan& plan, const std::filesystem::path& path) {
  if (!EQUAL(path.extension().c_str(), ".gpkg"))
    throw bad_input(
        fmt::format("'{}' cannot hold a plan: plans are GeoPackages; end the name in .gpkg", path.string()));
  const CPLConfigOptionSetter date("OGR_CURRENT_DATE", time_stamp().c_str(), false);
  GdalErrors errors;
  MemoryFile memory;
  {
    const GDALDatasetUniquePtr file(driver().Create(memory.name(), 0, 0, 0, GDT_Unknown, nullptr));
    if (file != nullptr) write_layers(*file, plan);
  }
  const std::span<const std::byte> bytes = memory.bytes();
  if (errors.any() || bytes.empty())
    throw failure(fmt::format("cannot write {}: GDAL reports: {}", path.string(), errors.first()));
  write_whole(path, bytes);
}

}  // namespace tramline::io
