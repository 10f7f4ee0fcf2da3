#pragma once
// The picture of an evaluation.

#include <filesystem>

#include "tramline/model/coverage.h"
#include "tramline/render/page/page_layout.h"
#include "tramline/render/plan/draw_plan.h"

namespace tramline::render {

/// Draws the evaluation to a PNG, SVG or PDF by the file's extension, north up: the field, covered land
/// (paler outside the field), repeated, missed and not recorded land, the path of the machine, and the
/// numbers of the largest gaps, with title, scale bar, north arrow, legend, areas and the list of gaps. The
/// map shows the field and what was covered near it (all that was covered where there is no field); anything
/// beyond is cut off. The same evaluation gives the same bytes. The file is written whole or not at all.
/// Throws bad_input for another extension or width, and where there is neither a field nor covered land;
/// Error(kFailure) when the file cannot be written. Usually O(n log n) in vertices.
void draw_coverage(const Coverage& coverage, const std::filesystem::path& path,
                   const PictureOptions& options = {});

/// The layout used by draw_coverage(); its view maps a point of the field to its pixel.
PageLayout layout_of(const Coverage& coverage, const PictureOptions& options = {});

/// The box that the map shows, m: the field, and covered land no further from it than a tenth of its length
/// or twice the width; without a field all covered land.
Box drawn_box(const Coverage& coverage);

}  // namespace tramline::render
