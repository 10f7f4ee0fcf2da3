#pragma once
// Features as one would write them down, in plain metres.

#include <string>
#include <vector>

#include "tramline/admission/admit.h"

namespace tramline::testing_features {

/// "0 0, 10 0, 10 10, 0 10, 0 0": closed when the last point repeats the first.
RawRing ring(const std::string& text);
RawPolygon polygon(const std::vector<std::string>& rings);
RawFeature feature(const std::vector<std::vector<std::string>>& polygons);

/// Admits a feature of layer "parcels" in plain metres.
Admission admit_plain(const RawFeature& feature, RingWinding winding = RingWinding::kFree);
/// One polygon, one field.
Field admit_one(const std::vector<std::string>& rings);

/// Outer ring less real obstacles, m².
double workable_m2(const Field& field);
/// Σ area_change_m2.
double changes_m2(const Field& field);
/// The shoelace area as drawn: |outer| − Σ |holes|, m².
double drawn_m2(const RawFeature& feature);

/// What every admitted field promises; reported as failures.
void expect_admissible(const Field& field);

/// The sentence of the refusal; fails when there is none.
std::string refusal(const RawFeature& feature, const AdmissionContext& context);
std::string refusal_plain(const std::vector<std::string>& rings);

}  // namespace tramline::testing_features
