#include "tramline/render/close_up/encounter_table.h"

namespace tramline::render {
namespace {

constexpr double kTableHeadingHeight = 34;
constexpr double kRowHeight = 25;
constexpr double kTrackColumn = 80;
constexpr double kChosenColumn = 140;

struct Column {
  double left = 0;
  double width = 0;
};

std::array<Column, 4> columns_in(const Box& box, double k) {
  const double first = kTrackColumn * k, second = kChosenColumn * k;
  const double rest = 0.5 * (box.width() - first - second);
  return {{{box.min_x, first},
           {box.min_x + first, second},
           {box.min_x + first + second, rest},
           {box.min_x + first + second + rest, rest}}};
}

void draw_cells(Canvas& canvas, const Box& box, double middle, const EncounterRow& row,
                const TextStyle& style) {
  const auto columns = columns_in(box, canvas.scale());
  const std::array<std::string, 4> cells = cells_of(canvas, box, row, style);
  for (std::size_t i = 0; i < cells.size(); ++i)
    draw_text(canvas, {columns[i].left, middle}, cells[i], style);
}

}  // namespace

std::array<std::string, 4> cells_of(Canvas& canvas, const Box& box, const EncounterRow& row,
                                    const TextStyle& style) {
  if (row.whole_line) return {fitted(canvas, printable(row.track), style, box.width()), "", "", ""};
  const auto columns = columns_in(box, canvas.scale());
  const auto cell = [&](const std::string& text, std::size_t column) {
    return fitted(canvas, printable(text), style, columns[column].width - 10 * canvas.scale());
  };
  return {cell(row.track, 0), cell(row.chosen, 1), cell(row.left, 2), cell(row.right, 3)};
}

double height_of_table(const std::vector<EncounterRow>& rows) {
  const std::size_t lines = rows.empty() ? 1 : rows.size();
  return kTableHeadingHeight + kRowHeight * static_cast<double>(lines);
}

void draw_encounter_table(Canvas& canvas, const Box& box, const std::vector<EncounterRow>& rows) {
  const double k = canvas.scale();
  const EncounterRow heading{"Track", "Way past", "Left, cost above a cut", "Right, cost above a cut"};
  draw_cells(canvas, box, box.min_y + 10 * k, heading, {kTextSize, true});
  const double rule = box.min_y + 26 * k;
  stroke_line(canvas, {{box.min_x, rule}, {box.max_x, rule}}, {kRule, 1.2 * k});
  double middle = box.min_y + (kTableHeadingHeight + 0.5 * kRowHeight) * k;
  if (rows.empty())
    draw_text(canvas, {box.min_x, middle}, "no meeting of a track with this obstacle is recorded",
              {kTextSize, false, Align::kLeft, kFaintInk});
  for (const EncounterRow& row : rows) {
    draw_cells(canvas, box, middle, row, {});
    middle += kRowHeight * k;
  }
}

}  // namespace tramline::render
