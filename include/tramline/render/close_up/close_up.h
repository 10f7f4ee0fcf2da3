#pragma once
// The picture of an obstacle and of the tracks that get past it.

#include <filesystem>

#include "tramline/model/plan.h"
#include "tramline/render/page/page_layout.h"
#include "tramline/render/plan/draw_plan.h"

namespace tramline::render {

/// Draws the surroundings of Field::obstacles[obstacle] to a PNG, SVG or PDF by the file's extension,
/// north up: the obstacle, how near to it a track may pass, swaths and tracks, whole detours with their
/// tightest arcs, faults and stops; below them a table of the choices made for each track that reaches it.
/// The same plan gives the same bytes. The file is written whole or not at all.
/// Throws bad_input for another extension, width or an obstacle that is not there, Error(kFailure) when
/// the file cannot be written.
void draw_close_up(const Plan& plan, std::size_t obstacle, const std::filesystem::path& path,
                   const PictureOptions& options = {});

struct CloseUpLayout {
  PageLayout page;
  Box table;       ///< under everything else, px
  Box seen;        ///< the part of the field that the map shows, m
  Box legend_for;  ///< the part of the field whose symbols the legend explains, m
};

/// The layout used by draw_close_up().
CloseUpLayout close_up_layout(const Plan& plan, std::size_t obstacle, const PictureOptions& options = {});

}  // namespace tramline::render
