#pragma once
// Partfields of a task set (PFD, PLN, LSG, PNT) as polygons.

#include <optional>
#include <string>
#include <vector>

#include "tramline/model/raw_feature.h"

namespace pugi {
class xml_node;
}

namespace tramline::io {

/// The positions of a line string, longitude and latitude; nullopt where one is none, with the reason in
/// `fault`, which calls the line `what`: "a ring".
std::optional<std::vector<Point>> points_of(const pugi::xml_node& line, const char* what, std::string& fault);

/// A dataset with the two layers "partfields" and "obstacles", both in WGS 84 and empty.
RawDataset empty_partfields(const std::string& file);

/// Adds a partfield: one feature with the polygons of its boundary (PLN types 1 and 9; exterior rings are LSG
/// type 1, holes type 2), and one feature for each of its obstacles (PLN types 3 water, 4 building and 6
/// obstacle). Rings may be closed or open, a PLN may have several exteriors (version 3) or one each (version
/// 4); a hole belongs to the first exterior that its first point lies in, else to the first. Anything that
/// cannot be read is listed in `skipped`.
void add_partfield(const pugi::xml_node& partfield, const std::string& file, RawDataset& dataset);

}  // namespace tramline::io
