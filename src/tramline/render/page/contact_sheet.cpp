#include "tramline/render/page/contact_sheet.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "tramline/geometry/error.h"
#include "tramline/render/page/canvas.h"
#include "tramline/render/page/text.h"

namespace tramline::render {
namespace {

constexpr int kCellWidth = 640;
constexpr int kTallestCell = 640;
constexpr int kCaptionHeight = 34;
constexpr int kCellGap = 20;
constexpr int kLargestSheet = 32000;  // cairo's images end at 32767 px

struct Picture {
  std::filesystem::path path;
  int width = 0;
  int height = 0;
  double shrink = 1;
  int shown_height() const { return static_cast<int>(std::ceil(height * shrink)); }
};

Surface open_png(const std::filesystem::path& path) {
  Surface surface(cairo_image_surface_create_from_png(path.c_str()));
  if (cairo_surface_status(surface.get()) != CAIRO_STATUS_SUCCESS)
    throw bad_input(fmt::format("picture {}: it is not a PNG file that can be read", path.string()));
  return surface;
}

// Only the size is kept: a sheet of many large pictures must not hold them all at once.
Picture measure(const std::filesystem::path& path) {
  const Surface surface = open_png(path);
  Picture picture{path, cairo_image_surface_get_width(surface.get()),
                  cairo_image_surface_get_height(surface.get())};
  picture.shrink = std::min({1.0, static_cast<double>(kCellWidth) / picture.width,
                             static_cast<double>(kTallestCell) / picture.height});
  return picture;
}

std::vector<int> row_heights(const std::vector<Picture>& pictures, int columns) {
  std::vector<int> out;
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    if (i % static_cast<std::size_t>(columns) == 0) out.push_back(0);
    out.back() = std::max(out.back(), pictures[i].shown_height());
  }
  return out;
}

void place(Canvas& canvas, const Picture& picture, double left, double top, int row_height) {
  const Surface surface = open_png(picture.path);
  cairo_t* cr = canvas.cr();
  cairo_save(cr);
  cairo_translate(cr, left + 0.5 * (kCellWidth - picture.width * picture.shrink),
                  top + 0.5 * (row_height - picture.shown_height()));
  cairo_scale(cr, picture.shrink, picture.shrink);
  cairo_set_source_surface(cr, surface.get(), 0, 0);
  cairo_pattern_set_filter(cairo_get_source(cr), CAIRO_FILTER_GOOD);
  cairo_paint(cr);
  cairo_restore(cr);
  // A thin frame: pictures are white to their edges and would run into one another.
  const double right = left + kCellWidth;
  const double bottom = top + row_height;
  stroke_line(canvas, {{left, top}, {right, top}, {right, bottom}, {left, bottom}, {left, top}}, {kRule, 1});
}

}  // namespace

void contact_sheet(const std::vector<std::filesystem::path>& pngs, const std::vector<std::string>& captions,
                   const std::filesystem::path& out, int columns) {
  const PictureFormat format = format_of(out);
  if (pngs.empty()) throw bad_input("contact sheet: there is no picture to put on it");
  if (captions.size() != pngs.size())
    throw bad_input(fmt::format("contact sheet: {} captions for {} pictures", captions.size(), pngs.size()));
  if (columns < 1) throw bad_input("contact sheet: it needs at least one column");
  columns = std::min(columns, static_cast<int>(pngs.size()));
  std::vector<Picture> pictures;
  for (const std::filesystem::path& path : pngs) pictures.push_back(measure(path));
  const std::vector<int> heights = row_heights(pictures, columns);
  const int width = kCellGap + columns * (kCellWidth + kCellGap);
  int height = kCellGap;
  for (const int row : heights) height += row + kCaptionHeight + kCellGap;
  if (std::max(width, height) > kLargestSheet)
    throw bad_input(fmt::format("contact sheet: {} pictures do not fit on one sheet", pngs.size()));

  Canvas canvas(format, width, height);
  double top = kCellGap;
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    const std::size_t column = i % static_cast<std::size_t>(columns);
    const int row_height = heights[i / static_cast<std::size_t>(columns)];
    const double left = kCellGap + static_cast<double>(column) * (kCellWidth + kCellGap);
    place(canvas, pictures[i], left, top, row_height);
    const TextStyle style{kTextSize, true, Align::kCentre};
    draw_text(canvas, {left + 0.5 * kCellWidth, top + row_height + 0.5 * kCaptionHeight},
              fitted(canvas, printable(captions[i]), style, kCellWidth), style);
    if (column + 1 == static_cast<std::size_t>(columns)) top += row_height + kCaptionHeight + kCellGap;
  }
  write_whole(out, canvas.finish());
}

}  // namespace tramline::render
