#pragma once
// A field folder of AgOpenGPS.

#include <cstddef>
#include <string>
#include <vector>

#include "tramline/io/export/file_set.h"
#include "tramline/io/terminal/terminal_field.h"

namespace tramline::io {

/// Field.txt, Boundary.txt, Headland.txt, TrackLines.txt and Sections.txt, in metres from the origin of the
/// field's frame. Obstacles are inner boundaries, those that are passable to be driven through. The headland
/// line is the outer ring of the largest part of `body`, the land inside the headlands, and those of
/// obstacles its holes round them. Straight lines are AB lines, others curves with points no more than
/// kLongestStep_m apart. Sections.txt holds the worked land in triangles, each a patch of its own; it is
/// empty where nothing is worked yet. Times follow time_of_files().
std::vector<NamedFile> agopengps_files(const TerminalField& field, const std::string& folder_name);

/// AgOpenGPS makes parallels to a curve point by point; it is not to be left with long steps.
inline constexpr double kLongestStep_m = 5;
/// AgOpenGPS does not use curves of fewer points.
inline constexpr std::size_t kLeastCurvePoints = 5;

}  // namespace tramline::io
