#pragma once
// Text on a canvas, in DejaVu Sans.

#include <string>

#include "tramline/render/page/canvas.h"

namespace tramline::render {

inline constexpr double kTextSize = 16;
inline constexpr double kSmallTextSize = 14;  ///< the least size of any text

enum class Align { kLeft, kCentre, kRight };

struct TextStyle {
  double size = kTextSize;  ///< px at text scale 1
  bool bold = false;
  Align align = Align::kLeft;
  Colour colour = kInk;
  bool halo = false;  ///< a white rim that keeps the text readable over lines
};

/// Draws text with its capital letters centred on at.y.
void draw_text(Canvas& canvas, Point at, const std::string& text, const TextStyle& style);

/// Width on the page, px.
double text_width(Canvas& canvas, const std::string& text, const TextStyle& style);

/// The text, cut and ended with "…" where it would be wider than width_px.
std::string fitted(Canvas& canvas, const std::string& text, const TextStyle& style, double width_px);

/// The text as valid UTF-8 without control characters; invalid bytes and control characters become "?".
std::string printable(const std::string& text);

}  // namespace tramline::render
