#pragma once
// Basic facts of a plan that rules use, and the names of its parts in reports.

#include <cstddef>
#include <string>
#include <vector>

#include "tramline/model/plan.h"

namespace tramline::check {

/// The tightest circle that the machine can drive and its swath can follow, m.
double least_radius_m(const Machine& machine);

/// Whether these are indices of obstacles of the field.
bool exist(const Plan& plan, const std::vector<std::size_t>& obstacles);
/// The number of headland passes that an obstacle has.
int passes_round(const Plan& plan, std::size_t obstacle);
/// Whether the tracks of a subfield are parallel to a curve, so that they need not lie in its direction. They
/// are where one of them is curved, or where the subfield's reference is.
bool follows_curve(const Plan& plan, std::size_t subfield);

/// "piece 12": pieces are numbered for people from 1, in driving order.
std::string piece_name(std::size_t index);
/// "headland pass 2"
std::string pass_name(std::size_t index);
/// "detour 2 of piece 12"
std::string detour_name(std::size_t piece, std::size_t detour);

/// A vertex of the polygon of largest area; the origin for an empty region.
Point point_on_largest(const Region& region);

}  // namespace tramline::check
