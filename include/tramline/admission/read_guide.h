#pragma once
// The line that tracks are to follow, from a file or from what was typed.

#include <string>
#include <vector>

#include "tramline/geodesy/crs.h"
#include "tramline/model/field.h"
#include "tramline/model/raw_feature.h"

namespace tramline {

/// A reference line before it is brought to a field. Coordinates: WGS 84 longitude and latitude, or plain
/// metres like the fields'.
struct GuideLine {
  std::string origin;  ///< "guide.geojson feature 3", "--ab"
  std::vector<Point> points;
  bool plain = false;
};

/// The one line of a dataset; a layer without CRS takes that of the fields, a definition as Crs takes it.
/// Where the fields are in plain metres the line is too, whatever its layer says. Throws bad_input where
/// there is no line, or more than one (naming them), and for coordinates that are not finite or not on the
/// globe.
GuideLine read_guide(const RawDataset& dataset, const std::string& fields_crs);

/// Two points in the CRS of the fields; where they cannot be that and may be longitude and latitude, those.
/// Throws bad_input as read_guide().
GuideLine guide_of_points(Point a, Point b, const std::string& origin, const std::string& crs_definition);

/// In the field's local metres, without points twice. Throws bad_input naming the guide for a line without
/// length, shorter than `least_m`, or nowhere in the field.
std::vector<Point> placed_guide(const GuideLine& guide, const Field& field, double least_m);

}  // namespace tramline
