#pragma once
// Converts points of other files than the field's to the coordinates of the fields.

#include <string>

#include "tramline/geodesy/crs.h"

namespace tramline {

/// The part of the path after the last slash.
std::string file_name(const std::string& path);

/// Converts the points of one feature to longitude and latitude, one after another; plain metres are kept.
/// Throws bad_input naming the subject and the vertex (from 1) for coordinates that are not finite, not on
/// the globe, or outside the CRS. Refers to the CRS.
class LonlatReader {
 public:
  LonlatReader(const Crs& crs, std::string subject) : crs_(crs), subject_(std::move(subject)) {}
  Point operator()(Point input);

 private:
  const Crs& crs_;
  std::string subject_;
  int vertex_ = 0;
};

}  // namespace tramline
