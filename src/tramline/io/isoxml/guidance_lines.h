#pragma once
// Guidance lines of a task set (GGP, GPN and LSG of type 5) as lines.

#include <string>

#include "tramline/model/raw_feature.h"

namespace pugi {
class xml_node;
}

namespace tramline::io {

/// A dataset with the layer "guidance", in WGS 84 and empty.
RawDataset empty_guidance(const std::string& file);

/// Adds the guidance lines of a partfield: those of its patterns (AB, A+, curve, spiral), and the line
/// strings of type 5 that version 3 has in the partfield itself. The id of a feature is that of its pattern
/// ("GPN1", in version 3 "PFD1 line 2"), its attribute "name" the designator, "role" is "track": the middle
/// of one. An A+ line, which is a point and a heading, becomes one of kAPlusLength_m. Pivots, which are
/// circles, and lines that cannot be read are listed in `skipped`.
void add_guidance(const pugi::xml_node& partfield, const std::string& file, RawDataset& dataset);

inline constexpr double kAPlusLength_m = 100;

}  // namespace tramline::io
