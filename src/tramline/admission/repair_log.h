#pragma once
// The log of one admission: the name of the feature, and its repairs with their positions.

#include <string>
#include <vector>

#include "tramline/geodesy/crs.h"
#include "tramline/geodesy/field_projection.h"
#include "tramline/geometry/error.h"
#include "tramline/model/report.h"

namespace tramline {

/// Collects repairs of one part of a feature. Positions are given in local metres and recorded in the input's
/// own coordinates. Keeps a reference to the projection.
class RepairLog {
 public:
  /// `subject` starts every refusal: "fields.geojson, feature 'bg/9'". `prefix_m` is the zone prefix that was
  /// taken off the eastings.
  RepairLog(std::string subject, const FieldProjection& projection, double prefix_m = 0)
      : subject_(std::move(subject)), projection_(&projection), prefix_m_(prefix_m) {}

  void repair(std::string what, std::string where, Point local, double area_change_m2);
  void repair_at_input(std::string what, std::string where, Point input, double area_change_m2);
  void warn(std::string sentence) { warnings_.push_back(std::move(sentence)); }

  /// The local point in the input's coordinates, prefix included.
  Point input_of(Point local) const;
  /// "(11.234567, 48.123456)": degrees with 7 decimals, metres with 2.
  std::string shown(Point local) const;
  /// The refusal "<subject>: <sentence>".
  Error refusal(const std::string& sentence) const { return bad_input(subject_ + ": " + sentence); }

  const FieldProjection& projection() const { return *projection_; }
  const std::vector<Repair>& repairs() const { return repairs_; }
  const std::vector<std::string>& warnings() const { return warnings_; }

 private:
  std::string subject_;
  const FieldProjection* projection_;
  double prefix_m_;
  std::vector<Repair> repairs_;
  std::vector<std::string> warnings_;
};

/// A point in a CRS as text: degrees with 7 decimals, metres with 2.
std::string shown_coordinates(Point input, const Crs& crs);

}  // namespace tramline
