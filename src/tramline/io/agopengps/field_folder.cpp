#include "tramline/io/agopengps/field_folder.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

#include "tramline/geometry/error.h"
#include "tramline/io/agopengps/field_rows.h"
#include "tramline/io/fixes/number_text.h"
#include "tramline/io/fixes/places.h"

namespace tramline::io {
namespace {

namespace fs = std::filesystem;

/// Of TrackLines.txt. Others are curves: a line of points.
constexpr int kAbMode = 2, kPivotMode = 64, kHeadlineMode = 0;

/// The position after the word StartFix.
Point start_in(const std::string& path) {
  FieldRows rows(path);
  while (!rows.at_end()) {
    if (lower_case(rows.text()) != "startfix") continue;
    const std::vector<double> lat_lon = rows.numbers(2);
    const Point start{lat_lon[1], lat_lon[0]};
    if (const std::string fault = fault_of_lonlat(start); !fault.empty()) rows.refuse(fault);
    if (std::abs(start.y) > LocalPlane::kMostLatitude_deg)
      rows.refuse(fmt::format("latitude {} is too near to a pole for a plane of metres", start.y));
    return start;
  }
  throw bad_input(fmt::format("'{}' has no line StartFix, which says where the field lies", path));
}

std::map<std::string, std::string> files_of(const fs::path& folder) {
  std::map<std::string, std::string> out;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error))
    if (entry.is_regular_file(error))
      out.emplace(lower_case(entry.path().filename().string()), entry.path().filename().string());
  return out;
}

RawDataset empty_dataset(const FieldFolder& folder, const char* layer, const char* type) {
  RawDataset out;
  out.file = folder.path();
  out.driver = "AgOpenGPS";
  out.layers = {{layer, type, "EPSG:4326", {}, 0}};
  return out;
}

std::vector<Point> on_globe(const std::vector<Point>& metres, const LocalPlane& plane) {
  std::vector<Point> out;
  for (const Point p : metres) out.push_back(plane.to_lonlat(p));
  return out;
}

RawRing ring_of(std::vector<Point> points) {
  RawRing out{std::move(points), false};
  out.closed = out.points.size() > 1 && out.points.front() == out.points.back();
  if (out.closed) out.points.pop_back();
  return out;
}

bool is_yes_or_no(std::string_view line) {
  const std::string word = lower_case(line);
  return word == "true" || word == "false";
}

struct Track {
  std::string name;
  std::vector<Point> points;  ///< metres in the plane
  int mode = kAbMode;
};

Track next_track(FieldRows& rows) {
  Track out;
  out.name = rows.text();
  rows.numbers(1);  // heading
  const Point a = rows.place(), b = rows.place();
  rows.numbers(1);  // nudge: how far the driver has moved it aside
  const std::string mode = rows.text();
  constexpr long long kMostMode = 1000;
  const long long number = digits_in(mode).value_or(-1);
  out.mode = number <= kMostMode ? static_cast<int>(number) : -1;
  if (out.mode < 0) rows.refuse(fmt::format("a mode of the track is expected, not '{}'", mode));
  rows.text();  // shown or hidden
  out.points = rows.places(rows.count());
  if (out.mode == kAbMode) out.points = {a, b};
  return out;
}

/// A name, how far it was moved inwards, a mode, the place of a click, and points.
Track next_headline(FieldRows& rows) {
  Track out;
  out.name = rows.text();
  for (int i = 0; i < 3; ++i) rows.numbers(1);
  out.points = rows.places(rows.count());
  out.mode = kHeadlineMode;
  return out;
}

/// The name, with a number where lines before it have the same: "AB 90", "AB 90 (2)".
std::string id_of(const std::string& name, const RawLayer& layer) {
  const auto taken = [&](const std::string& id) {
    return std::any_of(layer.features.begin(), layer.features.end(),
                       [&](const RawFeature& feature) { return feature.id == id; });
  };
  std::string out = name;
  for (int number = 2; taken(out); ++number) out = fmt::format("{} ({})", name, number);
  return out;
}

void add_guide(Track track, const FieldFolder& folder, RawDataset& dataset) {
  track.points.erase(std::unique(track.points.begin(), track.points.end()), track.points.end());
  if (track.mode == kPivotMode || track.points.size() < 2) {
    dataset.skipped.push_back({fmt::format("track '{}'", track.name), folder.path(),
                               track.mode == kPivotMode
                                   ? "it is a pivot, a circle that tracks cannot be parallel to"
                                   : "it has fewer than two points"});
    return;
  }
  RawLayer& layer = dataset.layers.front();
  RawFeature feature;
  feature.fid = std::ssize(layer.features) + 1;
  feature.id = id_of(track.name, layer);
  feature.geometry_type = "Line String";
  feature.attributes["name"] = track.name;
  if (track.mode != kHeadlineMode) feature.attributes["role"] = "track";
  feature.lines.push_back(on_globe(track.points, folder.plane()));
  layer.features.push_back(std::move(feature));
}

/// Reads tracks until the file ends; the first line is a heading.
template <class Next>
void add_guides(const std::string& file, const FieldFolder& folder, RawDataset& dataset, Next next) {
  FieldRows rows(file);
  if (rows.ahead().starts_with('$')) rows.text();
  while (!rows.at_end()) add_guide(next(rows), folder, dataset);
}

}  // namespace

std::optional<FieldFolder> FieldFolder::open(const std::string& path) {
  std::error_code error;
  if (!fs::is_directory(path, error)) return std::nullopt;
  std::map<std::string, std::string> names = files_of(path);
  const auto field = names.find("field.txt");
  if (field == names.end()) return std::nullopt;
  const LocalPlane plane(start_in((fs::path(path) / field->second).string()));
  return FieldFolder(path, std::move(names), plane);
}

std::optional<std::string> FieldFolder::file(const std::string& name) const {
  const auto at = names_.find(lower_case(name));
  if (at == names_.end()) return std::nullopt;
  return (fs::path(path_) / at->second).string();
}

std::string FieldFolder::field_name() const {
  const fs::path whole = fs::absolute(path_).lexically_normal();
  return (whole.has_filename() ? whole : whole.parent_path()).filename().string();
}

RawDataset field_in(const FieldFolder& folder) {
  const auto file = folder.file("Boundary.txt");
  if (!file) throw bad_input(fmt::format("'{}' has no Boundary.txt, so it has no field", folder.path()));
  RawDataset out = empty_dataset(folder, "fields", "Polygon");
  RawFeature feature;
  feature.fid = 1;
  feature.id = folder.field_name();
  feature.geometry_type = "Polygon";
  feature.polygons.emplace_back();
  FieldRows rows(*file);
  if (rows.ahead().starts_with('$')) rows.text();
  for (int number = 1; !rows.at_end(); ++number) {
    // Older files have two such lines.
    bool driven_through = false;
    while (is_yes_or_no(rows.ahead())) driven_through = lower_case(rows.text()) == "true" || driven_through;
    RawRing ring = ring_of(on_globe(rows.places(rows.count()), folder.plane()));
    if (number > 1 && driven_through)
      out.skipped.push_back({fmt::format("inner boundary {}", number - 1), *file,
                             "it is to be driven through, so its land belongs to the field"});
    else if (ring.points.size() < 3)
      out.skipped.push_back({fmt::format("boundary {}", number), *file, "it has fewer than three points"});
    else
      feature.polygons.front().rings.push_back(std::move(ring));
    if (number == 1 && feature.polygons.front().rings.empty()) break;
  }
  if (feature.polygons.front().rings.empty())
    throw bad_input(fmt::format("'{}' holds no boundary; drive or draw one in AgOpenGPS first", *file));
  out.layers.front().features.push_back(std::move(feature));
  return out;
}

RawDataset guides_in(const FieldFolder& folder) {
  RawDataset out = empty_dataset(folder, "guides", "Line String");
  if (const auto tracks = folder.file("TrackLines.txt")) add_guides(*tracks, folder, out, next_track);
  if (const auto headlines = folder.file("Headlines.txt")) add_guides(*headlines, folder, out, next_headline);
  return out;
}

}  // namespace tramline::io
