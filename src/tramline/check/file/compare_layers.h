#pragma once
// Checks of data that a plan file contains twice: these functions find contradictions within the file.

#include <string>
#include <vector>

#include "tramline/check/verify.h"
#include "tramline/model/plan.h"

namespace tramline::check {

/// Checks that the stored layer of swaths agrees with the tracks and the working width, corner by corner, to
/// 1e-6 m; arcs of swaths may be divided into other chords. `track_order` and `swath_order` are the stored
/// numbers of plan.pieces and of `swaths`: both have to be 1, 2, 3 … Rule "layers". O(p).
std::vector<Violation> compare_swaths(const Plan& plan, const std::vector<int>& track_order,
                                      const Region& swaths, const std::vector<int>& swath_order);

/// Checks that the lines of the layer of tracks agree with the exact paths. `lines`: those of plan.pieces, in
/// their order, local metres. Each has to lie within 0.02 mm of the path, twice the tolerance of chords, and
/// the path within that of the line, with the same ends to 1e-6 m; otherwise rule "layers". A line that does
/// not agree is then checked itself, as far as a polyline can be: "swaths" where it leaves the field,
/// "clearance", and "drivable" where it bends more than the machine can. Precondition: verify(plan).complete.
/// O(p + n) for n points while they agree.
std::vector<Violation> compare_lines(const Plan& plan, const std::vector<std::vector<Point>>& lines);

/// Compares a stored text with the one that follows from its shape. Rule "layers".
void compare_text(const std::string& where, const std::string& stored, const std::string& from_shape,
                  Point at, std::vector<Violation>& out);

/// Compares a stored number with the one that follows from its shape. They may differ by 1e-6, absolutely or
/// relatively, and by `rounding`, the possible effect of rounded corners. Rule "layers".
void compare_number(const std::string& where, double stored, double from_shape, double rounding, Point at,
                    std::vector<Violation>& out);

}  // namespace tramline::check
