#pragma once
// Lines that somebody else drew or planned, from a file.

#include <string>
#include <vector>

#include "tramline/geometry/point.h"
#include "tramline/model/field.h"
#include "tramline/model/raw_feature.h"
#include "tramline/model/report.h"

namespace tramline {

/// A line before it is converted to a field's frame. Coordinates: WGS 84 longitude and latitude, or plain
/// metres like the fields'.
struct DrawnLine {
  std::string origin;  ///< "lines.geojson feature 3"
  std::vector<Point> points;
  bool plain = false;
  bool after_turn = false;  ///< an export of ours says that it goes on after no crossing
  int subfield = 0;         ///< where an export of ours says so
  bool is_pass = false;     ///< a headland pass of an export of ours
  std::string exact_path;   ///< the text of that column of such an export; empty: none
};

struct DrawnLines {
  std::vector<DrawnLine> lines;  ///< in the order of the column `order`, else in that of the file
  std::vector<Skipped> skipped;  ///< features without a line
};

/// The columns to read with the features, for read_lines(). Lines of a layer `headland_passes`, and those
/// whose `kind` is `headland`, are headland passes.
std::vector<std::string> columns_of_lines();

/// All lines of a dataset, each part of a feature by itself. A layer without a CRS is read in `fields_crs`, a
/// definition as accepted by Crs. Where the fields are in plain metres the lines are too, whatever their
/// layer says. Throws bad_input where there is no line, saying what the file holds instead, and for
/// coordinates that are not finite or not on the globe.
DrawnLines read_lines(const RawDataset& dataset, const std::string& fields_crs);

/// The points of a line in the field's local metres. Throws bad_input naming the line where it is not in the
/// field's kind of coordinates, or lies too far away for the field's plane.
std::vector<Point> placed_line(const DrawnLine& line, const Field& field);

}  // namespace tramline
