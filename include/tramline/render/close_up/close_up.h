#pragma once
// One picture of an obstacle: how the tracks near it get past.

#include <filesystem>

#include "tramline/model/plan.h"
#include "tramline/render/page/page_layout.h"
#include "tramline/render/plan/draw_plan.h"

namespace tramline::render {

/// Draws the surroundings of Field::obstacles[obstacle] to a PNG, SVG or PDF by the file's extension,
/// north up: the obstacle, how near to it a track may pass, swaths and tracks, whole detours with their
/// tightest arcs, faults and stops; below, what was decided at each meeting of a track with it. The same
/// plan gives the same bytes. The file is written whole or not at all.
/// Throws bad_input for another extension, width or an obstacle that is not there, Error(kFailure) when
/// the file cannot be written.
void draw_close_up(const Plan& plan, std::size_t obstacle, const std::filesystem::path& path,
                   const PictureOptions& options = {});

struct CloseUpLayout {
  PageLayout page;
  Box table;       ///< under everything else, px
  Box seen;        ///< what the map shows, m
  Box legend_for;  ///< what the legend names the symbols of, m
};

/// Where draw_close_up() puts things.
CloseUpLayout close_up_layout(const Plan& plan, std::size_t obstacle, const PictureOptions& options = {});

}  // namespace tramline::render
