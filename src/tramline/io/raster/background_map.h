#pragma once
// A picture of the land on the disk, as tiles of a web map.

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "tramline/geometry/polygon/region.h"

namespace tramline::io {

/// A tile as a file: PNG where it has transparent parts, else JPEG.
struct MapTile {
  std::string bytes;
  const char* type = "image/png";
};

/// An MBTiles file, a GeoTIFF or the raster of a GeoPackage. Safe for several threads, one of which draws at
/// a time.
class BackgroundMap {
 public:
  /// Opens it, and keeps it open. Throws bad_input, naming the file, where it is none of these, says not
  /// where it lies, or has no bands of bytes.
  explicit BackgroundMap(const std::filesystem::path& file);
  BackgroundMap(const BackgroundMap&) = delete;
  BackgroundMap& operator=(const BackgroundMap&) = delete;
  ~BackgroundMap();

  /// West, south, east, north of what it shows, degrees.
  const Box& lonlat_deg() const { return lonlat_deg_; }
  /// Levels between which tiles show what the file has: above the last a tile has no more to it, and below
  /// the first it would be put together from very much of the file.
  int first_zoom() const { return first_zoom_; }
  int last_zoom() const { return last_zoom_; }
  const std::string& name() const { return name_; }

  /// 256 × 256 pixels, Web Mercator, x from the west and y from the north. Outside the picture it is
  /// transparent. Precondition: 0 ≤ zoom ≤ 24, 0 ≤ x, y < 2^zoom. Throws failure where GDAL reports one.
  MapTile tile(int zoom, int x, int y);

 private:
  struct Source;
  std::unique_ptr<Source> source_;
  Box lonlat_deg_;
  int first_zoom_ = 0;
  int last_zoom_ = 0;
  std::string name_;
};

}  // namespace tramline::io
