#pragma once
// The picture of a dose map.

#include <filesystem>

#include "tramline/model/dose_map.h"
#include "tramline/render/page/page_layout.h"
#include "tramline/render/plan/draw_plan.h"

namespace tramline::render {

/// Draws the map to a PNG, SVG or PDF by the file's extension, north up: cells in the colours of their rates,
/// the field's outline, the wind, with title, scale bar, north arrow, the histogram over the colours it is
/// drawn in, and figures. The same map gives the same bytes. The file is written whole or not at all. Throws
/// bad_input for another extension or width, and where there is nothing to draw; Error(kFailure) when the
/// file cannot be written. O(cells).
void draw_dose(const DoseMap& map, const std::filesystem::path& path, const PictureOptions& options = {});

/// The layout used by draw_dose(); its view maps a point of the field to its pixel.
PageLayout layout_of(const DoseMap& map, const PictureOptions& options = {});

}  // namespace tramline::render
