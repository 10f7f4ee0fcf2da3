#pragma once
// A cairo surface that yields the bytes of a picture, and the strokes and fills of which layers consist.

#include <cairo.h>

#include <memory>
#include <string>
#include <vector>

#include "tramline/geometry/path/path.h"
#include "tramline/model/palette.h"
#include "tramline/render/page/page_layout.h"
#include "tramline/render/page/picture_file.h"

namespace tramline::render {

struct DestroyCairo {
  void operator()(cairo_t* cr) const { cairo_destroy(cr); }
  void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
};
using Surface = std::unique_ptr<cairo_surface_t, DestroyCairo>;
using Context = std::unique_ptr<cairo_t, DestroyCairo>;

/// A page of the given size in pixels, filled with the background.
class Canvas {
 public:
  Canvas(PictureFormat format, int width_px, int height_px);
  Canvas(const Canvas&) = delete;
  Canvas& operator=(const Canvas&) = delete;

  cairo_t* cr() const { return context_.get(); }
  const MapView& view() const { return view_; }
  /// Factor on every size of text and map decorations.
  double scale() const { return scale_; }
  void use(const MapView& view, double scale);

  /// Ends the drawing and returns its bytes; nothing can be drawn on the canvas afterwards.
  std::string finish();

 private:
  PictureFormat format_;
  std::string bytes_;  // filled by vector surfaces as they are drawn; must outlive them
  Surface surface_;
  Context context_;
  MapView view_;
  double scale_ = 1;
};

struct Stroke {
  Colour colour;
  double width_px = 1;
  std::vector<double> dashes_px = {};
};

struct Hatch {
  Colour colour;
  double spacing_px = 8;
  double width_px = 1.2;
  bool rising = true;  ///< lines from bottom left to top right
};

/// Shapes in the field's metres.
void fill(Canvas& canvas, const Region& region, Colour colour);
void outline(Canvas& canvas, const Region& region, const Stroke& stroke);
void line(Canvas& canvas, Point from, Point to, const Stroke& stroke);
void curve(Canvas& canvas, const Path& path, const Stroke& stroke);
/// The largest invisible distance of chords from their arcs, m.
double sagitta_m(const MapView& view);
/// Lines at 45° inside the region. Their phase is that of the page, so hatches of neighbouring regions match.
void hatch(Canvas& canvas, const Region& region, const Hatch& style);

/// Shapes in pixels of the page.
void set_colour(Canvas& canvas, Colour colour);
void set_stroke(Canvas& canvas, const Stroke& stroke);
void fill_box(Canvas& canvas, const Box& box, Colour colour);
void hatch_box(Canvas& canvas, const Box& box, const Hatch& style);
void stroke_line(Canvas& canvas, const std::vector<Point>& points, const Stroke& stroke);
void fill_shape(Canvas& canvas, const std::vector<Point>& points, Colour colour);
/// Nothing is drawn outside the box until cairo's state is restored.
void clip_to(Canvas& canvas, const Box& box);
/// The same for a region in the field's metres.
void clip_to(Canvas& canvas, const Region& region);
void disc(Canvas& canvas, Point centre, double radius, Colour colour);

}  // namespace tramline::render
