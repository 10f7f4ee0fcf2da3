#include <fmt/format.h>

#include <algorithm>
#include <cassert>

#include "tramline/geometry/error.h"
#include "tramline/render/page/a4.h"
#include "tramline/render/page/canvas.h"
#include "tramline/render/page/text.h"
#include "tramline/render/plan/draw_plan.h"

namespace tramline::render {
namespace {

constexpr double kTableTitle = 34, kTableRow = 34, kColumnGap = 14;
constexpr double kTextSize_px = 19, kTitleSize_px = 30;

/// A table on pages of A4, from the top of the first to the end of its last row.
class TablePages {
 public:
  explicit TablePages(const Table& table)
      : table_(table), canvas_(PictureFormat::kPdf, kA4Width_px, kA4Height_px) {
    find_columns();
  }

  std::string run() {
    heading();
    head();
    for (const std::vector<std::string>& row : table_.rows) {
      if (y_ + kTableRow > kA4Height_px - kA4Margin) next_page();
      cells(row, style_of(false));
    }
    rule();
    for (const std::vector<std::string>& row : table_.sums) {
      if (y_ + kTableRow > kA4Height_px - kA4Margin) next_page();
      cells(row, style_of(true));
    }
    return canvas_.finish();
  }

 private:
  TextStyle style_of(bool bold) const { return {kTextSize_px, bold}; }

  /// Each as wide as its widest cell; the first one gives way where they are wider than the page.
  void find_columns() {
    widths_.assign(table_.head.size(), 0);
    const auto widen = [this](const std::vector<std::string>& row, bool bold) {
      assert(row.size() == widths_.size());
      for (std::size_t i = 0; i < row.size(); ++i)
        widths_[i] = std::max(widths_[i], text_width(canvas_, row[i], style_of(bold)) + kColumnGap);
    };
    widen(table_.head, true);
    for (const auto& row : table_.rows) widen(row, false);
    for (const auto& row : table_.sums) widen(row, true);
    double all = 0;
    for (const double width : widths_) all += width;
    const double room = kA4Width_px - 2 * kA4Margin;
    widths_.front() = std::max(4 * kTextSize_px, widths_.front() + room - all);
  }

  void heading() {
    y_ = kA4Margin;
    draw_text(canvas_, {kA4Margin, y_}, printable(table_.title), {kTitleSize_px, true});
    y_ += kTableTitle;
    const TextStyle small{kTextSize_px};
    draw_text(canvas_, {kA4Margin, y_},
              fitted(canvas_, printable(table_.subtitle), small, kA4Width_px - 2 * kA4Margin), small);
    y_ += kTableTitle;
  }

  void head() {
    cells(table_.head, style_of(true));
    rule();
  }

  void next_page() {
    cairo_show_page(canvas_.cr());
    y_ = kA4Margin;
    head();
  }

  void rule() {
    const double at = y_ - 0.5 * kTableRow + 4;
    stroke_line(canvas_, {{kA4Margin, at}, {kA4Width_px - kA4Margin, at}}, {kInk, 1.5});
    y_ += 10;
  }

  /// The first two columns are names, the others numbers.
  void cells(const std::vector<std::string>& row, const TextStyle& style) {
    double x = kA4Margin;
    for (std::size_t i = 0; i < row.size(); ++i) {
      TextStyle own = style;
      own.align = i < 2 ? Align::kLeft : Align::kRight;
      const double width = widths_[i] - kColumnGap;
      draw_text(canvas_, {i < 2 ? x : x + widths_[i], y_}, fitted(canvas_, printable(row[i]), own, width),
                own);
      x += widths_[i];
    }
    y_ += kTableRow;
  }

  const Table& table_;
  Canvas canvas_;
  std::vector<double> widths_;
  double y_ = 0;
};

}  // namespace

void draw_table(const Table& table, const std::filesystem::path& path) {
  if (format_of(path) != PictureFormat::kPdf)
    throw bad_input(fmt::format("table {}: the name of a table to print ends in .pdf", path.string()));
  if (table.head.empty()) throw bad_input("a table without columns cannot be drawn");
  write_whole(path, TablePages(table).run());
}

}  // namespace tramline::render
