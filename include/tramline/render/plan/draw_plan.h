#pragma once
// The picture of a plan.

#include <filesystem>

#include "tramline/model/plan.h"
#include "tramline/render/page/page_layout.h"

namespace tramline::render {

struct PictureOptions {
  int width_px = 1600;  ///< from 600 to 16000; the height follows from the field's shape
};

/// Throws bad_input for a width out of range.
void require_picture_width(const PictureOptions& options);

/// Draws the plan to a PNG, SVG or PDF by the file's extension, north up: field, headland and its passes,
/// obstacles, subfields, tracks numbered in driving order, the line they follow, overlap and uncovered land
/// on top, with title, scale bar, north arrow, legend and numbers. The same plan gives the same bytes. The
/// file is written whole or not at all. Throws bad_input for another extension or width, Error(kFailure) when
/// the file cannot be written.
void draw_plan(const Plan& plan, const std::filesystem::path& path, const PictureOptions& options = {});

/// The layout used by draw_plan(); its view maps a point of the field to its pixel.
PageLayout layout_of(const Plan& plan, const PictureOptions& options = {});

}  // namespace tramline::render
