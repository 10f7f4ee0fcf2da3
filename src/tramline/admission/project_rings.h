#pragma once
// Step 1: checks the coordinates and projects them to the field's plane.

#include <string>

#include "tramline/admission/repair_log.h"
#include "tramline/admission/work_ring.h"
#include "tramline/model/raw_feature.h"

namespace tramline {

/// The fault of an input coordinate, as the end of a sentence ("has the latitude 123.4, beyond 90 degrees");
/// empty for a valid one.
std::string coordinate_fault(Point input, const Crs& crs);

/// Checks every vertex of the part. Throws bad_input, starting with `subject`, naming ring and vertex, for
/// NaN, infinite and out-of-range coordinates. O(vertices).
void check_coordinates(const RawPolygon& part, const Crs& crs, const std::string& subject);

/// Refuses coordinates that look like degrees although the CRS says metres: all within ±180, ±90, and the
/// outer ring less than 1 unit across, which no field in metres is. Throws bad_input suggesting --crs.
void check_not_degrees(const Box& bounds, const Crs& crs, const std::string& subject);

/// The ring in local metres; an unclosed ring is closed and noted (no area changes: the missing edge is the
/// one every reader implies). Throws a refusal for a point that PROJ refuses.
WorkRing project_ring(const RawRing& ring, const std::string& name, RepairLog& repair_log);

/// "outer ring" for 0, "hole 3" for 3.
std::string ring_name(std::size_t index);

}  // namespace tramline
