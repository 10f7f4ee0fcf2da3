#pragma once
// A plan file says some things twice. These functions find where it contradicts itself.

#include <string>
#include <vector>

#include "tramline/check/verify.h"
#include "tramline/model/plan.h"

namespace tramline::check {

/// Does the stored layer of swaths agree with the tracks and the working width? Corner by corner, to
/// 1e-6 m; swaths with arcs may be cut into other chords. `track_order` and `swath_order` are the stored
/// numbers of plan.pieces and of `swaths`: both have to be 1, 2, 3 … Rule "layers". O(p).
std::vector<Violation> compare_swaths(const Plan& plan, const std::vector<int>& track_order,
                                      const Region& swaths, const std::vector<int>& swath_order);

/// Do the lines that the layer of tracks shows agree with the exact paths? `lines`: of plan.pieces, in
/// their order, local metres. Both ways to 0.02 mm, twice what chords may be off, and the same ends to
/// 1e-6 m: otherwise rule "layers". A line that does not agree is then judged itself, as far as a
/// polyline can be: "swaths" where it leaves the field, "clearance", and "drivable" where it bends
/// more than the machine can. Precondition: verify(plan).complete. O(p + n) for n points while they agree.
std::vector<Violation> compare_lines(const Plan& plan, const std::vector<std::vector<Point>>& lines);

/// A stored text against the one its shape gives. Rule "layers".
void compare_text(const std::string& where, const std::string& stored, const std::string& from_shape,
                  Point at, std::vector<Violation>& out);

/// A stored number against the one its shape gives; equal to 1e-6, absolutely or relatively, and to
/// `rounding`, what rounded corners may make of it. Rule "layers".
void compare_number(const std::string& where, double stored, double from_shape, double rounding, Point at,
                    std::vector<Violation>& out);

}  // namespace tramline::check
