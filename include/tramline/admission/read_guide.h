#pragma once
// The line that tracks are to follow, and the gates of a route, from a file or from coordinates given by the
// user.

#include <string>
#include <vector>

#include "tramline/geodesy/crs.h"
#include "tramline/model/field.h"
#include "tramline/model/raw_feature.h"

namespace tramline {

/// What a line means to who drew it. kBorder: the border of two swaths. kTrack: the middle of one, as with
/// the lines of guidance terminals.
enum class GuideRole { kBorder, kTrack };

/// A reference line before it is converted to a field's frame. Coordinates: WGS 84 longitude and latitude, or
/// plain metres like the fields'.
struct GuideLine {
  std::string origin;  ///< "guide.geojson feature 3", "--ab"
  std::vector<Point> points;
  bool plain = false;
  GuideRole role = GuideRole::kBorder;
};

/// The only line of a dataset. A layer without a CRS is read in `fields_crs`, a definition as accepted by
/// Crs. Where the fields are in plain metres the line is too, whatever its layer says. Throws bad_input where
/// there is no line, or more than one (naming them), and for coordinates that are not finite or not on the
/// globe. A feature whose attribute "role" is "track" is the middle of a track.
GuideLine read_guide(const RawDataset& dataset, const std::string& fields_crs);

/// A line of two points in the CRS of the fields or, where they cannot be in it, in longitude and latitude if
/// possible. Throws bad_input as read_guide().
GuideLine guide_of_points(Point a, Point b, const std::string& origin, const std::string& crs_definition);

/// The line in the field's local metres, without repeated points. Throws bad_input naming the guide for a
/// line without length, shorter than `least_m`, or nowhere in the field.
std::vector<Point> placed_guide(const GuideLine& guide, const Field& field, double least_m);

/// Places at which routes start or end, before they are converted to a field's frame. Coordinates as
/// GuideLine.
struct GatePoints {
  std::string origin;
  std::vector<Point> points;
  bool plain = false;
};

/// The points of a dataset, and the first points of its lines. CRS and errors as read_guide().
GatePoints read_gates(const RawDataset& dataset, const std::string& fields_crs);

/// One point; CRS as guide_of_points().
GatePoints gate_of_point(Point gate, const std::string& origin, const std::string& crs_definition);

/// The gate nearest to the field, in its local metres. Throws bad_input where the nearest is farther from the
/// field than kFarthestGate_m.
Point placed_gate(const GatePoints& gates, const Field& field);

inline constexpr double kFarthestGate_m = 500;

}  // namespace tramline
