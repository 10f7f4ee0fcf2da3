#pragma once
// Points from other files than the field's, or from the command line, in the frame of a field.

#include <optional>
#include <string>

#include "tramline/geodesy/field_projection.h"
#include "tramline/model/field.h"

namespace tramline {

/// Where points come from.
struct PointSource {
  bool plain = false;     ///< plain metres; otherwise longitude and latitude
  std::string origin;     ///< for messages: "ab.gpkg feature 3"
  const char* what = "";  ///< for messages: "line"
};

/// Places points of one source in the frame of a field. Refers to the field.
class PointPlacer {
 public:
  /// Throws bad_input where the points are in plain metres and the field is not, or the other way round.
  PointPlacer(const Field& field, const PointSource& source);

  /// In local metres; nullopt where the point lies too far away for the field's plane.
  std::optional<Point> try_place(Point p) const;
  /// The same; throws bad_input with the point where it lies too far away.
  Point place(Point p) const;

 private:
  const Field& field_;
  std::string origin_;
  std::optional<FrameProjection> projection_;
};

}  // namespace tramline
