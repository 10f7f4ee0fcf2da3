#pragma once
// The picture of a front: a chart of its points, and its marked plans.

#include <filesystem>
#include <vector>

#include "tramline/model/plan.h"
#include "tramline/render/plan/draw_plan.h"

namespace tramline::render {

/// Draws a front to a PNG, SVG or PDF by the file's extension: overlap against uncovered land, with turns
/// and stops as colour, and below it the plans of marked_points(), in that order, each named by a letter that
/// stands at its point in the chart too. The same input gives the same bytes. The file is written whole or
/// not at all.
/// Throws bad_input for another extension or width, or an empty front, Error(kFailure) when the file cannot
/// be written. Precondition: as many plans as marked_points().
void draw_trade_off(const Front& front, const std::vector<Plan>& plans, const std::filesystem::path& path,
                    const PictureOptions& options = {});

}  // namespace tramline::render
