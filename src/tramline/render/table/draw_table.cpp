#include <fmt/format.h>

#include <algorithm>
#include <cassert>

#include "tramline/geometry/error.h"
#include "tramline/render/page/canvas.h"
#include "tramline/render/page/text.h"
#include "tramline/render/plan/draw_plan.h"

namespace tramline::render {
namespace {

// A4 upright, at the half point per pixel of PDF pages.
constexpr int kWidth_px = 1190, kHeight_px = 1684;
constexpr double kMargin = 70, kTitle = 34, kRow = 34, kGap = 14;
constexpr double kTextSize_px = 19, kTitleSize_px = 30;

/// A table on pages of A4, from the top of the first to the end of its last row.
class TablePages {
 public:
  explicit TablePages(const Table& table)
      : table_(table), canvas_(PictureFormat::kPdf, kWidth_px, kHeight_px) {
    find_columns();
  }

  std::string run() {
    heading();
    head();
    for (const std::vector<std::string>& row : table_.rows) {
      if (y_ + kRow > kHeight_px - kMargin) next_page();
      cells(row, style_of(false));
    }
    rule();
    for (const std::vector<std::string>& row : table_.sums) {
      if (y_ + kRow > kHeight_px - kMargin) next_page();
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
        widths_[i] = std::max(widths_[i], text_width(canvas_, row[i], style_of(bold)) + kGap);
    };
    widen(table_.head, true);
    for (const auto& row : table_.rows) widen(row, false);
    for (const auto& row : table_.sums) widen(row, true);
    double all = 0;
    for (const double width : widths_) all += width;
    const double room = kWidth_px - 2 * kMargin;
    widths_.front() = std::max(4 * kTextSize_px, widths_.front() + room - all);
  }

  void heading() {
    y_ = kMargin;
    draw_text(canvas_, {kMargin, y_}, printable(table_.title), {kTitleSize_px, true});
    y_ += kTitle;
    const TextStyle small{kTextSize_px};
    draw_text(canvas_, {kMargin, y_},
              fitted(canvas_, printable(table_.subtitle), small, kWidth_px - 2 * kMargin), small);
    y_ += kTitle;
  }

  void head() {
    cells(table_.head, style_of(true));
    rule();
  }

  void next_page() {
    cairo_show_page(canvas_.cr());
    y_ = kMargin;
    head();
  }

  void rule() {
    const double at = y_ - 0.5 * kRow + 4;
    stroke_line(canvas_, {{kMargin, at}, {kWidth_px - kMargin, at}}, {kInk, 1.5});
    y_ += 10;
  }

  /// The first two columns are names, the others numbers.
  void cells(const std::vector<std::string>& row, const TextStyle& style) {
    double x = kMargin;
    for (std::size_t i = 0; i < row.size(); ++i) {
      TextStyle own = style;
      own.align = i < 2 ? Align::kLeft : Align::kRight;
      const double width = widths_[i] - kGap;
      draw_text(canvas_, {i < 2 ? x : x + widths_[i], y_}, fitted(canvas_, printable(row[i]), own, width),
                own);
      x += widths_[i];
    }
    y_ += kRow;
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
