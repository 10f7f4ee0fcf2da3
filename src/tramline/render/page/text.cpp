#include "tramline/render/page/text.h"

#include <cstdint>

// Fontconfig keeps what it read for the life of the process, and cairo never gives it back: builds that
// look for leaks are told, in every program that draws text.
#if defined(__SANITIZE_ADDRESS__)
extern "C" {
const char* __lsan_default_suppressions();
const char* __lsan_default_options();
const char* __lsan_default_suppressions() { return "leak:libfontconfig"; }
const char* __lsan_default_options() { return "print_suppressions=0"; }
}
#endif

namespace tramline::render {
namespace {

// Height of DejaVu Sans's capitals in terms of its size.
constexpr double kCapitalHeight = 0.729;

void select_font(Canvas& canvas, const TextStyle& style) {
  cairo_t* cr = canvas.cr();
  cairo_select_font_face(cr, "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL,
                         style.bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(cr, style.size * canvas.scale());
  // Unhinted: glyphs have the same widths in every format.
  cairo_font_options_t* options = cairo_font_options_create();
  cairo_font_options_set_antialias(options, CAIRO_ANTIALIAS_GRAY);
  cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
  cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
  cairo_set_font_options(cr, options);
  cairo_font_options_destroy(options);
}

// Length of the UTF-8 sequence at `at`, 0 where there is no valid one.
std::size_t sequence_length(const std::string& text, std::size_t at) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char lead = byte(at);
  const std::size_t n = lead < 0x80   ? 1
                        : lead < 0xC0 ? 0
                        : lead < 0xE0 ? 2
                        : lead < 0xF0 ? 3
                        : lead < 0xF8 ? 4
                                      : 0;
  if (n == 0 || at + n > text.size()) return 0;
  std::uint32_t code = n == 1 ? lead : lead & (0xFFu >> (n + 1));
  for (std::size_t i = 1; i < n; ++i) {
    if ((byte(at + i) & 0xC0) != 0x80) return 0;
    code = (code << 6) | (byte(at + i) & 0x3Fu);
  }
  constexpr std::uint32_t kLeast[] = {0, 0, 0x80, 0x800, 0x10000};
  const bool surrogate = code >= 0xD800 && code <= 0xDFFF;
  return code < kLeast[n] || code > 0x10FFFF || surrogate ? 0 : n;
}

}  // namespace

std::string printable(const std::string& text) {
  std::string out;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t n = sequence_length(text, at);
    const auto byte = static_cast<unsigned char>(text[at]);
    if (n == 0 || byte < 0x20 || byte == 0x7F) {
      out += '?';
      ++at;
    } else {
      out.append(text, at, n);
      at += n;
    }
  }
  return out;
}

double text_width(Canvas& canvas, const std::string& text, const TextStyle& style) {
  select_font(canvas, style);
  cairo_text_extents_t extents;
  cairo_text_extents(canvas.cr(), text.c_str(), &extents);
  return extents.x_advance;
}

std::string fitted(Canvas& canvas, const std::string& text, const TextStyle& style, double width_px) {
  if (text_width(canvas, text, style) <= width_px) return text;
  std::string head = text;
  while (!head.empty()) {
    // Whole characters only: a UTF-8 sequence's following bytes are 10xxxxxx.
    while (!head.empty() && (static_cast<unsigned char>(head.back()) & 0xC0) == 0x80) head.pop_back();
    if (!head.empty()) head.pop_back();
    if (text_width(canvas, head + "…", style) <= width_px) break;
  }
  return head + "…";
}

void draw_text(Canvas& canvas, Point at, const std::string& text, const TextStyle& style) {
  const double width = text_width(canvas, text, style);
  const double x = style.align == Align::kLeft    ? at.x
                   : style.align == Align::kRight ? at.x - width
                                                  : at.x - 0.5 * width;
  const double baseline = at.y + 0.5 * kCapitalHeight * style.size * canvas.scale();
  cairo_t* cr = canvas.cr();
  if (style.halo) {
    cairo_new_path(cr);
    cairo_move_to(cr, x, baseline);
    cairo_text_path(cr, text.c_str());
    set_stroke(canvas, {rgb(kBackgroundHex, 0.9), 4.5 * canvas.scale()});
    cairo_stroke(cr);
  }
  set_colour(canvas, style.colour);
  cairo_move_to(cr, x, baseline);
  cairo_show_text(cr, text.c_str());
}

}  // namespace tramline::render
