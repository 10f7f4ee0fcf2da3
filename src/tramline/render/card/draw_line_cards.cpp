#include <fmt/format.h>

#include <algorithm>

#include "tramline/geometry/error.h"
#include "tramline/render/page/a4.h"
#include "tramline/render/page/canvas.h"
#include "tramline/render/page/text.h"
#include "tramline/render/plan/draw_plan.h"
#include "tramline/render/plan/small_map.h"

namespace tramline::render {
namespace {

constexpr double kLeft = kA4Margin, kRight = kA4Width_px - kA4Margin, kBottom = kA4Height_px - kA4Margin;
constexpr double kCardTitle = 34, kCardRow = 30, kCardGap = 16;
constexpr double kCardText_px = 20, kCardTitle_px = 32;
constexpr double kTallestCardMap_px = 760;

/// North arrow: its length and how far it is from the corner of the map.
constexpr double kArrow_px = 44, kFromCorner_px = 26;

class Cards {
 public:
  Cards() : canvas_(PictureFormat::kPdf, kA4Width_px, kA4Height_px) { canvas_.use({}, 1); }

  void add(const LineCard& card) {
    if (pages_ > 0) cairo_show_page(canvas_.cr());
    ++pages_;
    y_ = kA4Margin;
    title_ = printable(card.plan.field.id.empty() ? "field" : card.plan.field.id);
    title();
    map(card);
    for (const CardLine& line : card.lines) {
      row(line.name, true);
      for (const std::string& text : line.rows) row(text, false);
      y_ += kCardGap;
    }
    for (const std::string& text : card.rows) row(text, false);
  }

  std::string finish() { return canvas_.finish(); }

 private:
  void title() {
    draw_text(canvas_, {kLeft, y_}, fitted(canvas_, title_, {kCardTitle_px, true}, kRight - kLeft),
              {kCardTitle_px, true});
    y_ += kCardTitle;
  }

  void map(const LineCard& card) {
    const Box drawn_m = drawn_box(card.plan);
    if (drawn_m.empty())
      throw bad_input(fmt::format("field {}: there is no outline to draw", card.plan.field.id));
    const double height = std::min(small_map_height(drawn_m, kRight - kLeft), kTallestCardMap_px);
    const Box box{kLeft, y_, kRight, y_ + height};
    draw_small_map(canvas_, card.plan, drawn_m, box, 1);
    const MapView view = small_map_view(drawn_m, box, 1);
    for (const CardLine& line : card.lines) guide(line, view);
    north_arrow({box.max_x - kFromCorner_px, box.min_y + kFromCorner_px});
    y_ = box.max_y + kCardRow;
  }

  void guide(const CardLine& line, const MapView& view) {
    const Point a = view.to_page(line.a), b = view.to_page(line.b);
    stroke_line(canvas_, {a, b}, {kInk, 2.5, {12, 6}});
    for (const auto& [end, letter] : {std::pair{a, "A"}, std::pair{b, "B"}}) {
      disc(canvas_, end, 5, kInk);
      TextStyle style{kCardText_px, true, Align::kCentre, kInk, true};
      const Point beside{std::clamp(end.x, kLeft + kCardText_px, kRight - kCardText_px),
                         end.y - kCardText_px};
      draw_text(canvas_, beside, fmt::format("{} {}", letter, line.name), style);
    }
  }

  void north_arrow(Point tip) {
    stroke_line(canvas_, {{tip.x, tip.y + kArrow_px}, tip}, {kInk, 2});
    fill_shape(canvas_, {tip, {tip.x - 7, tip.y + 16}, {tip.x + 7, tip.y + 16}}, kInk);
    draw_text(canvas_, {tip.x, tip.y + kArrow_px + kCardText_px}, "N",
              {kCardText_px, true, Align::kCentre, kInk, true});
  }

  /// A row of text, broken between words where it is too wide.
  void row(const std::string& text, bool bold) {
    const TextStyle style{kCardText_px, bold};
    std::string rest = printable(text);
    while (!rest.empty()) {
      const std::size_t taken = words_that_fit(rest, style);
      if (y_ > kBottom) next_page();
      draw_text(canvas_, {kLeft, y_}, fitted(canvas_, rest.substr(0, taken), style, kRight - kLeft), style);
      y_ += kCardRow;
      rest.erase(0, std::min(rest.size(), taken + 1));
    }
  }

  /// So many bytes of the text, up to a blank or its end; at least one word.
  std::size_t words_that_fit(const std::string& text, const TextStyle& style) {
    std::size_t fits = std::min(text.find(' '), text.size());
    for (std::size_t end = fits; end < text.size();) {
      end = std::min(text.find(' ', end + 1), text.size());
      if (text_width(canvas_, text.substr(0, end), style) > kRight - kLeft) break;
      fits = end;
    }
    return fits;
  }

  void next_page() {
    cairo_show_page(canvas_.cr());
    ++pages_;
    y_ = kA4Margin;
    title();
  }

  Canvas canvas_;
  std::string title_;
  double y_ = 0;
  int pages_ = 0;
};

}  // namespace

void draw_line_cards(std::size_t cards, const std::function<LineCard(std::size_t)>& card,
                     const std::filesystem::path& path) {
  if (format_of(path) != PictureFormat::kPdf)
    throw bad_input(fmt::format("line card {}: the name of a card to print ends in .pdf", path.string()));
  if (cards == 0) throw bad_input("there is no field to draw a card of");
  Cards pages;
  for (std::size_t i = 0; i < cards; ++i) pages.add(card(i));
  write_whole(path, pages.finish());
}

}  // namespace tramline::render
