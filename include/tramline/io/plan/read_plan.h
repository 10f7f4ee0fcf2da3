#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "tramline/model/plan.h"

namespace tramline::io {

/// A number of a plan file that also follows from a shape in it. A missing radius is 0.
struct DerivedNumber {
  std::string where;      ///< "layer tracks, feature 12, length_m"
  double stored = 0;      ///< value in the file
  double from_shape = 0;  ///< value that follows from the shape in the file
  Point at;               ///< a point on the shape, local metres
  double rounding = 0;    ///< possible effect of the rounding of corners, for areas
};

/// A text of a plan file that also follows from a shape in it.
struct DerivedText {
  std::string where;
  std::string stored;
  std::string from_shape;
  Point at;
};

/// A plan file: the plan, and the data that a Plan does not hold because they follow from the rest, kept
/// separately for comparison. Shapes are in local metres.
struct PlanFile {
  Plan plan;
  /// The column `order` of the pieces, ascending; 1, 2, 3 … in a complete file.
  std::vector<int> track_order;
  std::vector<int> swath_order;  ///< the same for the swaths
  Region swaths;                 ///< the layer swaths, sorted by order
  /// The line of each piece in the layer tracks: chords, sorted like the pieces.
  std::vector<std::vector<Point>> track_lines;
  /// The same for the layer headland_passes.
  std::vector<std::vector<Point>> headland_lines;
  std::vector<DerivedNumber> derived;
  std::vector<DerivedText> derived_texts;
  std::optional<StatedCost> stated_cost{};     ///< of a plan with a route; older files have none
  std::map<std::string, std::string> remarks;  ///< remarks of the program that keeps the file (remarks.h)
};

/// `field`: in a file of many (write_plans.h) the key or the id of the field whose plan is read, empty for
/// the only one; in a file of one plan its id, or empty.
///
/// Reads a plan file written by write_plan, or by that of format version 2, which knew neither headlands nor
/// curved tracks. Coordinates and numbers are restored bit-identically (in a plain frame, which is shifted:
/// to 1e-9 m), pieces and headland passes from the texts of their paths; of the source file only the base
/// name is restored. Throws Error(kBadInput) naming the file, and the layer and feature at fault, where the
/// file is missing, truncated, not a plan, or, then naming the column too, where it holds a number that is
/// not finite or a malformed text; and where `field` names none or several. Shapes in a file of many are
/// restored to 1e-7 m. O(n log n).
PlanFile read_plan_file(const std::filesystem::path& path, const std::string& field = {});

/// The plan of read_plan_file() alone.
Plan read_plan(const std::filesystem::path& path, const std::string& field = {});

}  // namespace tramline::io
