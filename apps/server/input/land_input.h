#pragma once
// Land and lines that were drawn for a plan: subfields, cuts, land to leave out, land that is done.

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "tramline/geometry/angle.h"
#include "tramline/model/plan.h"
#include "tramline/model/raw_feature.h"

namespace tramline::server {

enum class DrawnKind { kSubfield, kCut, kSkip, kDone };

struct DrawnLand {
  DrawnKind kind = DrawnKind::kSubfield;
  RawFeature shape;                    ///< longitude and latitude, as on the map
  std::optional<Direction> direction;  ///< of a subfield's tracks
  std::vector<Point> guide;            ///< what a subfield's tracks follow; empty: nothing
};

/// [{kind: subfield, cut, skip or done, geometry, direction_deg?, guide?}]; `direction_deg` and `guide` are
/// for subfields, and a cut is a line. Throws bad_input that names `place`.
std::vector<DrawnLand> land_in(const nlohmann::ordered_json& json, const std::string& place);

/// Whether land is taken off as done: then tracks alone can be planned.
bool has_done(const std::vector<DrawnLand>& drawn);

/// What was drawn, in the field's local metres. Throws bad_input for a shape that does not reach the field.
GivenLand land_on(const std::vector<DrawnLand>& drawn, const Field& field);

}  // namespace tramline::server
