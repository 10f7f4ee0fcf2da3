#pragma once
// The picture of the turns of a machine: each beside the others, at one scale.

#include <filesystem>
#include <string>
#include <vector>

#include "tramline/geometry/path/steered_path.h"
#include "tramline/geometry/polygon/region.h"

namespace tramline::render {

/// A turn from the track that ends at the origin, along +y, to the one at +x. Metres.
struct DrawnTurn {
  std::string heading;  ///< "to 3 m: omega"
  std::string caption;  ///< what it needs, a line
  SteeredPath path;
  Region swept;          ///< the land that the outline passes over
  double spacing_m = 0;  ///< of the tracks
  double width_m = 0;    ///< of one track and one headland pass
  double depth_m = 0;    ///< of `swept` beyond the border, square to it
  Point border;          ///< unit vector along the border, to the right
};

/// Draws the turns to a PNG, SVG or PDF by the file's extension, row by row: the tracks up to the border, the
/// headland passes that the depth takes, the land swept, and the path, forward and in reverse. The same input
/// gives the same bytes. The file is written whole or not at all. Throws bad_input for another extension,
/// and Error(kFailure) when the file cannot be written. Precondition: not empty, width_m > 0.
void draw_turns(const std::string& title, const std::string& subtitle, const std::vector<DrawnTurn>& turns,
                const std::filesystem::path& path);

}  // namespace tramline::render
