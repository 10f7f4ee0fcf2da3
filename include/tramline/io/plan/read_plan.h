#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "tramline/model/plan.h"

namespace tramline::io {

/// A number of a plan file that repeats what a shape in it says already. A radius that there is not is 0.
struct DerivedNumber {
  std::string where;      ///< "layer tracks, feature 12, length_m"
  double stored = 0;      ///< as the file has it
  double from_shape = 0;  ///< as it follows from the shape in the file
  Point at;               ///< on the shape, local metres
  double rounding = 0;    ///< what the rounding of its corners may make of it: of areas
};

/// A text of a plan file that repeats what a shape in it says already.
struct DerivedText {
  std::string where;
  std::string stored;
  std::string from_shape;
  Point at;
};

/// A plan file with what a Plan does not hold because it follows from the rest; kept apart so that it
/// can be compared. Shapes are in local metres.
struct PlanFile {
  Plan plan;
  std::vector<int> track_order;  ///< the column order of the pieces, ascending; 1, 2, 3 … when whole
  std::vector<int> swath_order;  ///< the same of the swaths
  Region swaths;                 ///< the layer swaths, sorted by order
  /// What the layer tracks shows of each piece: chords, sorted like the pieces.
  std::vector<std::vector<Point>> track_lines;
  /// The same of the layer headland_passes.
  std::vector<std::vector<Point>> headland_lines;
  std::vector<DerivedNumber> derived;
  std::vector<DerivedText> derived_texts;
  std::map<std::string, std::string> remarks;  ///< of whoever keeps the file (remarks.h)
};

/// `field`: in a file of many (write_plans.h) the key or the id of the field whose plan is read, empty for
/// the only one; in a file of one plan its id, or empty.
///
/// Reads a plan file written by write_plan, or by that of format version 2, which knew neither headlands nor
/// curved tracks. Coordinates and numbers come back to the bit (in a plain
/// frame, which is shifted: to 1e-9 m), pieces and headland passes from the texts of their paths; of the
/// source file only the base name comes back. Throws Error(kBadInput) naming the file, and the layer and
/// feature at fault, where the file is missing, cut off, no plan, or holds a number that is not finite or a
/// text of another form, and then the column too; and where `field` names none or several. Shapes in a file
/// of many come back to 1e-7 m. O(n log n).
PlanFile read_plan_file(const std::filesystem::path& path, const std::string& field = {});

/// The plan alone.
Plan read_plan(const std::filesystem::path& path, const std::string& field = {});

}  // namespace tramline::io
