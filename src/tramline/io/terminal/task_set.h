#pragma once
// TASKDATA.XML of fields and guidance lines (ISO 11783-10).

#include <string>
#include <vector>

#include "tramline/io/export/export_format.h"
#include "tramline/io/export/export_plan.h"
#include "tramline/io/terminal/terminal_field.h"

namespace tramline::io {

struct TaskSetStyle {
  TaskDataVersion version = TaskDataVersion::k4;
  ObstacleStyle obstacles = ObstacleStyle::kHoles;
  std::string customer = "Customer";  ///< UTF-8
  std::string farm = "Farm";
};

struct TaskSet {
  std::string xml;  ///< of TASKDATA.XML
  std::vector<ChangedName> changed;
};

/// One customer, one farm, and for each field a partfield with its boundary, obstacles, headland and lines,
/// and a planned task. Version 4 has each line in a guidance group (GGP) and pattern (GPN) of its own,
/// version 3 as a line string of type 5 in the partfield. Designators are ASCII of at most 32 characters, no
/// two fields are called alike, ids are PFD1, GGP1 … over the whole set, and rings repeat their first point.
/// Coordinates have nine decimals. The same fields give the same text. O(n) in vertices.
TaskSet task_set(const std::vector<TerminalField>& fields, const TaskSetStyle& style);

}  // namespace tramline::io
