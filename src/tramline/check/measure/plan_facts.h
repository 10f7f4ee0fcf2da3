#pragma once
// What rules ask of a plan as it stands, and what they call its parts.

#include <cstddef>
#include <string>
#include <vector>

#include "tramline/model/plan.h"

namespace tramline::check {

/// The tightest circle that the machine can drive and its swath can follow, m.
double least_radius_m(const Machine& machine);

/// Are these indices of obstacles of the field?
bool exist(const Plan& plan, const std::vector<std::size_t>& obstacles);
/// How many passes of headland an obstacle has.
int passes_round(const Plan& plan, std::size_t obstacle);
/// Are the tracks of a subfield parallel to a curve, so that they need not lie in its direction? They are
/// where one of them is curved, or where the subfield's reference is.
bool follows_curve(const Plan& plan, std::size_t subfield);

/// "piece 12": pieces are numbered for people from 1, in driving order.
std::string piece_name(std::size_t index);
/// "headland pass 2"
std::string pass_name(std::size_t index);
/// "detour 2 of piece 12"
std::string detour_name(std::size_t piece, std::size_t detour);

/// A vertex of the polygon of largest area; the origin for an empty region.
Point place_on_largest(const Region& region);

}  // namespace tramline::check
