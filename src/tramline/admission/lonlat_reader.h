#pragma once
// Points of files other than the field's, brought to where the fields are.

#include <string>

#include "tramline/geodesy/crs.h"

namespace tramline {

/// What follows the last slash.
std::string file_name(const std::string& path);

/// Brings the points of one feature to longitude and latitude, one after another; plain metres stay as they
/// are. Throws bad_input naming the subject and the vertex (from 1) for coordinates that are not finite, not
/// on the globe, or outside the CRS. Refers to the CRS.
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
