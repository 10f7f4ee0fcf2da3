#pragma once
// The picture of a plan, of several, and tables of their figures.

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

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

/// Draws the plan alone, without any text, as small as in a list: from 40 to 600 pixels wide, at most 1.2
/// times as high. The same plan gives the same bytes. Format, wholeness and errors as draw_plan().
void draw_thumbnail(const Plan& plan, const std::filesystem::path& path, int width_px);

/// A plan of a sheet of small maps, with what is said above its map.
struct SmallMap {
  Plan plan;
  std::string heading;
  std::vector<std::string> lines;  ///< below the heading
};

/// Draws plans of one field side by side to a PNG, SVG or PDF by the file's extension, all at one scale,
/// north up, with a title, and a legend for all of them. The same input gives the same bytes. The file is
/// written whole or not at all. Throws bad_input for another extension or width, and where there is no map;
/// Error(kFailure) when the file cannot be written.
void draw_small_maps(const std::string& title, const std::string& subtitle, const std::vector<SmallMap>& maps,
                     const std::filesystem::path& path, const PictureOptions& options = {});

/// Figures of plans as text: as many cells in every row as in the head, the first two of them names.
struct Table {
  std::string title, subtitle;
  std::vector<std::string> head;
  std::vector<std::vector<std::string>> rows;
  std::vector<std::vector<std::string>> sums;  ///< below a rule
};

/// Draws the table to a PDF, on as many upright pages of A4 as it needs, each with its head. The same input
/// gives the same bytes. The file is written whole or not at all. Throws bad_input for another extension and
/// where there is no column, Error(kFailure) when the file cannot be written.
void draw_table(const Table& table, const std::filesystem::path& path);

/// A line to be typed into a display, or to be steered by from a printed page.
struct CardLine {
  std::string name;
  Point a, b;                     ///< its ends, in the field's local metres
  std::vector<std::string> rows;  ///< what is said of it: ends in degrees, heading
};

/// A page for the driver of one field.
struct LineCard {
  Plan plan;
  std::vector<CardLine> lines;
  std::vector<std::string> rows;  ///< the rest: width, headland, order, hours; long ones are broken
};

/// Draws a page of A4 for each field to a PDF: its name, a map with the lines and their ends A and B, the
/// lines, and what is said below. What does not fit on a page goes on on the next. `card` gives the pages one
/// after the other. The same input gives the same bytes. The file is written whole or not at all. Throws
/// bad_input for another extension and where there is no card, Error(kFailure) when the file cannot be
/// written.
void draw_line_cards(std::size_t cards, const std::function<LineCard(std::size_t)>& card,
                     const std::filesystem::path& path);

/// The layout used by draw_plan(); its view maps a point of the field to its pixel.
PageLayout layout_of(const Plan& plan, const PictureOptions& options = {});

}  // namespace tramline::render
