#include "tramline/render/page/canvas.h"

#include <cairo-pdf.h>
#include <cairo-svg.h>

#include <cmath>
#include <numbers>
#include <string_view>

#include "tramline/geometry/error.h"

namespace tramline::render {
namespace {

// A PDF page of 1600 px is 800 pt wide: it prints on A4 landscape without being scaled.
constexpr double kPointsPerPixel = 0.5;

cairo_status_t append(void* bytes, const unsigned char* data, unsigned int length) {
  static_cast<std::string*>(bytes)->append(reinterpret_cast<const char*>(data), length);
  return CAIRO_STATUS_SUCCESS;
}

cairo_surface_t* make_pdf(std::string& bytes, int width_px, int height_px) {
  cairo_surface_t* surface = cairo_pdf_surface_create_for_stream(append, &bytes, width_px * kPointsPerPixel,
                                                                 height_px * kPointsPerPixel);
  const std::string date = picture_date();
  cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_CREATE_DATE, date.c_str());
  cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_MOD_DATE, date.c_str());
  cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_CREATOR, "tramline");
  return surface;
}

cairo_surface_t* make_svg(std::string& bytes, int width_px, int height_px) {
  cairo_surface_t* surface = cairo_svg_surface_create_for_stream(append, &bytes, width_px, height_px);
  cairo_svg_surface_set_document_unit(surface, CAIRO_SVG_UNIT_PX);
  return surface;
}

cairo_surface_t* make_surface(PictureFormat format, std::string& bytes, int width_px, int height_px) {
  switch (format) {
    case PictureFormat::kPdf:
      return make_pdf(bytes, width_px, height_px);
    case PictureFormat::kSvg:
      return make_svg(bytes, width_px, height_px);
    case PictureFormat::kPng:
      break;
  }
  return cairo_image_surface_create(CAIRO_FORMAT_RGB24, width_px, height_px);
}

void require(cairo_status_t status) {
  if (status != CAIRO_STATUS_SUCCESS)
    throw failure(std::string("the picture could not be drawn: ") + cairo_status_to_string(status));
}

// cairo numbers its surfaces over the whole life of the process, and writes the number into the file.
std::string without_surface_numbers(const std::string& svg) {
  constexpr std::string_view kNumbered = "id=\"surface";
  std::string out;
  std::size_t at = 0;
  for (std::size_t hit = 0; (hit = svg.find(kNumbered, at)) != std::string::npos;) {
    hit += kNumbered.size();
    out.append(svg, at, hit - at);
    at = svg.find_first_not_of("0123456789", hit);
  }
  return out.append(svg, at);
}

// The chords of arcs are as short as areas ask for: hundreds of them may lie within a pixel, and made the
// greater part of a vector picture. Rings of few vertices are drawn as they are, however small.
constexpr std::size_t kManyVertices = 250;
constexpr double kNearby = 0.2;  // px

void add_ring(Canvas& canvas, const Ring& ring) {
  cairo_t* cr = canvas.cr();
  const double least_step = ring.size() > kManyVertices ? kNearby : 0;
  bool first = true;
  Point last;
  for (const Point p : ring) {
    const Point q = canvas.view().to_page(p);
    if (!first && distance(last, q) < least_step) continue;
    first ? cairo_move_to(cr, q.x, q.y) : cairo_line_to(cr, q.x, q.y);
    first = false;
    last = q;
  }
  if (!ring.empty()) cairo_close_path(cr);
}

void add_region(Canvas& canvas, const Region& region) {
  cairo_new_path(canvas.cr());
  for (const Polygon& polygon : region) {
    add_ring(canvas, polygon.outer);
    for (const Ring& hole : polygon.holes) add_ring(canvas, hole);
  }
}

void add_points(Canvas& canvas, const std::vector<Point>& points) {
  cairo_new_path(canvas.cr());
  for (const Point p : points) cairo_line_to(canvas.cr(), p.x, p.y);
}

// Diagonals over a box of the page; the caller has set the clip.
void draw_diagonals(Canvas& canvas, const Box& box, const Hatch& style) {
  cairo_t* cr = canvas.cr();
  const double step = style.spacing_px * std::numbers::sqrt2 * canvas.scale();
  // Each diagonal is x + y = c (rising, y points down) or x − y = c.
  const double low = style.rising ? box.min_x + box.min_y : box.min_x - box.max_y;
  const double high = style.rising ? box.max_x + box.max_y : box.max_x - box.min_y;
  cairo_new_path(cr);
  for (double c = std::ceil(low / step) * step; c <= high; c += step) {
    cairo_move_to(cr, box.min_x, style.rising ? c - box.min_x : box.min_x - c);
    cairo_line_to(cr, box.max_x, style.rising ? c - box.max_x : box.max_x - c);
  }
  set_stroke(canvas, {style.colour, style.width_px * canvas.scale()});
  cairo_stroke(cr);
}

}  // namespace

Canvas::Canvas(PictureFormat format, int width_px, int height_px)
    : format_(format),
      surface_(make_surface(format, bytes_, width_px, height_px)),
      context_(cairo_create(surface_.get())) {
  require(cairo_status(cr()));
  if (format == PictureFormat::kPdf) cairo_scale(cr(), kPointsPerPixel, kPointsPerPixel);
  cairo_set_line_join(cr(), CAIRO_LINE_JOIN_ROUND);
  cairo_set_fill_rule(cr(), CAIRO_FILL_RULE_EVEN_ODD);
  set_colour(*this, kBackgroundColour);
  cairo_paint(cr());
}

void Canvas::use(const MapView& view, double scale) {
  view_ = view;
  scale_ = scale;
}

std::string Canvas::finish() {
  require(cairo_status(cr()));
  if (format_ == PictureFormat::kPng) {
    require(cairo_surface_write_to_png_stream(surface_.get(), append, &bytes_));
  } else {
    cairo_show_page(cr());
    cairo_surface_finish(surface_.get());
    require(cairo_surface_status(surface_.get()));
  }
  return format_ == PictureFormat::kSvg ? without_surface_numbers(bytes_) : bytes_;
}

void set_colour(Canvas& canvas, Colour colour) {
  cairo_set_source_rgba(canvas.cr(), colour.red, colour.green, colour.blue, colour.opacity);
}

void set_stroke(Canvas& canvas, const Stroke& stroke) {
  set_colour(canvas, stroke.colour);
  cairo_set_line_width(canvas.cr(), stroke.width_px);
  cairo_set_dash(canvas.cr(), stroke.dashes_px.data(), static_cast<int>(stroke.dashes_px.size()), 0);
}

void fill(Canvas& canvas, const Region& region, Colour colour) {
  add_region(canvas, region);
  set_colour(canvas, colour);
  cairo_fill(canvas.cr());
}

void outline(Canvas& canvas, const Region& region, const Stroke& stroke) {
  add_region(canvas, region);
  set_stroke(canvas, stroke);
  cairo_stroke(canvas.cr());
}

void line(Canvas& canvas, Point from, Point to, const Stroke& stroke) {
  stroke_line(canvas, {canvas.view().to_page(from), canvas.view().to_page(to)}, stroke);
}

void curve(Canvas& canvas, const Path& path, const Stroke& stroke) {
  std::vector<Point> points = chords(path, sagitta_m(canvas.view()));
  for (Point& p : points) p = canvas.view().to_page(p);
  stroke_line(canvas, points, stroke);
}

double sagitta_m(const MapView& view) {
  constexpr double kInvisible = 0.05;  // px
  return kInvisible / view.px_per_m;
}

void hatch(Canvas& canvas, const Region& region, const Hatch& style) {
  if (region.empty()) return;
  const Box world = bounds(region);
  const Point low = canvas.view().to_page({world.min_x, world.max_y});
  const Point high = canvas.view().to_page({world.max_x, world.min_y});
  cairo_save(canvas.cr());
  add_region(canvas, region);
  cairo_clip(canvas.cr());
  draw_diagonals(canvas, {low.x, low.y, high.x, high.y}, style);
  cairo_restore(canvas.cr());
}

void fill_box(Canvas& canvas, const Box& box, Colour colour) {
  cairo_new_path(canvas.cr());
  cairo_rectangle(canvas.cr(), box.min_x, box.min_y, box.width(), box.height());
  set_colour(canvas, colour);
  cairo_fill(canvas.cr());
}

void hatch_box(Canvas& canvas, const Box& box, const Hatch& style) {
  cairo_save(canvas.cr());
  cairo_new_path(canvas.cr());
  cairo_rectangle(canvas.cr(), box.min_x, box.min_y, box.width(), box.height());
  cairo_clip(canvas.cr());
  draw_diagonals(canvas, box, style);
  cairo_restore(canvas.cr());
}

void stroke_line(Canvas& canvas, const std::vector<Point>& points, const Stroke& stroke) {
  add_points(canvas, points);
  set_stroke(canvas, stroke);
  cairo_stroke(canvas.cr());
}

void fill_shape(Canvas& canvas, const std::vector<Point>& points, Colour colour) {
  add_points(canvas, points);
  cairo_close_path(canvas.cr());
  set_colour(canvas, colour);
  cairo_fill(canvas.cr());
}

void clip_to(Canvas& canvas, const Box& box) {
  cairo_new_path(canvas.cr());
  cairo_rectangle(canvas.cr(), box.min_x, box.min_y, box.width(), box.height());
  cairo_clip(canvas.cr());
}

void clip_to(Canvas& canvas, const Region& region) {
  add_region(canvas, region);
  cairo_clip(canvas.cr());
}

void disc(Canvas& canvas, Point centre, double radius, Colour colour) {
  cairo_new_path(canvas.cr());
  cairo_arc(canvas.cr(), centre.x, centre.y, radius, 0, 2 * std::numbers::pi);
  set_colour(canvas, colour);
  cairo_fill(canvas.cr());
}

}  // namespace tramline::render
