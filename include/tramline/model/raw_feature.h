#pragma once
// The contents of a vector file before admission: plain values in the file's own coordinates.

#include <optional>
#include <string>
#include <vector>

#include "tramline/geometry/point.h"
#include "tramline/model/report.h"

namespace tramline {

/// One ring as written. Frame: the layer's CRS, traditional GIS order (longitude or easting first).
struct RawRing {
  std::vector<Point> points;  ///< without the repeated last point
  bool closed = true;         ///< whether the file repeated the first point at the end
};

struct RawPolygon {
  std::vector<RawRing> rings;  ///< the outer ring, then the holes
};

struct RawFeature {
  long long fid = -1;
  std::string id;             ///< the feature's id property or GeoJSON id; empty when it has none
  std::string geometry_type;  ///< "Polygon", "Line String" …, "none" without a geometry
  bool had_z = false;
  bool had_m = false;
  bool was_curved = false;  ///< arcs were replaced by chords of at most 1 degree
  std::vector<RawPolygon> polygons;
  std::vector<std::vector<Point>> lines;
  std::vector<Point> points;
  std::vector<std::optional<double>> numbers{};  ///< of the columns asked for; none where it has no number
};

struct RawLayer {
  std::string name;
  std::string geometry_type;  ///< as the layer declares it
  std::string crs;            ///< WKT; empty when the file declares none
  std::vector<RawFeature> features;
  /// Features that match the query; more than features.size() when the query had a limit.
  long long matching = 0;
};

/// Whether the format of a file says which way round rings run.
enum class RingWinding {
  kFree,        ///< either way: formats differ, and writers too
  kPrescribed,  ///< outer rings counter-clockwise, holes clockwise (RFC 7946)
};

struct RawDataset {
  std::string file;    ///< as the user named it
  std::string driver;  ///< "GeoJSON", "GPKG" …
  RingWinding winding = RingWinding::kFree;
  std::vector<RawLayer> layers;  ///< those read
  std::vector<Skipped> skipped;  ///< layers left aside
};

}  // namespace tramline
