#include "report/line_card_pages.h"

#include <fmt/format.h>

#include <string>
#include <utility>

#include "report/line_card.h"
#include "tramline/geodesy/field_projection.h"
#include "tramline/io/export/thinned_line.h"
#include "tramline/io/terminal/each_plan.h"
#include "tramline/io/terminal/terminal_field.h"
#include "tramline/render/plan/draw_plan.h"

namespace tramline::app {
namespace {

render::CardLine card_line(const io::TerminalLine& line, const LocalFrame& frame) {
  const FrameProjection projection(frame);
  const Point a = projection.to_lonlat(line.points.front()), b = projection.to_lonlat(line.points.back());
  render::CardLine out{line.name, line.points.front(), line.points.back(), {}};
  out.rows = {"A: " + position_text(a), "B: " + position_text(b)};
  if (line.straight())
    out.rows.push_back(fmt::format("heading {:.4f}° from true north, {:.1f} m long",
                                   io::true_heading_deg(line, frame, a), distance(out.a, out.b)));
  else
    out.rows.emplace_back("a curve: these are its ends only; a display needs its points from a file");
  return out;
}

render::LineCard card_of(const Plan& plan, double tolerance_m, const std::string& file) {
  const io::TerminalField field = io::terminal_field(plan, io::LineChoice::kSubfields, tolerance_m, file);
  render::LineCard out{plan, {}, {}};
  std::vector<CountedFrom> counted_from;
  for (const io::TerminalLine& line : field.lines) {
    out.lines.push_back(card_line(line, field.frame));
    counted_from.push_back({line.name, line.subfield, line.track, out.lines.back().a, out.lines.back().b});
  }
  out.rows = card_rows(plan, counted_from);
  return out;
}

}  // namespace

LineCardReport write_line_cards(const std::vector<std::filesystem::path>& plans, const std::string& field,
                                double tolerance_m, const std::filesystem::path& file) {
  io::require_tolerance(tolerance_m);
  std::vector<render::LineCard> cards;
  LineCardReport out;
  io::for_each_plan(plans, field, [&](const Plan& plan, const std::string& from) {
    cards.push_back(card_of(plan, tolerance_m, from));
    out.lines += cards.back().lines.size();
  });
  out.cards = cards.size();
  render::draw_line_cards(
      cards.size(), [&](std::size_t i) { return std::move(cards[i]); }, file);
  return out;
}

}  // namespace tramline::app
