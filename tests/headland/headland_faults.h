#pragma once
// What has to hold for headlands of any field.

#include <string>
#include <vector>

#include "tramline/headland/headland.h"

namespace tramline::testing {

/// A sentence for each promise that does not hold: passes are closed, smooth, drivable and do not cross
/// themselves, their swaths stay in the field and out of obstacles, areas add up. By other means than the
/// product's where there are any.
std::vector<std::string> faults_of(const Field& field, const HeadlandTerms& terms,
                                   const HeadlandAndBody& headland);

/// Of the terms: what no arc may be tighter than.
double tightest_m(const HeadlandTerms& terms);

/// The same number of passes round everything.
HeadlandTerms terms_of(const Field& field, double width_m, double radius_m, int passes);

}  // namespace tramline::testing
