#pragma once
// The subfields, cuts and land to leave out of a file that the user drew.

#include <optional>
#include <string>
#include <vector>

#include "tramline/admission/read_obstacles.h"
#include "tramline/geometry/angle.h"

namespace tramline {

/// The columns of such a file.
inline constexpr const char* kDirectionColumn = "direction_deg";
inline constexpr const char* kGuideColumn = "guide";
inline constexpr const char* kSkipColumn = "skip";
inline constexpr const char* kNameColumn = "name";

/// One feature. Polygons are subfields or, where they are to be skipped, land left out. Lines are cuts,
/// except those that subfields name as their guide.
struct LooseSubfield {
  LooseObstacle feature;
  std::string name;
  std::optional<Direction> direction;
  std::string guide;  ///< the name of the line that its tracks follow; empty: none
  bool left_out = false;
};

/// The features of a dataset that was read with the four columns above; those that are missing count as
/// empty. Coordinates as in read_obstacles(). Throws bad_input, naming file and feature, as read_obstacles(),
/// for points, for a direction that is not a number of degrees between −360 and 360, for a `skip` that is
/// neither yes nor no, and for a guide that is no line of the file, or several. O(vertices).
std::vector<LooseSubfield> read_subfields(const RawDataset& dataset, const std::string& fields_crs);

}  // namespace tramline
